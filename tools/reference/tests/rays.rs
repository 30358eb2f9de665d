//! Ray tracing, where the answer is known beforehand.

mod common;

use common::*;
use fixel_reference::{Frame, Lookup, Options, Path, Truth, compare, heatmap, render_rays};
use fixel_scene::{Background, Cull, Light, LightKind, Material, Mesh, Primitive, Scene};

fn close(a: f64, b: f64, limit: f64) {
    assert!((a - b).abs() <= limit, "{a} is not {b}");
}

/// By rays, at the display's size.
fn rays(scene: &Scene) -> Truth {
    let (width, height) = (scene.display.width, scene.display.height);
    let frame = 0;
    render_rays(
        scene,
        Options {
            width,
            height,
            frame,
        },
    )
}

/// The red channel of each pixel.
fn reds(truth: &Truth) -> Vec<f64> {
    truth.colours().map(|colour| colour[0]).collect()
}

/// A material of its own for an actor.
fn paint(scene: &mut Scene, actor: usize, material: Material) {
    scene.materials.push(material);
    scene.actors[actor].material = scene.materials.len() - 1;
}

/// What shines by itself, and nothing else.
fn glowing(emission: f64) -> Material {
    Material {
        emission,
        diffuse: 0.0,
        ..material()
    }
}

/// What only mirrors.
fn mirror() -> Material {
    Material {
        diffuse: 0.0,
        reflectivity: 1.0,
        ..material()
    }
}

/// Glass that has no colour of its own.
fn glass(refractive_index: f64) -> Material {
    Material {
        diffuse: 0.0,
        opacity: 0.0,
        refractive_index,
        ..material()
    }
}

fn primitive(primitive: Primitive) -> Mesh {
    Mesh {
        name: "primitive".into(),
        primitive: Some(primitive),
        ..Mesh::default()
    }
}

#[test]
fn the_eyes_rays_see_what_the_rasteriser_shows() {
    for mut scene in [parallel(40, 30), perspective(40, 30)] {
        scene.ray.shadows = false;
        scene.materials[0].cull = Cull::None;
        for (at, scale) in [([14.0, -12.0, 0.0], 9.0), ([22.0, -16.0, 2.0], 7.0)] {
            let actor = add(&mut scene, sphere(1.0, 14, 9));
            (actor.position, actor.scale) = (at, [scale, scale * 0.8, 4.0]);
            actor.orientation = [20.0, 30.0, 40.0];
        }
        let (raster, rays) = (truth(&scene), rays(&scene));
        assert!(raster.covered_px() > 200);
        for (a, b) in raster.pixels().iter().zip(rays.pixels()) {
            assert_eq!(
                a.map(|a| [a.actor, a.triangle]),
                b.map(|b| [b.actor, b.triangle])
            );
            if let (Some(a), Some(b)) = (a, b) {
                close(a.depth_lsb, b.depth_lsb, 1e-6);
                close(a.weights[0], b.weights[0], 1e-6);
            }
        }
    }
}

#[test]
fn a_sphere_is_round_and_its_depth_exact() {
    let mut scene = parallel(9, 9);
    let radius = 3.0;
    add(&mut scene, primitive(Primitive::Sphere { radius })).position = [4.5, -4.5, 0.0];
    let truth = rays(&scene);
    for y in 0..9 {
        for x in 0..9 {
            let off = (f64::from(x) - 4.0).powi(2) + (f64::from(y) - 4.0).powi(2);
            let hit = truth.hit(x, y);
            // Tangent rays are the tie rule's business.
            if off == radius * radius {
                continue;
            }
            assert_eq!(hit.is_some(), off < radius * radius, "{x}, {y}");
            if let Some(hit) = hit {
                let w = EYE - (radius * radius - off).max(0.0).sqrt();
                close(
                    hit.depth_lsb,
                    65535.0 * (RANGE[1] - w) / (RANGE[1] - RANGE[0]),
                    0.01,
                );
            }
        }
    }
}

/// A wall under a slab one unit above it, over columns 2 and 3, and light that goes to
/// the right and down.
fn shadowed(height: u32) -> Scene {
    let mut scene = parallel(8, height);
    scene.lights = vec![white_light([1.0, 0.0, -1.0])];
    add(&mut scene, screen_rect([0.0, 0.0], [8.0, 9.0], 0.0));
    add(&mut scene, screen_rect([2.0, -1.0], [4.0, 9.0], 1.0));
    scene
}

