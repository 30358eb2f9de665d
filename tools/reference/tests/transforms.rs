//! Actors and cameras: the worked examples, reflection, the turntable.

mod common;

use common::*;
use fixel_reference::{View, actor_matrix};
use fixel_scene::{Actor, Camera, Projection, Shading};
use glam::DVec3;

fn place(change: impl FnOnce(&mut Actor), point: [f64; 3]) -> DVec3 {
    let mut scene = parallel(1, 1);
    let actor = add(&mut scene, mesh(&[]));
    change(actor);
    actor_matrix(&scene, 0, 0).transform_point3(point.into())
}

fn close(found: DVec3, wanted: [f64; 3]) {
    assert!(
        found.distance(wanted.into()) < 1e-12,
        "{found} is not {wanted:?}"
    );
}

#[test]
fn moved_by_5_in_y_then_turned_about_x() {
    // T(5y) first: as the actor turns about the point that the move brings to 0.
    let found = place(
        |actor| {
            actor.origin = [0.0, -5.0, 0.0];
            actor.position = [0.0, 5.0, 0.0];
            actor.orientation = [90.0, 0.0, 0.0];
        },
        [0.0, 0.0, 1.0],
    );
    close(found, [0.0, -1.0, 5.0]);
}

#[test]
fn turned_about_an_axis_parallel_to_x() {
    let found = place(
        |actor| {
            actor.origin = [0.0, 3.0, 2.0];
            actor.orientation = [90.0, 0.0, 0.0];
        },
        [0.0, 0.0, 1.0],
    );
    close(found, [0.0, 4.0, -1.0]);
}

#[test]
fn scaled_turned_about_y_then_x_then_z_then_moved() {
    let found = place(
        |actor| {
            actor.scale = [2.0, 1.0, 1.0];
            actor.orientation = [90.0, 90.0, 90.0];
            actor.position = [10.0, 20.0, 30.0];
        },
        [1.0, 0.0, 0.0],
    );
    // (2, 0, 0), about y (0, 0, -2), about x (0, 2, 0), about z (-2, 0, 0).
    close(found, [8.0, 20.0, 30.0]);
}

/// World point in a frame with its origin at the view-site, z to the viewpoint.
fn viewed(site: [f64; 3], viewpoint: [f64; 3], world: [f64; 3]) -> DVec3 {
    let camera = Camera {
        position: viewpoint,
        focal_point: site,
        view_up: [0.0, 0.0, 1.0],
        projection: Projection::Parallel {
            parallel_scale: 1.0,
        },
        clipping_range: [0.0, 100.0],
    };
    let seen = View::new(&camera, 1, 1).to_view(world.into());
    let distance = DVec3::from(viewpoint).distance(site.into());
    DVec3::new(seen.x, seen.y, distance - seen.z)
}

#[test]
fn viewing_frames() {
    let found = viewed([0.0, 0.0, 1.0], [-10.0, 0.0, 1.0], [5.0, 0.0, 1.0]);
    close(found, [0.0, 0.0, -5.0]);
    let found = viewed([0.0; 3], [5.0; 3], [0.0, 0.0, 5.0]);
    close(
        found,
        [0.0, 5.0 * 6.0_f64.sqrt() / 3.0, 5.0 / 3.0_f64.sqrt()],
    );
}

#[test]
fn the_view_angle_is_the_full_vertical_one() {
    // At 90 degrees and distance 10 the picture's top is 10 above the axis.
    let mut scene = perspective(40, 20);
    scene.camera.position = [0.0, 0.0, 10.0];
    scene.camera.focal_point = [0.0; 3];
    scene.camera.projection = Projection::Perspective { view_angle: 90.0 };
    add(
        &mut scene,
        quad([
            [3.0, 9.0, 0.0],
            [19.0, 9.0, 0.0],
            [19.0, 10.0, 0.0],
            [3.0, 10.0, 0.0],
        ]),
    );
    let truth = truth(&scene);
    assert_eq!(truth.covered_px(), 16);
    assert!((23..39).all(|x| truth.hit(x, 0).is_some()));
}

#[test]
fn a_camera_turned_on_its_side() {
    let mut scene = parallel(8, 8);
    scene.camera.position = [0.0, 0.0, 10.0];
    scene.camera.focal_point = [0.0; 3];
    scene.camera.view_up = [1.0, 0.0, 5.0];
    // World +x is up in the picture, world +y is to the left.
    add(
        &mut scene,
        quad([
            [2.0, 1.0, 0.0],
            [4.0, 1.0, 0.0],
            [4.0, 2.0, 0.0],
            [2.0, 2.0, 0.0],
        ]),
    );
    let mut wanted = vec!["........"; 8];
    wanted[0] = "..#.....";
    wanted[1] = "..#.....";
    assert_eq!(drawing(&truth(&scene)), wanted);
}

#[test]
fn a_reflected_actor_keeps_its_outside() {
    // An L of the screen's left half, mirrored to the right one.
    for shading in [Shading::Flat, Shading::Gouraud] {
        let mut scene = parallel(6, 3);
        scene.materials[0].shading = shading;
        let low = screen_rect([0.0, 2.0], [3.0, 3.0], 0.0);
        let high = screen_rect([0.0, 0.0], [1.0, 2.0], 0.0);
        for mesh in [low, high] {
            let actor = add(&mut scene, mesh);
            actor.origin = [3.0, 0.0, 0.0];
            actor.scale = [-1.0, 1.0, 1.0];
        }
        let truth = truth(&scene);
        assert_eq!(drawing(&truth), [".....#", ".....#", "...###"]);
        assert!(
            truth
                .pixels()
                .iter()
                .flatten()
                .all(|hit| hit.level > 254.99)
        );
    }
}

#[test]
fn a_mirrored_sphere_is_the_same_sphere() {
    let mut scene = perspective(32, 32);
    scene.camera.position = [0.0, 0.0, 10.0];
    scene.camera.focal_point = [0.0; 3];
    scene.lights = vec![white_light([-1.0, -2.0, -3.0])];
    add(&mut scene, sphere(4.0, 32, 16));
    let plain = truth(&scene);
    scene.actors[0].scale = [1.0, 1.0, -1.0];
    let mirrored = truth(&scene);
    assert_eq!(drawing(&plain), drawing(&mirrored));
    for (a, b) in plain.pixels().iter().zip(mirrored.pixels()) {
        if let (Some(a), Some(b)) = (a, b) {
            assert!((a.depth_lsb - b.depth_lsb).abs() < 120.0);
            assert!((a.level - b.level).abs() < 20.0, "{} {}", a.level, b.level);
        }
    }
}

#[test]
fn a_turntable_turns_about_the_actors_own_y() {
    // A flag to the right of its pole at x = 4; half a turn puts it left.
    let mut scene = parallel(8, 2);
    scene.materials[0].cull = fixel_scene::Cull::None;
    scene.animation.turntable = Some(8);
    add(&mut scene, screen_rect([4.0, 0.0], [6.0, 1.0], 0.0)).origin = [4.0, 0.0, 0.0];
    let row = |frame| drawing(&truth_at(&scene, frame))[0].clone();
    assert_eq!(row(0), "....##..");
    assert_eq!(row(4), "..##....");
    assert_eq!(row(8), "....##..");
    // An eighth: 2 pixels shrink to 1.41, which holds one centre; and the flag
    // points away from the eye.
    assert_eq!(row(1), "....#...");
    let depth = |frame| truth_at(&scene, frame).hit(4, 0).unwrap().depth_lsb;
    assert!(depth(1) < depth(0));
}
