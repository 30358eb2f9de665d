//! A viewport is a screen of its own: what it shows does not depend on where it
//! lies, nor on what else there is.

use fixel::scene::Camera;
use fixel_host::{Options, Planes, render};
use fixel_scene::{Aspect, Background, Scene, Viewport};
use fixel_tests::root;

fn teapot() -> Scene {
    fixel_scene::load(&root().join("scenes/teapot.toml")).unwrap_or_else(|e| panic!("{e}"))
}

fn viewport(rectangle: [f64; 4]) -> Viewport {
    Viewport {
        rectangle,
        camera: None,
        background: None,
        aspect: Aspect::Keep,
    }
}

fn drawn(scene: &Scene, size: Option<(u16, u16)>) -> Planes {
    let baked = fixel_bake::bake(scene).unwrap_or_else(|e| panic!("{e}"));
    let core = baked.scene().expect("baked a moment ago");
    let mut options = Options {
        band_rows: Some(16),
        ..Options::of(&core)
    };
    if let Some((width, height)) = size {
        (options.width, options.height) = (width, height);
    }
    render(&core, &options)
}

/// Indices and depths of a part of a picture 320 pixels wide.
fn part(planes: &Planes, columns: std::ops::Range<usize>, rows: std::ops::Range<usize>) -> Planes {
    let place = |y: usize| y * 320 + columns.start..y * 320 + columns.end;
    Planes {
        index: rows
            .clone()
            .flat_map(|y| planes.index[place(y)].to_vec())
            .collect(),
        depth: rows
            .clone()
            .flat_map(|y| planes.depth[place(y)].to_vec())
            .collect(),
        size: planes.size,
        frame: 0,
        camera: None,
        stats: planes.stats,
    }
}

fn assert_same(a: &Planes, b: &Planes, what: &str) {
    assert!(a.depth.iter().any(|d| *d != 0), "{what}: empty");
    assert!(a.index == b.index && a.depth == b.depth, "{what} differs");
}

#[test]
fn each_part_is_what_a_screen_of_its_size_shows() {
    let plain = teapot();
    let mut scene = plain.clone();
    // Odd sides, an overlap, and a part of the picture that no viewport covers.
    scene.viewports = vec![
        viewport([0.0, 0.0, 0.5, 1.0]),
        viewport([0.53125, 0.3, 0.4, 0.7]),
        viewport([0.25, 0.2, 0.3, 0.3125]),
    ];
    scene.display.background = Background::Solid([0.1, 0.2, 0.3]);
    let mut plain = plain;
    plain.display.background = scene.display.background;
    let all = drawn(&scene, None);
    let inset = drawn(&plain, Some((96, 75)));
    assert_same(&part(&all, 80..176, 117..192), &inset, "the inset");
    let right = drawn(&plain, Some((128, 168)));
    assert_same(
        &part(&all, 176..298, 0..168),
        &{
            let columns = |row: &[u8]| row[6..].to_vec();
            Planes {
                index: right.index.chunks(128).flat_map(columns).collect(),
                depth: right
                    .depth
                    .chunks(128)
                    .flat_map(|r| r[6..].to_vec())
                    .collect(),
                size: right.size,
                frame: 0,
                camera: None,
                stats: right.stats,
            }
        },
        "the right part",
    );
    let left = drawn(&plain, Some((160, 240)));
    let above = Planes {
        index: left.index[..160 * 117].to_vec(),
        depth: left.depth[..160 * 117].to_vec(),
        size: left.size,
        frame: 0,
        camera: None,
        stats: left.stats,
    };
    assert_same(&part(&all, 0..160, 0..117), &above, "above the inset");
    let outside = part(&all, 300..320, 0..240);
    assert!(outside.depth.iter().all(|d| *d == 0));
    assert!(outside.index.iter().all(|i| *i == outside.index[0]));
}