#[test]
fn a_shadow_falls_where_it_should() {
    let mut scene = shadowed(1);
    let lit = 0.5_f64.sqrt();
    let expect = |scene: &Scene, shadow: f64| {
        let wanted = [lit, lit, lit, lit, shadow, lit, lit, lit];
        for (found, wanted) in reds(&rays(scene)).into_iter().zip(wanted) {
            close(found, wanted, 1e-12);
        }
    };
    expect(&scene, 0.0);
    scene.ray.shadows = false;
    expect(&scene, lit);
    // What is thin lets part of the light through, whichever side it turns to it, and
    // what is below it through to the eye.
    scene.ray.shadows = true;
    let thin = Material {
        opacity: 0.25,
        ..material()
    };
    paint(&mut scene, 1, thin);
    let found = reds(&rays(&scene));
    close(found[4], 0.75 * lit, 1e-12);
    close(found[3], 0.25 * lit + 0.75 * 0.75 * lit, 1e-12);
    scene.materials[1].opacity = 1.0;
    scene.materials[1].cull = Cull::Front;
    close(reds(&rays(&scene))[3], 0.0, 1e-12);
    // A lamp between the slab and the wall is not hidden by what is behind it.
    let mut scene = shadowed(1);
    scene.lights[0].kind = LightKind::Point {
        position: [3.5, -0.5, 0.5],
        attenuation: [1.0, 0.0, 0.0],
    };
    close(
        reds(&rays(&scene))[5],
        0.5 / (2.0_f64 * 2.0 + 0.5 * 0.5).sqrt(),
        1e-6,
    );
}

#[test]
fn a_light_with_an_extent_has_a_half_shadow() {
    let mut scene = parallel(16, 1);
    add(&mut scene, screen_rect([0.0, 0.0], [16.0, 1.0], 0.0));
    // Covers everything left of the light's middle, half way up to it.
    add(&mut scene, screen_rect([-50.0, -50.0], [8.0, 50.0], 5.0));
    scene.materials.push(glass(1.0));
    scene.lights = vec![Light {
        kind: LightKind::Point {
            position: [8.0, -0.5, 9.9],
            attenuation: [1.0, 0.0, 0.0],
        },
        edges: Some([[4.0, 0.0, 0.0], [0.0, 4.0, 0.0]]),
        ..white_light([0.0, 0.0, -1.0])
    }];
    scene.ray.light_samples = 16;
    // Seen from below the slab.
    scene.camera.clipping_range = [6.0, 21.0];
    let found = rays(&scene);
    let part = |x: u32| {
        let cosine = |px: f64| 9.9 / px.hypot(9.9);
        found.hit(x, 0).unwrap().colour[0] / cosine(f64::from(x) + 0.5 - 8.0)
    };
    // The half shadow reaches about 2 to either side.
    close(part(4), 0.0, 1e-12);
    close(part(12), 1.0, 0.03);
    close((part(7) + part(8)) / 2.0, 0.5, 0.07);
    assert!(part(6) < part(7) && part(7) < part(8) && part(8) < part(9));
}

#[test]
fn a_mirror_in_a_mirror() {
    // Down on a slope at x = 1, to the right on another at x = 3, down on what shines.
    let mut scene = parallel(2, 1);
    let slope = |x: f64, z: f64, rise: f64| {
        let [low, high] = [z - rise, z + rise];
        quad([
            [x - 1.0, -1.0, high],
            [x + 1.0, -1.0, low],
            [x + 1.0, 0.0, low],
            [x - 1.0, 0.0, high],
        ])
    };
    add(&mut scene, slope(1.0, 0.0, 1.0));
    add(&mut scene, slope(5.0, 0.0, 1.0));
    add(&mut scene, screen_rect([4.0, 0.0], [6.0, 1.0], -5.0));
    scene.materials[0] = Material {
        cull: Cull::None,
        reflectivity: 0.5,
        emission: 0.25,
        diffuse: 0.0,
        ..material()
    };
    paint(&mut scene, 2, glowing(1.0));
    scene.display.background = Background::Solid([0.75; 3]);
    scene.ray.depth = 3;
    let two = |last: f64| 0.5 * 0.25 + 0.5 * (0.5 * 0.25 + 0.5 * last);
    for (depth, wanted) in [(3, two(1.0)), (2, two(0.75)), (1, 0.5 * 0.25 + 0.5 * 0.75)] {
        scene.ray.depth = depth;
        for found in reds(&rays(&scene)) {
            close(found, wanted, 1e-12);
        }
    }
}

