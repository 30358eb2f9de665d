//! Depth, light and colour of what is seen.

mod common;

use common::*;
use fixel_scene::{Light, LightKind, Shading};

fn close(a: f64, b: f64, limit: f64) {
    assert!((a - b).abs() <= limit, "{a} is not {b}");
}

#[test]
fn depth_of_a_slanted_plane() {
    // Height z rises by 0.5 a pixel along x, so it is x / 2 - 2 at z's place.
    let corners = [[-4.0, -6.0], [12.0, -6.0], [12.0, 2.0], [-4.0, 2.0]];
    let plane = || quad(corners.map(|[x, y]| [x, y, x / 2.0 - 2.0]));
    let mut scene = parallel(8, 4);
    add(&mut scene, plane());
    let parallel_truth = truth(&scene);
    let mut scene = perspective(8, 4);
    add(&mut scene, plane());
    let perspective_truth = truth(&scene);
    for x in 0..8 {
        let centre = f64::from(x) + 0.5;
        let w = EYE - (centre / 2.0 - 2.0);
        let depth = parallel_truth.hit(x, 2).unwrap().depth_lsb;
        close(
            depth,
            65535.0 * (RANGE[1] - w) / (RANGE[1] - RANGE[0]),
            1e-3,
        );
        // The ray is at x = 4 + (centre - 4) w / EYE where z = EYE - w.
        let w = EYE / (1.0 + (centre - 4.0) / EYE / 2.0);
        let hit = perspective_truth.hit(x, 2);
        close(hit.unwrap().depth_lsb, 65535.0 * RANGE[0] / w, 1e-3);
    }
}

#[test]
fn the_nearest_wins_and_the_margin_is_to_the_next() {
    let cases: [(&[f64], usize); 5] = [
        (&[-4.0, 2.0, 0.0], 1),
        (&[-4.0, 0.0, 2.0], 2),
        (&[2.0, 0.0, -4.0], 0),
        (&[0.0, 2.0], 1),
        (&[2.0, 0.0], 0),
    ];
    for (heights, nearest) in cases {
        let mut scene = parallel(2, 2);
        for z in heights {
            add(&mut scene, screen_rect([0.0, 0.0], [2.0, 2.0], *z));
        }
        for pixel in truth(&scene).pixels() {
            let hit = pixel.unwrap();
            assert_eq!(hit.actor, nearest);
            close(hit.margin_lsb, 65535.0 * 2.0 / 20.0, 1e-3);
        }
    }
}

#[test]
fn of_coplanar_surfaces_the_first_wins() {
    let mut scene = perspective(4, 4);
    for reach in [9.0, 8.0, 7.0] {
        add(&mut scene, screen_rect([-reach; 2], [reach; 2], 0.0));
    }
    assert!(truth(&scene).pixels().iter().all(|p| p.unwrap().actor == 0));
}

#[test]
fn level_of_a_face_lit_at_60_degrees() {
    let mut scene = parallel(2, 2);
    scene.lights = vec![white_light([-(3.0_f64.sqrt()), 0.0, -1.0])];
    scene.materials[0].ambient = 0.25;
    scene.materials[0].diffuse = 0.5;
    scene.materials[0].emission = 0.125;
    scene.materials[0].diffuse_colour = [1.0, 0.5, 0.0];
    scene.materials[0].ambient_colour = [0.0, 1.0, 1.0];
    scene.ambient = [1.0, 0.5, 0.0];
    add(&mut scene, screen_rect([0.0, 0.0], [2.0, 2.0], 0.0));
    for shading in [Shading::Flat, Shading::Gouraud] {
        scene.materials[0].shading = shading;
        let hit = *truth(&scene).hit(1, 1).unwrap();
        close(hit.level, 255.0 * (0.125 + 0.25 * 0.5 + 0.5 * 0.5), 1e-9);
        close(hit.colour[0], 0.125 + 0.25, 1e-12);
        close(hit.colour[1], 0.0625 + 0.125 + 0.125, 1e-12);
        close(hit.colour[2], 0.0, 1e-12);
    }
}

