use std::path::Path;

use glam::DVec3;

use super::*;

fn load(name: &str) -> Mesh {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes/meshes");
    fixel_scene::load_mesh(&folder.join(name)).unwrap()
}

/// Sides of triangles, by the places of their ends, that have no triangle on their other side.
fn borders(mesh: &Mesh) -> Vec<[[u64; 3]; 2]> {
    let place = |v: u32| mesh.positions[v as usize].map(|c| (c + 0.0).to_bits());
    let sides = mesh
        .triangles
        .iter()
        .flat_map(|[a, b, c]| [[*a, *b], [*b, *c], [*c, *a]]);
    let sides: Vec<[[u64; 3]; 2]> = sides.map(|side| side.map(place)).collect();
    let all: std::collections::HashSet<_> = sides.iter().copied().collect();
    let is_border = |[from, to]: &[[u64; 3]; 2]| !all.contains(&[*to, *from]);
    sides.into_iter().filter(is_border).collect()
}

fn volume(mesh: &Mesh) -> f64 {
    let corner = |v: u32| DVec3::from(mesh.positions[v as usize]);
    let each = mesh.triangles.iter().map(|t| {
        let [a, b, c] = t.map(corner);
        a.dot(b.cross(c)) / 6.0
    });
    each.sum()
}

/// A net of `n` by `n` squares in the plane, bent by `height`, with texture coordinates and
/// a seam in the middle: a square's own picture on each half.
fn net(n: u32, height: impl Fn(f64, f64) -> f64) -> Mesh {
    let mut mesh = Mesh::default();
    let part = |i: u32| f64::from(i) / f64::from(n);
    for half in 0..2 {
        let first = mesh.positions.len() as u32;
        let columns = n / 2 + 1;
        for row in 0..=n {
            for column in 0..columns {
                let (x, z) = (part(column + half * n / 2), part(row));
                mesh.positions.push([x, height(x, z), z]);
                mesh.normals.push([0.0, 1.0, 0.0]);
                // The right half's picture is turned over.
                let u = if half == 0 { x } else { 5.0 - x };
                mesh.texture_coordinates.push([u, z]);
            }
        }
        for row in 0..n {
            for column in 0..columns - 1 {
                let a = first + row * columns + column;
                let (b, c, d) = (a + 1, a + columns, a + columns + 1);
                mesh.triangles.extend([[a, c, b], [b, c, d]]);
            }
        }
    }
    mesh
}

#[test]
fn each_level_has_half_the_triangles_and_is_as_near_as_it_says() {
    for (name, half_off, last) in [("bunny.obj", 0.006, 0.1), ("suzanne.glb", 0.004, 0.1)] {
        let mesh = load(name);
        let size = Surface::new(&mesh, true).length(1.0);
        let original = Surroundings::new(&mesh);
        let levels = levels(&mesh, true);
        assert!(levels.len() >= 4, "{name}: {} levels", levels.len());
        assert!(
            levels[0].error < half_off * size,
            "{name}: {}",
            levels[0].error
        );
        let mut before = mesh.triangles.len();
        let mut error = 0.0;
        for level in &levels {
            let now = level.mesh.triangles.len();
            assert!(
                now <= before / 2 && now * 5 > before * 2,
                "{name}: {now} of {before}"
            );
            assert!(level.error >= error && level.error <= last * size);
            (before, error) = (now, level.error);
            // Denser than it was measured, either way.
            let places = 10 * mesh.triangles.len();
            let there = original.farthest(&level.mesh, places);
            let back = Surroundings::new(&level.mesh).farthest(&mesh, places);
            let found = there.max(back);
            assert!(
                found <= level.error,
                "{name}, {now}: {found}, {}",
                level.error
            );
        }
    }
}

#[test]
fn what_is_closed_stays_closed_and_as_large() {
    for name in ["sphere.obj", "ring_coloured.ply"] {
        let mesh = load(name);
        assert!(borders(&mesh).is_empty());
        for level in levels(&mesh, true) {
            assert!(borders(&level.mesh).is_empty(), "{name}");
            let lost = (volume(&level.mesh) / volume(&mesh) - 1.0).abs();
            let size = Surface::new(&mesh, true).length(1.0);
            assert!(lost < 5.0 * level.error / size, "{name}: {lost}");
            let long = |n: &[f64; 3]| (DVec3::from(*n).length() - 1.0).abs() < 1e-9;
            assert!(level.mesh.normals.iter().all(long));
        }
    }
}

#[test]
fn borders_and_seams_stay_lines() {
    let mesh = net(24, |_, _| 0.0);
    let levels = levels(&mesh, true);
    let coarsest = levels.last().unwrap();
    // Flat, with a picture that lies on it evenly: nothing is lost.
    assert!(coarsest.error < 1e-9, "{}", coarsest.error);
    assert!(coarsest.mesh.triangles.len() < 160);
    for [from, to] in borders(&coarsest.mesh) {
        let end = |bits: [u64; 3]| bits.map(f64::from_bits);
        let ([x0, _, z0], [x1, _, z1]) = (end(from), end(to));
        let on = |a: f64, b: f64| a == b && (a == 0.0 || a == 1.0);
        assert!(on(x0, x1) || on(z0, z1), "{x0} {z0} {x1} {z1}");
    }
    let all = coarsest.mesh.positions.iter();
    for ([x, _, z], [u, v]) in all.zip(&coarsest.mesh.texture_coordinates) {
        let (left, right) = ((u - x).abs() < 1e-9, (u - 5.0 + x).abs() < 1e-9);
        assert!((left && *x <= 0.5 || right && *x >= 0.5) && (v - z).abs() < 1e-9);
    }
}

#[test]
fn a_small_mesh_has_no_levels_and_one_that_is_all_creases_none_either() {
    assert!(levels(&load("cube.obj"), true).is_empty());
    // Each face with a normal of its own.
    let sphere = load("sphere.obj");
    let mut mesh = Mesh::default();
    for triangle in &sphere.triangles {
        let corners = triangle.map(|v| sphere.positions[v as usize]);
        let [p, q, r] = corners.map(DVec3::from);
        let first = mesh.positions.len() as u32;
        mesh.positions.extend(corners);
        let normal = (q - p).cross(r - p).normalize().to_array();
        mesh.normals.extend([normal; 3]);
        mesh.triangles.push([first, first + 1, first + 2]);
    }
    assert!(levels(&mesh, true).is_empty());
    // Where normals do not show, they are no creases.
    assert!(levels(&mesh, false).len() >= 3);
}