#[test]
fn a_pose_may_move_the_camera_of_one_viewport() {
    let mut scene = teapot();
    scene.viewports = vec![
        viewport([0.0, 0.0, 0.5, 1.0]),
        viewport([0.5, 0.0, 0.5, 1.0]),
    ];
    let baked = fixel_bake::bake(&scene).expect("two viewports");
    let core = baked.scene().expect("baked a moment ago");
    let pose = core.pose(0);
    let up = Camera {
        view_up: fixel::math::Vec3::from_ints(1, 0, 0),
        ..pose.camera
    };
    let cameras = [(1, up)];
    let moved = fixel::Pose {
        cameras: &cameras,
        ..pose
    };
    let placed = |number| core.place_viewport(number, &moved, 320, 240).camera;
    assert_eq!((placed(0), placed(1)), (pose.camera, up));
}

#[test]
fn eyes_have_a_half_each_and_share_what_is_at_the_focal_point() {
    let path = root().join("scenes/stereo_side_by_side.toml");
    let mut scene = fixel_scene::load(&path).unwrap_or_else(|e| panic!("{e}"));
    // One column is left over between them, and shows the background.
    scene.display.width = 321;
    scene.display.background = Background::Solid([0.1, 0.2, 0.3]);
    let planes = drawn(&scene, None);
    let column = |x: usize| planes.depth.iter().skip(x).step_by(321);
    assert!(column(160).all(|depth| *depth == 0));
    let background = planes.index[160];
    assert!(
        planes
            .index
            .iter()
            .skip(160)
            .step_by(321)
            .all(|i| *i == background)
    );
    // Of an actor, its middle column in each half, in pixels from the half's left.
    let baked = fixel_bake::bake(&scene).expect("a stereo scene");
    let core = baked.scene().expect("baked a moment ago");
    let (frame, _) = fixel_host::frame(&baked, &core, &Options::of(&core));
    let middle = |actor: u16, from: usize| {
        let seen = frame
            .actor
            .iter()
            .enumerate()
            .filter(|(_, a)| **a == actor + 1);
        let columns: Vec<usize> = seen.map(|(i, _)| i % 321).collect();
        let own = columns.iter().filter(|x| (from..from + 160).contains(*x));
        let (sum, count) = own.fold((0, 0), |(sum, count), x| (sum + x - from, count + 1));
        sum as f64 / f64::from(count)
    };
    let parallax = |actor| middle(actor, 161) - middle(actor, 0);
    let [near, at, far] = [0, 1, 2].map(parallax);
    assert!(
        near < -3.0 && at.abs() < 1.5 && far > 3.0,
        "{near} {at} {far}"
    );
}

#[test]
fn a_blob_says_what_viewports_eyes_and_samples_it_was_baked_from() {
    let near = |a: f64, b: f64| (a - b).abs() < 1e-6;
    for (name, viewports) in [
        ("viewports", 4),
        ("fog_exponential", 2),
        ("stereo_side_by_side", 0),
        ("stereo_anaglyph", 0),
        ("antialiased", 0),
    ] {
        let (scene, baked) = fixel_tests::load(&root().join(format!("scenes/{name}.toml")));
        let back = fixel_bake::unbake(&baked.scene().expect("baked a moment ago"));
        assert_eq!(back.viewports.len(), viewports, "{name}");
        for (back, viewport) in back.viewports.iter().zip(&scene.viewports) {
            let sides = back.rectangle.iter().zip(viewport.rectangle);
            assert!(sides.into_iter().all(|(a, b)| near(*a, b)), "{name}");
            assert_eq!(back.aspect, viewport.aspect, "{name}");
            assert_eq!(back.camera.is_some(), viewport.camera.is_some(), "{name}");
            let background = back.background.is_some();
            assert_eq!(background, viewport.background.is_some(), "{name}");
        }
        let (back, display) = (back.display, scene.display);
        assert_eq!(back.samples, display.samples, "{name}");
        assert_eq!(back.stereo.joined(), display.stereo.joined(), "{name}");
        let angles = [back.stereo.eye_angle(), display.stereo.eye_angle()];
        assert!(near(angles[0], angles[1]), "{name}");
    }
}
