//! The light model against values worked out by hand.

mod common;

use common::*;
use fixel_reference::Hit;
use fixel_scene::{Light, LightKind, Mesh, Scene, Shading};

fn close(found: [f64; 3], wanted: [f64; 3]) {
    for (a, b) in found.iter().zip(wanted) {
        assert!((a - b).abs() <= 1e-6, "{found:?} is not {wanted:?}");
    }
}

/// Nine pixels of a wall at z = 0, the middle of which is at (0, 0), without lights.
fn wall() -> Scene {
    let mut scene = parallel(3, 3);
    scene.camera.position = [0.0, 0.0, EYE];
    scene.camera.focal_point = [0.0; 3];
    scene.lights.clear();
    add(&mut scene, screen_rect([-2.0; 2], [2.0; 2], 0.0));
    scene
}

fn middle(scene: &Scene) -> Hit {
    *truth(scene).hit(1, 1).unwrap()
}

/// The middle's colour in all three ways to light a wall of one normal, which
/// are the same for light that is the same everywhere.
fn everywhere(scene: &mut Scene, wanted: [f64; 3]) {
    for shading in [Shading::Flat, Shading::Gouraud, Shading::Phong] {
        scene.materials[0].shading = shading;
        close(middle(scene).colour, wanted);
    }
}

fn phong(scene: &mut Scene) {
    scene.materials[0].shading = Shading::Phong;
}

#[test]
fn coloured_lights_add_up_in_each_channel() {
    let mut scene = wall();
    scene.ambient = [0.5, 0.25, 0.0];
    scene.materials[0].ambient = 0.5;
    scene.materials[0].diffuse_colour = [1.0, 0.5, 1.0];
    scene.lights = vec![
        Light {
            colour: [1.0, 0.0, 0.0],
            intensity: 0.5,
            ..white_light([0.0, 0.0, -2.0])
        },
        // At 60 degrees: half of the light.
        Light {
            colour: [0.0, 1.0, 0.5],
            ..white_light([0.0, 3.0_f64.sqrt(), -1.0])
        },
        Light {
            colour: [1.0, 1.0, 1.0],
            ..white_light([0.0, 0.0, 1.0])
        },
    ];
    everywhere(&mut scene, [0.25 + 0.5, 0.125 + 0.25, 0.25]);
    // The level is that of greys: means of the channels.
    let level = 255.0 * (0.5 * 0.25 + 0.5 / 3.0 + 0.5 * 0.5);
    assert!((middle(&scene).level - level).abs() < 1e-6);
}

#[test]
fn a_point_light_fades_with_distance() {
    let mut scene = wall();
    phong(&mut scene);
    // 3 to the side, 4 off: 5 away, at a cosine of 4/5.
    let point = |attenuation| Light {
        kind: LightKind::Point {
            position: [3.0, 0.0, 4.0],
            attenuation,
        },
        ..white_light([0.0; 3])
    };
    for (attenuation, divisor) in [
        ([1.0, 0.0, 0.0], 1.0),
        ([0.0, 1.0, 0.0], 5.0),
        ([0.0, 0.0, 1.0], 25.0),
        ([1.0, 0.2, 0.08], 4.0),
    ] {
        scene.lights = vec![point(attenuation)];
        close(middle(&scene).colour, [0.8 / divisor; 3]);
    }
    // Behind the wall, and just in it.
    for z in [-4.0, 0.0] {
        let position = [0.0, 0.0, z];
        let attenuation = [1.0, 0.0, 0.0];
        scene.lights[0].kind = LightKind::Point {
            position,
            attenuation,
        };
        close(middle(&scene).colour, [0.0; 3]);
    }
}

#[test]
fn a_flat_face_is_lit_at_its_centre_and_a_gouraud_face_at_its_vertices() {
    // The centre of (-2, -2), (2, -2), (2, 2) is (2/3, -2/3).
    let mut scene = wall();
    scene.lights = vec![Light {
        kind: LightKind::Point {
            position: [2.0 / 3.0, -2.0 / 3.0, 3.0],
            attenuation: [0.0, 1.0, 0.0],
        },
        ..white_light([0.0; 3])
    }];
    scene.materials[0].shading = Shading::Flat;
    let first = truth(&scene);
    let hit = first.hit(2, 2).unwrap();
    assert_eq!(hit.triangle, 0);
    close(hit.colour, [1.0 / 3.0; 3]);
    scene.materials[0].shading = Shading::Gouraud;
    // Of corner i: height 3 / distance^2.
    let corner = |x: f64, y: f64| {
        let (dx, dy) = (x - 2.0 / 3.0, y + 2.0 / 3.0);
        3.0 / (9.0 + dx * dx + dy * dy)
    };
    let lit = [corner(-2.0, -2.0), corner(2.0, -2.0), corner(2.0, 2.0)];
    let truth = truth(&scene);
    let hit = truth.hit(2, 2).unwrap();
    let wanted = (0..3).map(|i| lit[i] * hit.weights[i]).sum();
    close(hit.colour, [wanted; 3]);
}

#[test]
fn a_spot_is_a_cone_with_a_sharp_edge() {
    let mut scene = wall();
    phong(&mut scene);
    let spot = |aim: [f64; 3], cone_angle, exponent| Light {
        kind: LightKind::Spot {
            position: [0.0, 0.0, 4.0],
            direction: aim,
            attenuation: [0.0, 0.25, 0.0],
            cone_angle,
            exponent,
        },
        colour: [1.0, 0.5, 0.0],
        intensity: 1.0,
        edges: None,
    };
    let mut colour = |light| {
        scene.lights = vec![light];
        middle(&scene).colour
    };
    // Straight at the middle, 4 away.
    close(colour(spot([0.0, 0.0, -3.0], 1.0, 128.0)), [1.0, 0.5, 0.0]);
    // The axis is 30 degrees off.
    let aside = [1.0, 0.0, -(3.0_f64.sqrt())];
    close(colour(spot(aside, 29.99, 1.0)), [0.0; 3]);
    let cosine = 3.0_f64.sqrt() / 2.0;
    for (exponent, beam) in [(0.0, 1.0), (1.0, cosine), (2.0, 0.75), (4.0, 0.5625)] {
        let wanted = [beam, 0.5 * beam, 0.0];
        close(colour(spot(aside, 30.01, exponent)), wanted);
    }
}

