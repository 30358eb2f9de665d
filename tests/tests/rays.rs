//! The ray caster against rays in f64, where rays are easily wrong: many balls, thin
//! walls, light along a surface, surfaces that touch, tiny and huge worlds. `cargo xtask
//! accuracy` holds every scene of the repository to the same limits.

use fixel_reference::Report;
use fixel_scene::{Background, Cull, LightKind, Material, Projection, Scene};
use fixel_tests::made::{Random, add, ball, cube, empty, far_light, lamp, mesh, rectangle};
use fixel_tests::root;

fn compare(scene: &Scene) -> Report {
    let baked = fixel_bake::bake_for_rays(scene).unwrap_or_else(|e| panic!("{e}"));
    let core = baked.scene().expect("baked a moment ago");
    let options = fixel_host::Options::of(&core);
    let (drawn, _) = fixel_host::ray_frame(&baked, &core, &options);
    let at = fixel_reference::Options {
        width: drawn.width,
        height: drawn.height,
        frame: 0,
    };
    let truth = fixel_reference::render_rays(scene, at);
    fixel_reference::compare(&truth, &drawn).unwrap_or_else(|e| panic!("{e}"))
}

/// At most 0.01 % of the pixels (and always one) show another surface, depth is within a
/// unit on 99.9 %, at most 0.1 % of the lit pixels (and always one) have a wrong shadow,
/// and no group of them.
fn hold(what: &str, scene: &Scene) -> Report {
    let report = compare(scene);
    let pixels = f64::from(report.width * report.height);
    let others = report.coverage_mismatch_px + report.visible_mismatch_px;
    let wrong = report.shadow_mismatch_px as f64;
    let good = others as f64 <= (pixels / 10_000.0).max(1.0)
        && report.depth_within_1_percent >= 99.9
        && wrong <= (report.lit_px as f64 / 1000.0).max(1.0)
        && report.shadow_mismatch_clusters == 0;
    let Report {
        covered_px,
        lit_px,
        shadow_mismatch_clusters,
        depth_within_1_percent,
        depth_max_lsb,
        rgb_psnr_db,
        rgb_psnr_true_db,
        level_within_2_percent,
        ..
    } = report;
    let text = format!(
        "{what}: {covered_px} covered, {lit_px} lit; {others} other surfaces, {wrong} wrong \
         shadows in {shadow_mismatch_clusters} clusters, depth {depth_max_lsb:.2} at most, \
         {depth_within_1_percent:.2} % within 1, light {level_within_2_percent:.2} % within 2, \
         {rgb_psnr_db:.1} dB, {rgb_psnr_true_db:.1} unquantised"
    );
    eprintln!("{text}");
    assert!(good, "{text}; {:?}", report.mismatches);
    report
}

/// Balls and ellipsoids, some within each other, over a ground, in three kinds of light.
fn balls(seed: u64) -> Scene {
    let mut scene = empty();
    let mut random = Random(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15));
    for n in 0..14 {
        let radius = random.between(0.1, 1.6).powi(2);
        let position = random.place(-4.0, 4.0);
        let actor = add(&mut scene, ball(radius), position);
        if n % 3 == 0 {
            actor.scale = random.place(0.3, 1.5);
            actor.shear = [random.between(-0.4, 0.4), 0.0, 0.0, 0.2, 0.0, 0.0];
            actor.orientation = random.place(-180.0, 180.0);
        }
    }
    add(&mut scene, rectangle(40.0, 30.0), [0.0, -3.0, 0.0]).orientation = [3.0, 20.0, -4.0];
    scene.camera.position = [3.0, 3.0, 17.0];
    scene.camera.focal_point = [0.0, -0.5, 0.0];
    scene.camera.clipping_range = [1.0, 80.0];
    scene.lights = vec![far_light([0.7, -1.0, -0.4]), lamp([-4.0, 7.0, 6.0])];
    scene
}

