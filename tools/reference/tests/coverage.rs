//! Which pixels are covered: the top-left rule, culling, the planes.

mod common;

use common::*;
use fixel_scene::{Cull, Scene};

/// Both cameras, which see the plane z = 0 alike.
fn both(width: u32, height: u32) -> [Scene; 2] {
    [parallel(width, height), perspective(width, height)]
}

#[test]
fn a_rectangle_through_pixel_centres_owns_its_top_and_left_edge() {
    for mut scene in both(8, 6) {
        add(&mut scene, screen_rect([2.5, 1.5], [6.5, 4.5], 0.0));
        let wanted = [
            "........", "..####..", "..####..", "..####..", "........", "........",
        ];
        assert_eq!(drawing(&truth(&scene)), wanted);
    }
}

#[test]
fn a_rectangle_between_pixel_centres_covers_the_centres_inside() {
    for mut scene in both(8, 6) {
        add(&mut scene, screen_rect([2.4, 1.6], [6.6, 4.4], 0.0));
        let wanted = [
            "........", "........", "..#####.", "..#####.", "........", "........",
        ];
        assert_eq!(drawing(&truth(&scene)), wanted);
    }
}

#[test]
fn slanted_edges_through_pixel_centres_belong_to_the_left_side() {
    // Right angle at the top left: left and top edge in, hypotenuse out.
    for mut scene in both(5, 5) {
        add(
            &mut scene,
            mesh(&[[[0.5, -0.5, 0.0], [0.5, -4.5, 0.0], [4.5, -0.5, 0.0]]]),
        );
        assert_eq!(
            drawing(&truth(&scene)),
            ["####.", "###..", "##...", "#....", "....."]
        );
    }
    // Right angle at the bottom right: the hypotenuse is a left edge.
    for mut scene in both(5, 5) {
        add(
            &mut scene,
            mesh(&[[[4.5, -0.5, 0.0], [0.5, -4.5, 0.0], [4.5, -4.5, 0.0]]]),
        );
        assert_eq!(
            drawing(&truth(&scene)),
            [".....", "...#.", "..##.", ".###.", "....."]
        );
    }
}

#[test]
fn rectangles_side_by_side_share_no_pixel_and_leave_none() {
    for mut scene in both(6, 4) {
        for (left, right) in [(0.5, 2.5), (2.5, 5.5)] {
            add(&mut scene, screen_rect([left, 0.5], [right, 2.5], 0.0));
        }
        let truth = truth(&scene);
        for (y, wanted) in ["aabbb.", "aabbb.", "......", "......"].iter().enumerate() {
            for (x, wanted) in wanted.chars().enumerate() {
                let (x, y) = (x as u32, y as u32);
                let seen = match truth.hit(x, y) {
                    Some(hit) => ['a', 'b'][hit.actor],
                    None => '.',
                };
                assert_eq!(seen, wanted, "pixel {x}, {y}");
                if let Some(hit) = truth.hit(x, y) {
                    assert_eq!(hit.margin_lsb, f64::INFINITY, "pixel {x}, {y}");
                }
            }
        }
    }
}

#[test]
fn a_sphere_covers_its_disc() {
    // Perspective outline of a sphere of radius r at distance d on the axis:
    // directions within asin(r / d) of the axis.
    let mut scene = perspective(96, 64);
    let (radius, slices) = (9.0, 256_u32);
    scene.camera.position = [0.0, 0.0, 20.0];
    scene.camera.focal_point = [0.0; 3];
    add(&mut scene, sphere(radius, slices, 128));
    let truth = truth(&scene);
    let inner = radius * (1.0 - 2.0 * (std::f64::consts::PI / f64::from(slices)).powi(2));
    let mut undecided = 0;
    for y in 0..64 {
        for x in 0..96 {
            let slope = [f64::from(x) + 0.5 - 48.0, f64::from(y) + 0.5 - 32.0].map(|v| v / EYE);
            let sine = 20.0 * (1.0 - 1.0 / (1.0 + slope[0].powi(2) + slope[1].powi(2))).sqrt();
            let hit = truth.hit(x, y);
            if sine < inner {
                // Nearest root of |eye + t * ray|^2 = r^2.
                let square = 1.0 + slope[0].powi(2) + slope[1].powi(2);
                let w = (20.0 - (400.0 - square * (400.0 - radius * radius)).sqrt()) / square;
                let depth = hit.unwrap_or_else(|| panic!("hole at {x}, {y}")).depth_lsb;
                let there = 65535.0 / depth;
                assert!(
                    there >= w - 1e-9 && there < w + 0.1,
                    "depth at {x}, {y}: {there}, {w}"
                );
            } else if sine > radius {
                assert!(hit.is_none(), "outside at {x}, {y}");
            } else {
                undecided += 1;
            }
        }
    }
    assert!(undecided < 8, "{undecided}");
    assert!(truth.covered_px() > 50);
}