#[test]
fn light_from_behind_gives_none_and_much_light_is_clamped() {
    let mut scene = parallel(2, 2);
    add(&mut scene, screen_rect([0.0, 0.0], [2.0, 2.0], 0.0));
    scene.lights = vec![white_light([0.0, 0.0, 1.0])];
    assert_eq!(truth(&scene).hit(0, 0).unwrap().level, 0.0);
    let kind = LightKind::Directional {
        direction: [0.0, 0.0, -3.0],
    };
    scene.lights = vec![Light {
        kind,
        colour: [1.0, 0.5, 0.25],
        intensity: 2.0,
        edges: None,
    }];
    let hit = *truth(&scene).hit(0, 0).unwrap();
    assert_eq!(hit.level, 255.0);
    assert_eq!(hit.colour, [1.0, 1.0, 0.5]);
}

#[test]
fn gouraud_is_linear_over_the_surface_not_over_the_screen() {
    // Levels 0 at x = -4 and 255 at x = 12, over a plane that slants in depth.
    let mut scene = perspective(8, 4);
    scene.materials[0].shading = Shading::Gouraud;
    let corners = [[-4.0, -6.0], [12.0, -6.0], [12.0, 2.0], [-4.0, 2.0]];
    let mut plane = quad(corners.map(|[x, y]| [x, y, x / 2.0 - 2.0]));
    for (position, normal) in plane.positions.iter().zip(&mut plane.normals) {
        *normal = if position[0] > 4.0 {
            [0.0, 0.0, 1.0]
        } else {
            [1.0, 0.0, 0.0]
        };
    }
    add(&mut scene, plane);
    let truth = truth(&scene);
    for x in 0..8 {
        let slope = (f64::from(x) + 0.5 - 4.0) / EYE;
        let w = EYE / (1.0 + slope / 2.0);
        close(
            truth.hit(x, 2).unwrap().level,
            255.0 * (8.0 + slope * w) / 16.0,
            1e-3,
        );
    }
}

#[test]
fn gouraud_clamps_at_the_vertices_not_at_the_pixels() {
    // Twice the light at x = 4 and none at x = 0: half at x = 2.
    let mut scene = parallel(4, 1);
    scene.materials[0].shading = Shading::Gouraud;
    scene.lights[0].intensity = 2.0;
    let mut rect = screen_rect([0.0, 0.0], [4.0, 1.0], 0.0);
    for (position, normal) in rect.positions.iter().zip(&mut rect.normals) {
        *normal = if position[0] > 2.0 {
            [0.0, 0.0, 1.0]
        } else {
            [1.0, 0.0, 0.0]
        };
    }
    add(&mut scene, rect);
    let truth = truth(&scene);
    for (x, part) in [0.125, 0.375, 0.625, 0.875].into_iter().enumerate() {
        let hit = truth.hit(x as u32, 0).unwrap();
        close(hit.level, 255.0 * part, 1e-3);
        close(hit.colour[1], part, 1e-5);
    }
}

#[test]
fn normals_of_a_stretched_sphere_stay_upright() {
    // An ellipsoid x^2/16 + y^2 + z^2 = 1 (half axes 4, 1, 1): the normal at
    // (x, y, z) is along (x/16, y, z).
    let mut scene = parallel(16, 16);
    scene.camera.position = [0.0, 0.0, 10.0];
    scene.camera.focal_point = [0.0; 3];
    scene.camera.projection = fixel_scene::Projection::Parallel {
        parallel_scale: 2.0,
    };
    scene.lights = vec![white_light([-1.0, 0.0, -1.0])];
    add(&mut scene, sphere(1.0, 256, 128)).scale = [4.0, 1.0, 1.0];
    for shading in [Shading::Flat, Shading::Gouraud] {
        scene.materials[0].shading = shading;
        let truth = truth(&scene);
        for column in 2..14 {
            let [x, y] = [f64::from(column) * 0.25 + 0.125 - 2.0, -0.125];
            let z = (1.0 - y * y - x * x / 16.0).sqrt();
            let normal = glam::DVec3::new(x / 16.0, y, z).normalize();
            let wanted = 255.0 * normal.dot(glam::DVec3::new(1.0, 0.0, 1.0).normalize());
            close(truth.hit(column, 8).unwrap().level, wanted, 4.0);
        }
    }
}
