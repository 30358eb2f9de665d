//! Each figure of a comparison moves when its error is put in, and only then.

mod common;

use common::*;
use fixel_reference::{
    COLOURS, Frame, FrameError, Lookup, MismatchKind, NO_TRIANGLE, PSNR_IDENTICAL_DB, Path, Report,
    Truth, compare, heatmap,
};
use fixel_scene::Shading;

/// 256 greys for a square picture; the background is colour 0.
fn greys(side: u32) -> Lookup {
    Lookup {
        direct: false,
        palette: (0..=255).map(|v| [v; 3]).collect(),
        paths: vec![Path::Level(Box::new(std::array::from_fn(|level| {
            level as u8
        })))],
        colours: Vec::new(),
        fog: Vec::new(),
        background: vec![0; (side * side) as usize],
    }
}

/// A palette of 4 levels of red and green and 2 of blue, by colour; the background
/// is black.
fn by_colour(pixels: usize) -> Lookup {
    let colour = |i: usize| [(i >> 3) * 85, (i >> 1 & 3) * 85, (i & 1) * 255];
    let nearest = |i: usize| {
        let part = |shift: usize, most: usize| ((i >> shift & 15) * most + 7) / 15;
        (part(8, 3) << 3 | part(4, 3) << 1 | part(0, 1)) as u8
    };
    Lookup {
        direct: false,
        palette: (0..32).map(|i| colour(i).map(|c| c as u8)).collect(),
        paths: vec![Path::Colour],
        colours: (0..COLOURS).map(nearest).collect(),
        fog: Vec::new(),
        background: vec![0; pixels],
    }
}

/// A lit ball before a rectangle; 16 by 16 pixels, none of the outermost two
/// rings covered.
fn ball() -> Truth {
    let mut scene = parallel(16, 16);
    scene.materials[0].shading = Shading::Gouraud;
    scene.lights = vec![white_light([-0.3, -1.0, -0.5])];
    add(&mut scene, sphere(5.0, 24, 12)).position = [8.0, -8.0, 0.0];
    add(&mut scene, screen_rect([2.0, 6.0], [14.0, 12.0], -5.5));
    truth(&scene)
}

/// The report about the best possible frame after `damage`.
fn damaged(damage: impl FnOnce(&mut Frame)) -> Report {
    let truth = ball();
    let mut frame = Frame::from_truth(&truth, greys(16));
    damage(&mut frame);
    compare(&truth, &frame).unwrap()
}

/// The ball's middle, which is covered by actor 0.
const MIDDLE: usize = 8 * 16 + 8;
/// A pixel of the rectangle.
const BEHIND: usize = 8 * 16 + 2;

#[test]
fn the_best_frame_has_only_rounding_errors() {
    let report = damaged(|_| ());
    assert_eq!((report.width, report.height), (16, 16));
    assert_eq!(report.covered_px, ball().covered_px());
    assert_eq!(report.agreeing_px, report.covered_px);
    assert_eq!(
        (report.coverage_mismatch_px, report.visible_mismatch_px),
        (0, 0)
    );
    assert!(report.depth_max_lsb <= 0.5 && report.depth_max_lsb > 0.3);
    assert!(report.depth_mean_lsb < 0.3 && report.depth_mean_lsb > 0.1);
    assert!(report.level_max <= 0.5 && report.level_mean < 0.3);
    assert_eq!(report.rgb_psnr_db, PSNR_IDENTICAL_DB);
    // No error exceeds 0.5 of 255.
    assert!(report.rgb_psnr_true_covered_db > 54.15 && report.rgb_psnr_true_covered_db < 70.0);
    assert!(report.rgb_psnr_true_db > report.rgb_psnr_true_covered_db);
    assert_eq!(report.index_equal_percent, 100.0);
    assert_eq!(report.depth_within_1_percent, 100.0);
    assert_eq!(report.level_within_2_percent, 100.0);
    assert!(report.mismatches.is_empty());
}