#[test]
fn a_highlight_is_where_the_mirror_image_meets_the_eye() {
    let mut scene = wall();
    let material = &mut scene.materials[0];
    material.diffuse = 0.0;
    material.specular = 0.5;
    material.specular_colour = [1.0, 0.5, 0.0];
    material.specular_power = 4.0;
    // At 30 degrees the mirror image is 30 degrees off the eye.
    scene.lights = vec![Light {
        colour: [1.0, 1.0, 0.5],
        ..white_light([1.0, 0.0, -(3.0_f64.sqrt())])
    }];
    let factor = 0.5 * 0.5625;
    everywhere(&mut scene, [factor, 0.5 * factor, 0.0]);
    // At 60 degrees with diffuse light too; cos(60)^2 is a quarter.
    scene.materials[0].specular_power = 2.0;
    scene.materials[0].diffuse = 0.5;
    scene.lights = vec![white_light([3.0_f64.sqrt(), 0.0, -1.0])];
    everywhere(&mut scene, [0.25 + 0.125, 0.25 + 0.0625, 0.25]);
    // It fades with distance, as diffuse light does: 4 away, in line with the eye.
    scene.lights = vec![Light {
        kind: LightKind::Point {
            position: [0.0, 0.0, 4.0],
            attenuation: [0.0, 0.5, 0.0],
        },
        ..white_light([0.0; 3])
    }];
    phong(&mut scene);
    close(middle(&scene).colour, [0.5, 0.375, 0.25]);
    // None from behind, though the mirror image of l about N would meet the eye.
    scene.lights = vec![white_light([0.0, 0.0, 1.0])];
    everywhere(&mut scene, [0.0; 3]);
}

#[test]
fn in_perspective_the_eye_is_where_it_is() {
    let mut scene = wall();
    scene.camera = perspective(3, 3).camera;
    scene.camera.position = [0.0, 4.0, 3.0];
    scene.camera.focal_point = [0.0; 3];
    phong(&mut scene);
    scene.materials[0].diffuse = 0.0;
    scene.materials[0].specular = 1.0;
    scene.materials[0].specular_power = 3.0;
    // Straight down: the mirror image goes straight up, the eye is at 3/5.
    scene.lights = vec![white_light([0.0, 0.0, -1.0])];
    close(middle(&scene).colour, [0.216; 3]);
}

#[test]
fn phong_brings_the_normal_back_to_length_1_at_each_pixel() {
    // Normals turn from (0, 0, 1) at x = -2 to (1, 0, 0) at x = 2: in the middle
    // they are at 45 degrees, where the interpolated vector is 0.707 long.
    let mut scene = wall();
    phong(&mut scene);
    let mesh = &mut scene.meshes[0];
    for (position, normal) in mesh.positions.iter().zip(&mut mesh.normals) {
        if position[0] > 0.0 {
            *normal = [1.0, 0.0, 0.0];
        }
    }
    scene.lights = vec![white_light([-1.0, 0.0, -1.0])];
    close(middle(&scene).colour, [1.0; 3]);
    scene.lights = vec![white_light([0.0, 0.0, -1.0])];
    close(middle(&scene).colour, [0.5_f64.sqrt(); 3]);
    scene.materials[0].shading = Shading::Gouraud;
    close(middle(&scene).colour, [0.5; 3]);
}

/// Colours the left of a mesh red with some blue, the right blue.
fn painted(mesh: &mut Mesh) {
    let colour = |p: &[f64; 3]| {
        if p[0] < 0.0 {
            [1.0, 0.0, 0.5]
        } else {
            [0.0, 0.0, 1.0]
        }
    };
    mesh.colours = mesh.positions.iter().map(colour).collect();
}

#[test]
fn vertex_colours_tint_ambient_diffuse_and_emitted_light_but_no_highlight() {
    let mut scene = wall();
    painted(&mut scene.meshes[0]);
    let material = &mut scene.materials[0];
    material.ambient = 0.25;
    material.diffuse = 0.25;
    material.emission = 0.25;
    material.specular = 0.125;
    scene.lights = vec![white_light([0.0, 0.0, -1.0])];
    for shading in [Shading::Gouraud, Shading::Phong] {
        scene.materials[0].shading = shading;
        close(middle(&scene).colour, [0.5, 0.125, 0.6875]);
    }
    // Of the lower right triangle, two corners are blue and one is red.
    scene.materials[0].shading = Shading::Flat;
    let truth = truth(&scene);
    let hit = truth.hit(2, 2).unwrap();
    let wanted = [1.0 / 3.0, 0.0, 2.5 / 3.0].map(|tint| 0.75 * tint + 0.125);
    close(hit.colour, wanted);
    // The level is without them.
    assert!((hit.level - 255.0 * 0.875).abs() < 1e-6);
}

#[test]
fn each_channel_is_clamped_by_itself() {
    let mut scene = wall();
    scene.materials[0].diffuse_colour = [1.0, 0.5, 0.25];
    scene.lights = vec![Light {
        intensity: 3.0,
        ..white_light([0.0, 0.0, -1.0])
    }];
    everywhere(&mut scene, [1.0, 1.0, 0.75]);
}