#[test]
fn glass_straight_on_is_fresnels() {
    // A slab of two walls, over what shines.
    for index in [1.0, 1.5, 2.4] {
        let mut scene = parallel(2, 2);
        scene.materials[0] = glass(index);
        add(&mut scene, screen_rect([-9.0, -9.0], [11.0, 11.0], 2.0));
        let below = add(&mut scene, screen_rect([-9.0, -9.0], [11.0, 11.0], 1.0));
        below.orientation = [0.0, 180.0, 0.0];
        below.origin = [1.0, 1.0, 1.0];
        below.position = [0.0, -2.0, 0.0];
        add(&mut scene, screen_rect([-9.0, -9.0], [11.0, 11.0], -1.0));
        paint(&mut scene, 2, glowing(1.0));
        scene.display.background = Background::Solid([0.25; 3]);
        scene.ray.depth = 3;
        let part = ((index - 1.0) / (index + 1.0)).powi(2);
        let through = (1.0 - part) * (1.0 - part);
        for found in reds(&rays(&scene)) {
            close(found, through + 0.25 * (1.0 - through), 1e-12);
        }
    }
}

#[test]
fn no_light_is_lost_or_made() {
    // In a world that is white all over, whatever mirrors and bends is white.
    let mut scene = perspective(24, 24);
    scene.display.background = Background::Solid([1.0; 3]);
    scene.materials[0] = glass(1.5);
    scene.ray.depth = 8;
    let radius = 6.0;
    add(&mut scene, primitive(Primitive::Sphere { radius })).position = [10.0, -12.0, 0.0];
    let ball = add(&mut scene, sphere(6.0, 20, 11));
    ball.position = [15.0, -12.0, -9.0];
    paint(&mut scene, 1, mirror());
    let truth = rays(&scene);
    assert!(truth.covered_px() > 100);
    for colour in truth.colours() {
        for channel in colour {
            close(channel, 1.0, 1e-9);
        }
    }
}

#[test]
fn a_glass_ball_turns_the_picture_round() {
    // Its focal length from the middle is n r / (2 (n - 1)) = 1.5 r; what is far behind
    // is upside down.
    let mut scene = parallel(3, 30);
    scene.materials[0] = glass(1.5);
    let radius = 10.0;
    add(&mut scene, primitive(Primitive::Sphere { radius })).position = [1.5, -15.0, -10.0];
    // The far half that is up shines.
    add(
        &mut scene,
        screen_rect([-900.0, -900.0], [900.0, 15.0], -400.0),
    );
    paint(&mut scene, 1, glowing(1.0));
    let found = rays(&scene);
    let red = |y| found.hit(1, y).unwrap().colour[0];
    assert!(red(11) < 0.1 && red(18) > 0.9, "{} {}", red(11), red(18));
}

#[test]
fn a_pixel_that_differs_from_its_neighbour_has_more_rays() {
    let mut scene = parallel(4, 4);
    // A quarter of column 1, three quarters of row 2.
    add(&mut scene, screen_rect([1.75, -9.0], [9.0, 2.75], 0.0));
    paint(&mut scene, 0, glowing(1.0));
    scene.ray.samples = 16;
    let found = reds(&rays(&scene));
    let at = |x: usize, y: usize| found[y * 4 + x];
    close(at(1, 0), 0.25, 0.07);
    close(at(3, 2), 0.75, 0.07);
    close(at(1, 2), 0.25 * 0.75, 0.07);
    close(at(3, 0), 1.0, 1e-12);
    assert_eq!((at(0, 0), at(0, 3)), (0.0, 0.0));
    scene.ray.samples = 1;
    assert_eq!(reds(&rays(&scene))[1], 0.0);
}

#[test]
fn wrong_shadows_are_counted() {
    let scene = shadowed(4);
    let truth = rays(&scene);
    let lookup = Lookup {
        direct: false,
        palette: vec![[0; 3]],
        paths: vec![Path::Colour],
        colours: vec![0; fixel_reference::COLOURS],
        fog: Vec::new(),
        background: vec![0; 32],
    };
    let mut frame = Frame::from_truth(&truth, lookup);
    let shadows = |frame: &Frame| {
        let report = compare(&truth, frame).unwrap();
        [
            report.lit_px,
            report.shadow_mismatch_px,
            report.shadow_mismatch_clusters,
        ]
    };
    assert_eq!(frame.lit[..8], [1, 1, 1, 1, 0, 1, 1, 1]);
    assert_eq!(shadows(&frame), [28, 0, 0]);
    for (i, clusters) in [(0, 0), (7, 0), (6, 0), (14, 0), (15, 1)] {
        frame.lit[i] = 0;
        assert_eq!(shadows(&frame)[2], clusters);
    }
    assert_eq!(shadows(&frame)[1], 5);
    frame.lit[4] = 1;
    let map = heatmap::draw(&truth, &frame).unwrap().shadow;
    let (right, missing, extra) = ([200; 3], [255, 60, 40], [255, 0, 255]);
    assert_eq!([map[0], map[1], map[4]], [missing, right, extra]);
}
