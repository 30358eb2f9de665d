//! Bands that hold 16-bit colours, without a palette.

use fixel::render::Bands;
use fixel::scene::Dither;
use fixel::{Band, Scene, Scratch};
use fixel_bake::{Problem, bake, bake_for_rays};
use fixel_host::Options;
use fixel_tests::{load, root};

/// A scene of the repository as it is without a palette.
fn without_palette(name: &str) -> fixel_scene::Scene {
    let (mut scene, _) = load(&root().join(format!("scenes/{name}.toml")));
    scene.palette = fixel_scene::Palette {
        direct: true,
        ..fixel_scene::Palette::default()
    };
    scene
}

/// PSNR of a scene's colours against the unquantised truth, by whatever way it has.
fn true_db(scene: &fixel_scene::Scene) -> f64 {
    let baked = bake(scene).unwrap_or_else(|e| panic!("{e}"));
    let core = baked.scene().expect("baked a moment ago");
    let options = Options::of(&core);
    let at = fixel_reference::Options {
        width: options.width.into(),
        height: options.height.into(),
        frame: options.frame,
    };
    let truth = fixel_reference::render(scene, at);
    let (frame, _) = fixel_host::frame(&baked, &core, &options);
    let report = fixel_reference::compare(&truth, &frame).expect("the same size");
    assert!(report.coverage_mismatch_px <= 1);
    report.rgb_psnr_true_db
}

/// Whatever draws pixels: surfaces by level and by colour, textures, lines and texts, screen
/// doors, panes, fog, viewports. What 16 bits leave is 42 dB; what is rounded twice,
/// a pane or fog over a colour, or has a texture of 64 base colours, is less.
#[test]
fn colours_are_as_they_are_lit() {
    let mut low = Vec::new();
    for (name, least) in [
        ("teapot", 41.0),
        ("spot", 41.0),
        ("vertex_colours", 41.0),
        ("hidden_line", 41.0),
        ("lines_in_colour", 41.0),
        ("lines_markers_text", 41.0),
        ("screen_door", 41.0),
        ("viewports", 41.0),
        ("blend", 40.0),
        ("fog_exponential", 40.0),
        ("textured_bilinear", 40.0),
    ] {
        let db = true_db(&without_palette(name));
        if db < least {
            low.push(format!("{name} at {db:.2} dB"));
        }
    }
    assert!(low.is_empty(), "{low:?}");
    // Through 256 entries it is 33 dB.
    let (spot, _) = load(&root().join("scenes/spot.toml"));
    assert!(true_db(&without_palette("spot")) > true_db(&spot) + 6.0);
}

fn colours<const M: usize, const S: usize>(scene: &Scene<'_>, rows: u16) -> (Vec<u16>, Vec<u16>) {
    let width = scene.frame_width();
    let pixels = usize::from(width) * usize::from(rows);
    let (mut colours, mut depths) = (vec![0; pixels], vec![0; pixels]);
    let mut band = Band::new(width, &mut colours, &mut depths).expect("one row at least");
    let mut scratch = Box::new(Scratch::<M, S, 4>::new());
    let (mut work, pose) = (scratch.workspace(), scene.pose(3));
    let bands = Bands::direct(scene, &pose, scene.dither(), &mut work, &mut band);
    let mut bands = bands.expect("baked without a palette");
    let mut all = (Vec::new(), Vec::new());
    while let Some(rows) = bands.next() {
        all.0.extend(rows.indices);
        all.1.extend(rows.depths);
    }
    all
}

#[test]
fn no_capacity_and_no_band_height_changes_a_byte() {
    for name in ["direct", "direct_fog"] {
        let (_, baked) = load(&root().join(format!("scenes/{name}.toml")));
        let scene = baked.scene().expect("baked a moment ago");
        let whole = colours::<4096, 64>(&scene, scene.frame_height());
        for rows in [1, 7, 16] {
            assert!(
                colours::<1, 1>(&scene, rows) == whole,
                "{name}, {rows} rows"
            );
        }
    }
}

#[test]
fn a_scene_with_a_palette_is_refused() {
    let (_, baked) = load(&root().join("scenes/teapot.toml"));
    let scene = baked.scene().expect("baked a moment ago");
    let (mut colours, mut depths) = (vec![0u16; 320], vec![0; 320]);
    let mut band = Band::new(320, &mut colours, &mut depths).expect("one row");
    let mut scratch = Box::new(Scratch::<8, 1, 1>::new());
    let (mut work, pose) = (scratch.workspace(), scene.pose(0));
    assert!(Bands::direct(&scene, &pose, Dither::NONE, &mut work, &mut band).is_none());
}

#[test]
fn what_needs_a_palette_is_refused() {
    let refused = |result: Result<_, fixel_bake::BakeError>| {
        matches!(result.map_err(|e| e.problem), Err(Problem::NotYet { .. }))
    };
    assert!(refused(bake(&without_palette("palette_cycle"))));
    assert!(refused(bake(&without_palette("antialiased"))));
    assert!(refused(bake(&without_palette("stereo_anaglyph"))));
    assert!(refused(bake(&without_palette("mono_teapot"))));
    assert!(refused(bake_for_rays(&without_palette("teapot"))));
    assert!(!refused(bake(&without_palette("teapot"))));
}