#[test]
fn a_missing_and_an_extra_pixel_count_as_coverage() {
    let report = damaged(|frame| {
        frame.actor[MIDDLE] = 0;
        frame.triangle[MIDDLE] = NO_TRIANGLE;
        frame.depth[MIDDLE] = 0;
        (frame.actor[0], frame.triangle[0], frame.depth[0]) = (2, 1, 700);
    });
    assert_eq!(
        (report.coverage_mismatch_px, report.visible_mismatch_px),
        (2, 0)
    );
    assert_eq!(report.agreeing_px, report.covered_px - 1);
    let wanted = 200.0 / report.covered_px as f64;
    assert!((report.coverage_mismatch_percent - wanted).abs() < 1e-9);
    let [extra, missing] = &report.mismatches[..] else {
        panic!("{:?}", report.mismatches)
    };
    assert_eq!((extra.x, extra.y, extra.kind), (0, 0, MismatchKind::Extra));
    assert_eq!((extra.truth, extra.frame), (None, Some([1, 1])));
    assert_eq!((extra.truth_depth_lsb, extra.frame_depth_lsb), (0.0, 700));
    assert_eq!(
        (missing.x, missing.y, missing.kind),
        (8, 8, MismatchKind::Missing)
    );
    assert_eq!(missing.frame, None);
    assert!(report.depth_max_lsb <= 0.5);
}

#[test]
fn depth_errors_are_found_where_they_are() {
    let before = damaged(|_| ());
    let report = damaged(|frame| frame.depth[MIDDLE] -= 40);
    assert!((report.depth_max_lsb - 40.0).abs() <= 0.5);
    assert_eq!(report.depth_max_at, Some([8, 8]));
    let moved = (report.depth_mean_lsb - before.depth_mean_lsb) * report.covered_px as f64;
    assert!((moved - 40.0).abs() <= 1.0);
    let wanted = 100.0 - 100.0 / report.covered_px as f64;
    assert!((report.depth_within_1_percent - wanted).abs() < 1e-9);
    assert_eq!(report.level_max, before.level_max);
}

#[test]
fn another_triangle_is_a_visible_mismatch() {
    // The rectangle behind the ball shows through.
    let hidden = damaged(|frame| (frame.actor[MIDDLE], frame.triangle[MIDDLE]) = (2, 0));
    // A triangle that does not cover the pixel at all.
    let elsewhere = damaged(|frame| frame.triangle[MIDDLE] = 0);
    // One that does not exist.
    let unknown = damaged(|frame| frame.triangle[MIDDLE] = 1_000_000);
    for report in [hidden, elsewhere, unknown] {
        assert_eq!(
            (report.coverage_mismatch_px, report.visible_mismatch_px),
            (0, 1)
        );
        assert_eq!(report.agreeing_px, report.covered_px - 1);
        assert_eq!(report.mismatches[0].kind, MismatchKind::Visible);
    }
}

#[test]
fn equally_near_triangles_are_a_tie() {
    for (apart, visible) in [(0.0, 0), (0.9, 0), (1.1, 16)] {
        let mut scene = parallel(4, 4);
        let lsb = (RANGE[1] - RANGE[0]) / 65535.0;
        add(&mut scene, screen_rect([-9.0; 2], [9.0; 2], 0.0));
        add(&mut scene, screen_rect([-9.0; 2], [9.0; 2], -apart * lsb));
        let truth = truth(&scene);
        let mut frame = Frame::from_truth(&truth, greys(4));
        frame.actor.fill(2);
        let report = compare(&truth, &frame).unwrap();
        assert_eq!(report.visible_mismatch_px, visible, "{apart} apart");
        assert_eq!(report.agreeing_px, 0);
        assert_eq!((report.depth_max_lsb, report.depth_max_at), (0.0, None));
    }
}