#[test]
fn balls_and_ellipsoids() {
    for seed in 1..5 {
        hold(&format!("balls {seed}"), &balls(seed));
    }
    let mut scene = balls(5);
    scene.camera.projection = Projection::Parallel {
        parallel_scale: 5.0,
    };
    hold("balls by parallel rays", &scene);
}

/// The same world, a thousandth or many times as large, or far away from the origin.
#[test]
fn tiny_and_huge_worlds() {
    for factor in [1e-3, 0.037, 21.0, 1e4] {
        for aside in [0.0, 3e4] {
            let mut scene = balls(7);
            add(&mut scene, mesh("bunny"), [1.0, -2.5, 4.0]).scale = [0.35; 3];
            let moved = |p: [f64; 3]| p.map(|c| (c + aside) * factor);
            for actor in &mut scene.actors {
                actor.position = moved(actor.position);
                actor.scale = actor.scale.map(|s| s * factor);
            }
            for light in &mut scene.lights {
                if let LightKind::Point { position, .. } = &mut light.kind {
                    *position = moved(*position);
                }
            }
            let camera = &mut scene.camera;
            camera.position = moved(camera.position);
            camera.focal_point = moved(camera.focal_point);
            camera.clipping_range = camera.clipping_range.map(|w| w * factor);
            hold(&format!("{factor} times, {aside} aside"), &scene);
        }
    }
}

/// Light at one degree, along a ground, over a ball and over a mesh: the ground is lit
/// all over, but for shadows.
#[test]
fn light_along_a_surface() {
    for degrees in [0.3_f64, 1.0, 5.0] {
        let mut scene = empty();
        add(&mut scene, rectangle(60.0, 60.0), [0.0, 0.0, 0.0]);
        add(&mut scene, ball(2.0), [3.5, 2.0, 0.0]);
        add(&mut scene, mesh("bunny"), [-3.0, 0.0, 0.0]).scale = [0.4; 3];
        scene.camera.position = [2.0, 6.0, 14.0];
        scene.camera.focal_point = [0.0, 1.0, 0.0];
        let (sin, cos) = degrees.to_radians().sin_cos();
        scene.lights = vec![far_light([cos * 0.6, -sin, -cos * 0.8])];
        hold(&format!("light at {degrees} degrees"), &scene);
    }
}

/// A closed room of walls a thousandth of its size: no light comes in, and none is lost
/// of the lamp inside.
#[test]
fn thin_walls_neither_leak_nor_shade_themselves() {
    for thickness in [0.1, 0.01, 0.002] {
        let mut scene = empty();
        let wall = [4.0, 4.0, thickness];
        for (position, orientation) in [
            ([0.0, 0.0, -2.0], [0.0, 0.0, 0.0]),
            ([0.0, 0.0, 2.0], [0.0, 0.0, 0.0]),
            ([-2.0, 0.0, 0.0], [0.0, 90.0, 0.0]),
            ([2.0, 0.0, 0.0], [0.0, 90.0, 0.0]),
            ([0.0, -2.0, 0.0], [90.0, 0.0, 0.0]),
            ([0.0, 2.0, 0.0], [90.0, 0.0, 0.0]),
        ] {
            let actor = add(&mut scene, cube(), position);
            (actor.scale, actor.orientation) = (wall, orientation);
        }
        scene.camera.position = [0.6, 0.4, 1.8];
        scene.camera.focal_point = [-0.3, -0.2, -2.0];
        scene.camera.projection = Projection::Perspective { view_angle: 75.0 };
        scene.camera.clipping_range = [0.05, 20.0];
        scene.lights = vec![
            far_light([0.3, -1.0, -0.4]),
            lamp([9.0, 7.0, -8.0]),
            far_light([1.0, 0.01, 0.0]),
        ];
        let dark = hold(&format!("walls of {thickness}, light outside"), &scene);
        assert_eq!(dark.lit_px, 0);
        scene.lights = vec![lamp([0.5, 1.2, 0.3])];
        let lit = hold(&format!("walls of {thickness}, a lamp inside"), &scene);
        assert!(lit.lit_px as f64 > 0.97 * lit.covered_px as f64);
    }
}

