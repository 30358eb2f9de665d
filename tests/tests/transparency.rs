//! Surfaces through which others show: the pattern of screen doors as published, the
//! order and the mixture of blended ones, and both against the f64 reference.

use fixel_host::{Options, Planes};
use fixel_reference::Report;
use fixel_scene::{Fog, FogMode, Representation, Scene, Transparency};
use fixel_tests::root;

fn scene(name: &str) -> Scene {
    fixel_scene::load(&root().join(format!("scenes/{name}.toml"))).unwrap_or_else(|e| panic!("{e}"))
}

/// The first of some panes that fill the screen, near ones first: colour, opacity and how
/// the rest shows.
fn panes(how: &[([f64; 3], f64, Transparency)]) -> Scene {
    let path = root().join("tests/data/panes.toml");
    let mut scene = fixel_scene::load(&path).unwrap_or_else(|e| panic!("{e}"));
    scene.actors.truncate(how.len());
    for (material, (colour, opacity, transparency)) in scene.materials.iter_mut().zip(how) {
        material.ambient_colour = *colour;
        material.diffuse_colour = *colour;
        material.opacity = *opacity;
        material.transparency = *transparency;
    }
    scene
}

fn drawn(scene: &Scene) -> (Planes, Vec<[u8; 3]>) {
    let baked = fixel_bake::bake(scene).unwrap_or_else(|e| panic!("{e}"));
    let core = baked.scene().expect("baked a moment ago");
    let planes = fixel_host::render(&core, &Options::of(&core));
    let (pixels, _) = fixel_host::picture(&core, &planes);
    (planes, pixels)
}

/// Bayer's matrix of 8 by 8, as it is printed everywhere (its first column and row at the
/// picture's top left).
const BAYER: [[u8; 8]; 8] = [
    [0, 32, 8, 40, 2, 34, 10, 42],
    [48, 16, 56, 24, 50, 18, 58, 26],
    [12, 44, 4, 36, 14, 46, 6, 38],
    [60, 28, 52, 20, 62, 30, 54, 22],
    [3, 35, 11, 43, 1, 33, 9, 41],
    [51, 19, 59, 27, 49, 17, 57, 25],
    [15, 47, 7, 39, 13, 45, 5, 37],
    [63, 31, 55, 23, 61, 29, 53, 21],
];

#[test]
fn a_screen_door_has_the_published_pixels() {
    let door = |opacity: f64| ([1.0; 3], opacity, Transparency::ScreenDoor);
    for opacity in [0.0, 1.0 / 64.0, 0.3, 0.5, 0.75, 0.99] {
        // The first is seen through, the second is the second of its kind.
        let (planes, _) = drawn(&panes(&[door(0.0), door(opacity)]));
        for (i, depth) in planes.depth.iter().enumerate() {
            let threshold = BAYER[i / 16 % 8][i % 8];
            let own = f64::from((threshold + 64 - 16) % 64) < (64.0 * opacity).round();
            assert_eq!(*depth != 0, own, "pixel {i} at opacity {opacity}");
        }
    }
}

/// The same picture whichever pane comes first in the file, the near one over the far one,
/// each mixed with what is behind it; and nothing of them in the depth buffer.
#[test]
fn panes_are_mixed_from_far_to_near() {
    let (red, green, blue) = ([1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]);
    let blend = Transparency::Blend;
    let mut scene = panes(&[(red, 0.4, blend), (green, 0.8, blend), (blue, 1.0, blend)]);
    // All that is seen from far to near, in 15ths, as the look-up has them.
    scene.palette.fixed = vec![[0, 0, 255], [0, 204, 51], [102, 119, 34], [255, 0, 0]];
    let first = drawn(&scene);
    // 0.4 of red over 0.8 of green over blue: 6, 7.2 and 1.8 of 15.
    assert!(first.1.iter().all(|pixel| *pixel == [102, 119, 34]));
    scene.actors.reverse();
    let second = drawn(&scene);
    assert_eq!(first.1, second.1);
    assert_eq!(first.0.depth, second.0.depth);
    let wall = drawn(&panes(&[
        (red, 0.0, blend),
        (green, 0.0, blend),
        (blue, 1.0, blend),
    ]));
    assert_eq!(first.0.depth, wall.0.depth);
    assert!(wall.1.iter().all(|pixel| *pixel == [0, 0, 255]));
}

fn compare(scene: &Scene) -> Report {
    let baked = fixel_bake::bake(scene).unwrap_or_else(|e| panic!("{e}"));
    let core = baked.scene().expect("baked a moment ago");
    let options = Options::of(&core);
    let (frame, _) = fixel_host::frame(&baked, &core, &options);
    let at = fixel_reference::Options {
        width: options.width.into(),
        height: options.height.into(),
        frame: options.frame,
    };
    let truth = fixel_reference::render(scene, at);
    fixel_reference::compare(&truth, &frame).unwrap_or_else(|e| panic!("{e}"))
}

/// Colour through the same palette to 40 dB.
#[test]
fn what_shows_through_is_the_references() {
    for name in ["screen_door", "blend", "blend_fog", "alpha_test"] {
        let report = compare(&scene(name));
        let decibels = report.rgb_psnr_db;
        assert!(decibels >= 40.0, "{name}: {decibels} dB");
    }
}

#[test]
fn what_cannot_be_drawn_is_refused() {
    let mut scene = panes(&[([1.0; 3], 0.5, Transparency::Blend)]);
    let refused = |scene: &Scene| fixel_bake::bake(scene).map(|_| ()).unwrap_err().to_string();
    scene.fog = Some(Fog {
        mode: FogMode::Linear {
            start: 1.0,
            end: 2.0,
        },
        colour: [0.5; 3],
    });
    assert!(fixel_bake::bake(&scene).is_ok());
    scene.actors[0].look.depth_test = false;
    assert_eq!(
        refused(&scene),
        "actor `pane 0`: depth_test = false in fog with blended materials (expected \
         depth_test = true) is not supported yet"
    );
    scene.actors[0].look.representation = Representation::Wireframe;
    scene.fog = None;
    assert_eq!(
        refused(&scene),
        "actor `pane 0`: lines or points of a material of opacity 0.5 (expected opacity = 1) \
         is not supported yet"
    );
}