#[test]
fn level_errors_are_found_where_they_are() {
    let report = damaged(|frame| frame.light[MIDDLE] = frame.light[MIDDLE].map(|l| l + 10));
    assert!((report.level_max - 10.0).abs() <= 0.5);
    assert_eq!(report.level_max_at, Some([8, 8]));
    assert!(report.level_mean * report.covered_px as f64 > 9.0);
    let wanted = 100.0 - 100.0 / report.covered_px as f64;
    assert!((report.level_within_2_percent - wanted).abs() < 1e-9);
    assert_eq!(report.rgb_psnr_db, PSNR_IDENTICAL_DB);
}

#[test]
fn colour_errors_move_both_psnr() {
    // One channel of one pixel of 256, background too, off by 100: a mean
    // square of 100^2 / 768.
    let wanted = 10.0 * (255.0_f64.powi(2) * 768.0 / 100.0_f64.powi(2)).log10();
    for pixel in [0, MIDDLE] {
        let report = damaged(|frame| {
            let channel = &mut frame.rgb[pixel][1];
            *channel = if *channel < 128 {
                *channel + 100
            } else {
                *channel - 100
            };
        });
        assert!((report.rgb_psnr_db - wanted).abs() < 1e-9);
        assert!((report.rgb_psnr_true_db - wanted).abs() < 0.2);
        assert_eq!(report.index_equal_percent, 100.0);
    }
    let report = damaged(|frame| frame.rgb[0][1] = 255);
    assert!((report.rgb_psnr_db - 10.0 * 768.0_f64.log10()).abs() < 1e-9);
    assert!(report.rgb_psnr_true_covered_db > 50.0);
}

#[test]
fn the_quantised_psnr_forgives_the_palette_and_the_true_one_does_not() {
    let truth = ball();
    let mut lookup = greys(16);
    // Levels in steps of 32, and a background that the scene does not have.
    let steps = std::array::from_fn(|level| (level / 32 * 32) as u8);
    lookup.paths[0] = Path::Level(Box::new(steps));
    lookup.background[3 * 16] = 99;
    let frame = Frame::from_truth(&truth, lookup);
    let report = compare(&truth, &frame).unwrap();
    assert_eq!(report.rgb_psnr_db, PSNR_IDENTICAL_DB);
    assert!(report.rgb_psnr_true_db < 30.0);
    assert_eq!(frame.rgb[3 * 16], [99; 3]);
}

#[test]
fn a_material_by_colour_is_looked_up_by_colour() {
    let mut scene = parallel(2, 1);
    scene.materials[0].diffuse_colour = [0.49, 0.51, 1.0];
    scene.lights = vec![white_light([0.0, 0.0, -1.0])];
    scene.lights[0].colour = [1.0, 1.0, 0.45];
    add(&mut scene, screen_rect([0.0, 0.0], [1.0, 1.0], 0.0));
    let truth = truth(&scene);
    // 0.49 and 0.51 are 7 and 8 of 15, which are 1 and 2 of 3; 0.45 is 7 of 15.
    let frame = Frame::from_truth(&truth, by_colour(2));
    assert_eq!(frame.rgb, [[85, 170, 0], [0; 3]]);
    assert_eq!(frame.light[0], [125, 130, 115]);
    let report = compare(&truth, &frame).unwrap();
    assert_eq!(report.rgb_psnr_db, PSNR_IDENTICAL_DB);
    assert_eq!(report.index_equal_percent, 100.0);
    // The worst channel counts: 0.45 of 255 is 114.75.
    assert!((report.level_max - 0.25).abs() < 1e-9);
    let mut off = frame.clone();
    off.light[0][1] += 7;
    off.light[0][2] -= 30;
    let report = compare(&truth, &off).unwrap();
    assert!((report.level_max - 29.75).abs() < 1e-9);
    assert_eq!(report.level_max_at, Some([0, 0]));
}

#[test]
fn index_errors_count_where_something_is_seen() {
    let background = damaged(|frame| frame.index[0] = 77);
    assert_eq!(background.index_equal_percent, 100.0);
    let report = damaged(|frame| frame.index[BEHIND] ^= 1);
    let wanted = 100.0 - 100.0 / report.covered_px as f64;
    assert!((report.index_equal_percent - wanted).abs() < 1e-9);
}

