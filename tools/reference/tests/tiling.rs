//! Triangles that share edges: no pixel twice, none left out.

mod common;

use common::*;
use fixel_reference::Truth;
use fixel_scene::{Cull, Mesh, Scene};
use proptest::prelude::*;

const SIZE: u32 = 16;

/// How many of the actor's triangles are met at a pixel, hidden ones too.
fn met(truth: &Truth, triangles: usize, x: u32, y: u32) -> usize {
    (0..triangles)
        .filter(|t| truth.depth_of_lsb(0, *t, x, y).is_some())
        .count()
}

/// A point that the perspective camera sees at a screen position in pixels, at
/// distance `w`, which may be behind it.
fn behind_screen([x, y]: [f64; 2], w: f64) -> [f64; 3] {
    let half = f64::from(SIZE) / 2.0;
    let scale = w / EYE;
    [
        half + (x - half) * scale,
        -half - (y - half) * scale,
        EYE - w,
    ]
}

fn with_mesh(mut scene: Scene, mesh: Mesh) -> Scene {
    scene.materials[0].cull = Cull::None;
    scene.camera.clipping_range = [1e-3, 1e6];
    add(&mut scene, mesh);
    scene
}

/// Screen positions: anywhere, or on the grid of pixel centres.
fn position() -> impl Strategy<Value = [f64; 2]> {
    let anywhere = -4.0..20.0;
    let centre = (-4_i32..20).prop_map(|v| f64::from(v) + 0.5);
    prop_oneof![[anywhere.clone(), anywhere], [centre.clone(), centre]]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]

    #[test]
    fn two_triangles_that_share_an_edge(
        [a, b, c, d] in [position(), position(), position(), position()],
        w in [0.5..30.0, 0.5..30.0, 0.5..30.0, 0.5..30.0],
        in_perspective: bool,
    ) {
        // c and d on either side of the line a b.
        let side = |p: [f64; 2]| (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]);
        prop_assume!(side(c) * side(d) < 0.0);
        let corners = [a, b, c, d];
        let mut mesh = Mesh {
            name: "two".into(),
            positions: (0..4).map(|i| behind_screen(corners[i], w[i])).collect(),
            normals: vec![[0.0, 0.0, 1.0]; 4],
            triangles: vec![[0, 1, 2], [0, 1, 3]],
            ..Mesh::default()
        };
        if !in_perspective {
            for (position, corner) in mesh.positions.iter_mut().zip(corners) {
                (position[0], position[1]) = (corner[0], -corner[1]);
            }
        }
        let camera = if in_perspective { perspective(SIZE, SIZE) } else { parallel(SIZE, SIZE) };
        let mut scene = with_mesh(camera, mesh);
        if !in_perspective {
            scene.camera.clipping_range = [-1e3, 1e3];
        }
        let truth = truth(&scene);
        for y in 0..SIZE {
            for x in 0..SIZE {
                let count = met(&truth, 2, x, y);
                prop_assert!(count <= 1, "pixel {x}, {y} is in both");
                prop_assert_eq!(truth.hit(x, y).is_some(), count == 1);
                // On the open segment between a and b, one of them has it.
                let p = [f64::from(x) + 0.5, f64::from(y) + 0.5];
                let along = |q: [f64; 2]| (q[0] - a[0]) * (b[0] - a[0]) + (q[1] - a[1]) * (b[1] - a[1]);
                let within = along(p) > 1e-3 * along(b) && along(p) < (1.0 - 1e-3) * along(b);
                if side(p) == 0.0 && within && side(c).abs().min(side(d).abs()) > 0.1 {
                    prop_assert_eq!(count, 1, "pixel {}, {} on the edge is in none", x, y);
                }
            }
        }
    }

    #[test]
    fn a_mesh_over_the_whole_screen_has_each_pixel_once(
        jitter in proptest::collection::vec(position(), 36),
        w in proptest::collection::vec(0.5..30.0, 36),
        on_centres: bool,
    ) {
        // A grid of 6 x 6 vertices, 4 pixels apart, each moved by up to 1 pixel
        // and put at a distance of its own. The outermost stay outside.
        let mut mesh = Mesh { name: "grid".into(), ..Mesh::default() };
        for (i, (move_by, w)) in jitter.iter().zip(&w).enumerate() {
            let grid = [i % 6, i / 6].map(|v| 4.0 * v as f64 - 2.0);
            let at = std::array::from_fn(|k| {
                let moved = grid[k] + move_by[k] / 20.0;
                if on_centres { moved.floor() + 0.5 } else { moved }
            });
            mesh.positions.push(behind_screen(at, *w));
        }
        mesh.normals = vec![[0.0, 0.0, 1.0]; 36];
        for i in (0..30).filter(|i| i % 6 < 5) {
            let [a, b, c, d] = [i, i + 1, i + 7, i + 6];
            // Either diagonal, by chance.
            if jitter[i as usize][0] < 8.0 {
                mesh.triangles.extend([[a, b, c], [a, c, d]]);
            } else {
                mesh.triangles.extend([[a, b, d], [b, c, d]]);
            }
        }
        let truth = truth(&with_mesh(perspective(SIZE, SIZE), mesh));
        for y in 0..SIZE {
            for x in 0..SIZE {
                prop_assert_eq!(met(&truth, 50, x, y), 1, "pixel {}, {}", x, y);
                prop_assert!(truth.hit(x, y).is_some(), "pixel {x}, {y}");
            }
        }
    }
}

#[test]
fn a_mesh_that_reaches_behind_the_eye_has_no_holes() {
    // A closed ball around the eye, seen from inside: every ray leaves it once.
    let mut scene = perspective(64, 64);
    scene.camera.projection = fixel_scene::Projection::Perspective { view_angle: 150.0 };
    scene.camera.position = [0.3, 0.2, 0.1];
    scene.camera.focal_point = [1.0, 2.0, 3.0];
    scene.camera.clipping_range = [1e-3, 1e3];
    scene.materials[0].cull = Cull::Front;
    add(&mut scene, sphere(5.0, 24, 12));
    let triangles = scene.meshes[0].triangles.len();
    let truth = truth(&scene);
    for y in 0..64 {
        for x in 0..64 {
            assert_eq!(met(&truth, triangles, x, y), 1, "pixel {x}, {y}");
        }
    }
}