/// Boxes that stand on the ground and on each other, a ball that touches it, and one
/// half in it.
#[test]
fn surfaces_that_touch() {
    let mut scene = empty();
    add(&mut scene, rectangle(30.0, 30.0), [0.0; 3]);
    for (position, turn) in [
        ([-2.5, 0.5, 0.0], 0.0),
        ([-2.5, 1.5, 0.0], 30.0),
        ([0.0, 0.5, -2.0], 15.0),
    ] {
        add(&mut scene, cube(), position).orientation = [0.0, turn, 0.0];
    }
    add(&mut scene, ball(1.0), [1.5, 1.0, 0.5]);
    add(&mut scene, ball(1.0), [3.5, 0.0, -1.0]);
    scene.camera.position = [1.0, 4.0, 10.0];
    scene.camera.focal_point = [0.3, 0.6, 0.0];
    scene.lights = vec![lamp([-5.0, 6.0, 4.0]), far_light([-0.8, -0.7, -0.5])];
    hold("surfaces that touch", &scene);
}

/// A mirror that is seen from both sides and glass with a wall on every side, in colour.
#[test]
fn mirrors_and_glass() {
    let mut scene = balls(11);
    scene.materials.extend([
        Material {
            name: "mirror".into(),
            reflectivity: 0.9,
            cull: Cull::None,
            ..scene.materials[0].clone()
        },
        Material {
            name: "glass".into(),
            opacity: 0.1,
            refractive_index: 1.5,
            ..scene.materials[0].clone()
        },
        Material {
            name: "red".into(),
            diffuse_colour: [0.9, 0.2, 0.1],
            ambient_colour: [0.9, 0.2, 0.1],
            ..scene.materials[0].clone()
        },
    ]);
    for (i, actor) in scene.actors.iter_mut().enumerate() {
        actor.material = i % 4;
    }
    scene.display.background = Background::Gradient {
        top: [0.1, 0.3, 0.8],
        bottom: [0.8, 0.8, 0.6],
    };
    let report = hold("mirrors and glass", &scene);
    assert!(report.rgb_psnr_db >= 40.0);
}

/// Rectangles in all positions, with a picture on them, mirrored and sheared too, seen
/// from both sides.
#[test]
fn rectangles() {
    let whitted = root().join("scenes/ray/whitted.toml");
    let mut scene = fixel_scene::load(&whitted).unwrap_or_else(|e| panic!("{e}"));
    let mut random = Random(0x5851_f42d_4c95_7f2d);
    let textured = scene.materials.iter().position(|m| m.texture.is_some());
    let material = textured.expect("the ground has a picture");
    scene.materials[material].cull = Cull::None;
    let ground = scene.actors.iter().find(|a| a.material == material);
    let mesh = scene.meshes[ground.expect("it is shown").mesh].clone();
    for n in 0..24 {
        let position = random.place(-4.0, 4.0);
        let actor = add(&mut scene, mesh.clone(), position);
        actor.material = material;
        actor.orientation = random.place(-180.0, 180.0);
        let size = random.place(0.01, 0.08);
        let sign = |bit: u32| if n >> bit & 1 == 0 { 1.0 } else { -1.0 };
        actor.scale = [0, 1, 2].map(|bit| size[bit as usize] * sign(bit));
        if n % 6 == 5 {
            actor.shear = [random.between(-0.4, 0.4), 0.3, 0.0, 0.2, 0.0, 0.0];
        }
    }
    let report = hold("rectangles", &scene);
    assert!(report.rgb_psnr_db >= 40.0, "{}", report.rgb_psnr_db);
}