#[test]
fn culling_leaves_out_the_side_it_names() {
    let front = || screen_rect([0.0, 0.0], [4.0, 4.0], 0.0);
    let back = || {
        quad([
            [0.0, 0.0, 0.0],
            [4.0, 0.0, 0.0],
            [4.0, -4.0, 0.0],
            [0.0, -4.0, 0.0],
        ])
    };
    for mut scene in both(4, 4) {
        for (cull, wanted) in [
            (Cull::Back, [16, 0]),
            (Cull::Front, [0, 16]),
            (Cull::None, [16; 2]),
        ] {
            scene.materials[0].cull = cull;
            for (mesh, wanted) in [front(), back()].into_iter().zip(wanted) {
                scene.actors.clear();
                add(&mut scene, mesh);
                assert_eq!(truth(&scene).covered_px(), wanted, "{cull:?}");
            }
        }
    }
}

#[test]
fn the_near_plane_cuts_between_pixel_centres() {
    // A floor that rises towards the eye and passes behind it: on a screen of
    // 10 rows the eye sees slope s below the axis at distance h / s. Height is
    // 2, and rows 5..10 look down by 0.05, 0.15 .. 0.45.
    let mut scene = perspective(10, 10);
    scene.camera.position = [0.0, 2.0, 0.0];
    scene.camera.focal_point = [0.0, 2.0, -1.0];
    scene.camera.clipping_range = [5.0, 30.0];
    let floor = [
        [-90.0, 0.0, 90.0],
        [90.0, 0.0, 90.0],
        [90.0, 0.0, -90.0],
        [-90.0, 0.0, -90.0],
    ];
    add(&mut scene, quad(floor));
    let truth = truth(&scene);
    for (row, distance) in [40.0, 2.0 / 0.15, 8.0, 2.0 / 0.35, 2.0 / 0.45]
        .iter()
        .enumerate()
    {
        for x in 0..10 {
            let hit = truth.hit(x, 5 + row as u32);
            let seen = (5.0..=30.0).contains(distance);
            assert_eq!(hit.is_some(), seen, "row {row}");
            if let Some(hit) = hit {
                assert!(
                    (hit.depth_lsb - 65535.0 * 5.0 / distance).abs() < 1e-2,
                    "row {row}"
                );
            }
        }
    }
    assert_eq!(truth.covered_px(), 30);
}

#[test]
fn the_near_plane_opens_a_box() {
    // Looking at a box whose front face is nearer than the near plane: with
    // back faces drawn, its far face shows.
    let mut scene = parallel(4, 4);
    scene.materials[0].cull = Cull::None;
    scene.camera.clipping_range = [8.0, 21.0];
    add(&mut scene, screen_rect([0.0, 0.0], [4.0, 4.0], 3.0));
    add(&mut scene, screen_rect([0.0, 0.0], [4.0, 4.0], -3.0));
    let truth = truth(&scene);
    assert!(
        truth
            .pixels()
            .iter()
            .all(|p| p.is_some_and(|hit| hit.actor == 1))
    );
}

#[test]
fn the_background_runs_from_top_to_bottom() {
    let mut scene = parallel(1, 4);
    scene.display.background = fixel_scene::Background::Gradient {
        top: [0.0, 1.0, 0.5],
        bottom: [1.0, 0.0, 0.5],
    };
    let rows: Vec<_> = truth(&scene).colours().collect();
    assert_eq!(
        rows,
        [0.125, 0.375, 0.625, 0.875].map(|t| [t, 1.0 - t, 0.5])
    );
}
