//! Against the f64 reference: smooth motion, small screens, and geometry that is
//! cut in every way. `cargo xtask accuracy` holds every scene of the repository
//! to its limits; here are those that need a scene to be changed.

use fixel_reference::Report;
use fixel_scene::{ColourFormat, Projection, Scene, Shading};
use fixel_tests::root;

fn scene(name: &str) -> Scene {
    let path = root().join(format!("scenes/{name}.toml"));
    fixel_scene::load(&path).unwrap_or_else(|e| panic!("{e}"))
}

fn compare(scene: &Scene, frame: u32) -> Report {
    let baked = fixel_bake::bake(scene).unwrap_or_else(|e| panic!("{e}"));
    let core = baked.scene().expect("baked a moment ago");
    let options = fixel_host::Options {
        frame,
        ..fixel_host::Options::of(&core)
    };
    let (drawn, _) = fixel_host::frame(&baked, &core, &options);
    let (width, height) = (drawn.width, drawn.height);
    let truth = fixel_reference::render(
        scene,
        fixel_reference::Options {
            width,
            height,
            frame,
        },
    );
    fixel_reference::compare(&truth, &drawn).unwrap_or_else(|e| panic!("{e}"))
}

/// At most 0.02 % of the covered pixels, and always one; depth within a unit on
/// 99.9 %, where there are enough pixels to tell.
fn hold(what: &str, report: &Report) {
    let most = (report.covered_px as f64 * 0.0002).max(1.0);
    assert!(
        report.coverage_mismatch_px as f64 <= most,
        "{what}: {} of {} pixels differ",
        report.coverage_mismatch_px,
        report.covered_px
    );
    if report.agreeing_px >= 1000 {
        assert!(
            report.depth_within_1_percent >= 99.9,
            "{what}: depth within 1 on {} %",
            report.depth_within_1_percent
        );
    }
}

/// By eighths of a pixel, edges move by eighths of a pixel: at each step the
/// covered pixels are the reference's, so that there are no whole-pixel jumps.
#[test]
fn an_object_moves_smoothly() {
    let mut scene = scene("bunny");
    let Projection::Perspective { view_angle } = scene.camera.projection else {
        panic!("the bunny is seen in perspective");
    };
    let away = |i: usize| scene.camera.position[i] - scene.camera.focal_point[i];
    let distance = (0..3).map(|i| away(i).powi(2)).sum::<f64>().sqrt();
    let height = f64::from(scene.display.height);
    let pixel = 2.0 * distance * (view_angle.to_radians() / 2.0).tan() / height;
    let mut different = 0;
    let start = scene.actors[0].position[0];
    for step in 0..16 {
        scene.actors[0].position[0] = start + f64::from(step) * pixel / 8.0;
        let report = compare(&scene, 0);
        hold(&format!("step {step}"), &report);
        different += report.coverage_mismatch_px;
    }
    // A whole-pixel jump would put some hundred pixels of the outline off.
    assert!(different <= 8, "{different} pixels differ in 16 steps");
}

#[test]
fn small_and_odd_screens() {
    for name in [
        "teapot",
        "bunny",
        "suzanne",
        "slivers",
        "behind_camera",
        "off_screen",
    ] {
        for (width, height) in [(128, 64), (64, 64), (33, 77), (240, 240)] {
            let mut scene = scene(name);
            (scene.display.width, scene.display.height) = (width, height);
            hold(&format!("{name} at {width}x{height}"), &compare(&scene, 0));
        }
    }
}

#[test]
fn frames_of_an_animation() {
    for name in ["teapot", "cube", "parents", "keyframes"] {
        let scene = scene(name);
        for frame in (0..60).step_by(7) {
            hold(&format!("{name}, frame {frame}"), &compare(&scene, frame));
        }
    }
}

/// The near plane, the far plane and the eye itself go through the mesh. Nearer
/// than here the steps of the mesh's 16-bit vertices show in the depth.
#[test]
fn clipping_at_any_distance() {
    for step in 1..12 {
        let mut scene = scene("near_clip");
        let [near, far] = scene.camera.clipping_range;
        let cut = f64::from(step) / 12.0;
        scene.camera.clipping_range = [near * (0.6 + cut), far * (1.2 - 0.5 * cut)];
        hold(&format!("planes, step {step}"), &compare(&scene, 0));
        let mut scene = self::scene("bunny");
        for i in 0..3 {
            let (eye, focus) = (scene.camera.position[i], scene.camera.focal_point[i]);
            scene.camera.position[i] = focus + (eye - focus) * (1.0 - 0.7 * cut);
        }
        scene.camera.clipping_range[0] = 0.5;
        hold(&format!("eye, step {step}"), &compare(&scene, 0));
    }
}

/// One material, 256 colours, no dithering: the unquantised truth to 45 dB.
#[test]
fn colour_of_one_material() {
    for name in [
        "teapot",
        "bunny",
        "suzanne",
        "cube",
        "off_screen",
        "parallel",
    ] {
        let mut scene = scene(name);
        scene.display.colour = ColourFormat::Rgb888;
        let report = compare(&scene, 0);
        assert!(
            report.rgb_psnr_true_db >= 45.0,
            "{name}: {} dB",
            report.rgb_psnr_true_db
        );
    }
}

/// A sharp highlight shows what its normals are off, several times as large; with the
/// normals of 8 bits an axis that other materials have, 2 % of the pixels are off by more.
#[test]
fn light_of_sharp_highlights() {
    for name in ["teapot", "bunny"] {
        for shading in [Shading::Gouraud, Shading::Phong] {
            let mut scene = scene(name);
            let material = &mut scene.materials[0];
            (material.specular, material.specular_power) = (0.5, 64.0);
            material.shading = shading;
            let percent = compare(&scene, 0).level_within_2_percent;
            assert!(
                percent >= 99.9,
                "{name}, {shading:?}: light within 2 on {percent} %"
            );
        }
    }
}

/// A change of the change from pixel to pixel that is rounded down moves textures as a
/// whole, by a 200th of a texel here.
#[test]
fn places_in_textures_do_not_lean() {
    let mean = compare(&scene("alpha_test"), 31).texel_mean;
    assert!(mean < 0.0035, "{mean} texels off in the mean");
}

/// A texture, a highlight and light of its own, from a library beside the mesh.
#[test]
fn a_model_with_materials_of_its_own() {
    let scene = fixel_scene::load(&root().join("tests/data/post.obj"));
    let scene = scene.unwrap_or_else(|e| panic!("{e}"));
    assert_eq!((scene.materials.len(), scene.textures.len()), (3, 1));
    let report = compare(&scene, 0);
    hold("post", &report);
    assert!(
        report.rgb_psnr_true_db >= 30.0,
        "{} dB of the picture without a palette",
        report.rgb_psnr_true_db
    );
    let baked = fixel_bake::bake(&scene).unwrap_or_else(|e| panic!("{e}"));
    let core = baked.scene().expect("baked a moment ago");
    let planes = fixel_host::render(&core, &fixel_host::Options::of(&core));
    let (pixels, _) = fixel_host::picture(&core, &planes);
    // The lamp has light of its own on its dark side.
    let yellow = |[r, g, b]: &&[u8; 3]| *r > 120 && *g > 90 && *b < 110 && r > g;
    assert!(pixels.iter().filter(yellow).count() > 200);
}