#[test]
fn at_most_20_mismatches_are_listed() {
    let report = damaged(|frame| frame.actor.fill(0));
    assert_eq!(report.coverage_mismatch_px, report.covered_px);
    assert_eq!(report.mismatches.len(), 20);
}

#[test]
fn frames_that_do_not_fit_are_refused() {
    let truth = ball();
    let good = Frame::from_truth(&truth, greys(16));
    let refused = |damage: &dyn Fn(&mut Frame)| {
        let mut frame = good.clone();
        damage(&mut frame);
        compare(&truth, &frame).unwrap_err().to_string()
    };
    assert_eq!(
        refused(&|f| f.width = 8),
        "the frame is 8x16 pixels, the reference 16x16"
    );
    let short = refused(&|f| f.light.truncate(255));
    assert_eq!(short, "the frame's light has 255 elements instead of 256");
    let shade = refused(&|f| f.lookup.paths.clear());
    assert_eq!(shade, "the frame's paths has 0 elements instead of 1");
    let colours = refused(&|f| f.lookup.paths[0] = Path::Colour);
    assert_eq!(
        colours,
        "the frame's colours has 0 elements instead of 4096"
    );
    let colours = refused(&|f| f.lookup.colours = vec![0; 256]);
    assert_eq!(
        colours,
        "the frame's colours has 256 elements instead of 4096"
    );
    let colour = refused(&|f| f.lookup.palette.truncate(200));
    assert_eq!(colour, "the look-up names colour 200 of a palette of 200");
    let error = FrameError::Size {
        truth: (1, 1),
        frame: (2, 2),
    };
    assert!(!error.to_string().contains('\n'));
}

#[test]
fn the_report_is_json_with_stable_names() {
    let report = damaged(|frame| frame.actor[MIDDLE] = 0);
    let json = serde_json::to_value(&report).unwrap();
    for field in [
        "width",
        "height",
        "covered_px",
        "coverage_mismatch_px",
        "depth_max_lsb",
        "depth_mean_lsb",
        "visible_mismatch_px",
        "level_max",
        "level_mean",
        "rgb_psnr_db",
        "rgb_psnr_true_db",
        "index_equal_percent",
    ] {
        assert!(json[field].is_number(), "{field}");
    }
    assert_eq!(json["mismatches"][0]["kind"], "missing");
    assert_eq!(serde_json::from_value::<Report>(json).unwrap(), report);
}

#[test]
fn heat_maps_show_each_error_in_its_place() {
    let truth = ball();
    let clean = Frame::from_truth(&truth, greys(16));
    let maps = heatmap::draw(&truth, &clean).unwrap();
    let agree = maps.coverage[MIDDLE];
    let mut frame = clean.clone();
    frame.actor[MIDDLE] = 0;
    frame.actor[0] = 1;
    frame.triangle[MIDDLE + 1] = 0;
    frame.depth[BEHIND] += 4;
    frame.light[BEHIND] = frame.light[BEHIND].map(|l| l.wrapping_add(100));
    frame.rgb[1] = [0, 16, 0];
    let damaged = heatmap::draw(&truth, &frame).unwrap();
    let differing = |a: &[[u8; 3]], b: &[[u8; 3]]| -> Vec<usize> {
        (0..256).filter(|i| a[*i] != b[*i]).collect()
    };
    let coverage = &damaged.coverage;
    assert_eq!(differing(&maps.coverage, coverage), [0, MIDDLE, MIDDLE + 1]);
    assert_eq!(coverage[BEHIND], agree);
    assert_eq!(
        [coverage[0][2], coverage[MIDDLE][2], coverage[MIDDLE + 1][2]],
        [255, 40, 0]
    );
    assert!(differing(&maps.depth, &damaged.depth).contains(&BEHIND));
    assert_eq!(damaged.level[BEHIND], [255; 3]);
    assert_eq!(damaged.colour[1], [255, 128, 0]);
    assert_eq!(differing(&maps.colour, &damaged.colour), [1]);
}
