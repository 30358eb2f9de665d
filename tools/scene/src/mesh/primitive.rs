//! Meshes that a scene file gives by numbers: spheres, rectangles and polygons.

use std::collections::HashMap;

use earcut::Earcut;
use earcut::utils3d::project3d_to_2d;
use glam::DVec3;

use super::finish::finish;
use super::{Refusal, Soup, polygon as polygons};
use crate::description::{Mesh, Primitive};

/// A sphere about the origin: an icosahedron whose triangles are divided into
/// four `detail` times, all vertices on the sphere, with the sphere's normals.
pub(crate) fn sphere(radius: f64, detail: u32) -> Mesh {
    let (mut directions, mut triangles) = icosahedron();
    for _ in 0..detail {
        let mut middles = HashMap::new();
        let mut finer = Vec::with_capacity(4 * triangles.len());
        for [a, b, c] in triangles {
            let mut middle = |p: u32, q: u32| {
                *middles.entry(polygons::sorted([p, q])).or_insert_with(|| {
                    let sum = directions[p as usize] + directions[q as usize];
                    directions.push(sum.normalize());
                    directions.len() as u32 - 1
                })
            };
            let [ab, bc, ca] = [middle(a, b), middle(b, c), middle(c, a)];
            finer.extend([[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]]);
        }
        triangles = finer;
    }
    let mut seen = std::collections::HashSet::new();
    let sides = triangles.iter().flat_map(|t| polygons::sides(*t));
    let edges = sides.filter(|side| seen.insert(polygons::sorted(*side)));
    Mesh {
        name: format!("sphere {radius} {detail}"),
        edges: edges.collect(),
        positions: directions.iter().map(|d| (*d * radius).into()).collect(),
        normals: directions.iter().map(|d| (*d).into()).collect(),
        triangles,
        primitive: Some(Primitive::Sphere { radius }),
        ..Mesh::default()
    }
}

/// A rectangle in the plane y = 0 that faces +y, cut into 2 to the power of `detail`
/// cells each way, of two triangles each.
pub(crate) fn rectangle([width, depth]: [f64; 2], detail: u32) -> Mesh {
    let cells = 1_u32 << detail;
    let places = || (0..=cells).map(|i| f64::from(i) / f64::from(cells));
    let coordinates: Vec<[f64; 2]> = places()
        .flat_map(|v| places().map(move |u| [u, v]))
        .collect();
    let vertex = |column: u32, row: u32| row * (cells + 1) + column;
    let mut triangles = Vec::new();
    let mut edges = Vec::new();
    for (row, column) in (0..=cells).flat_map(|row| (0..=cells).map(move |c| (row, c))) {
        let here = vertex(column, row);
        let [right, up] = [vertex(column + 1, row), vertex(column, row + 1)];
        if column < cells {
            edges.push([here, right]);
        }
        if row < cells {
            edges.push([here, up]);
        }
        if column < cells && row < cells {
            let across = vertex(column + 1, row + 1);
            triangles.extend([[here, right, across], [here, across, up]]);
        }
    }
    Mesh {
        name: format!("rectangle {width} {depth} {detail}"),
        positions: coordinates
            .iter()
            .map(|[u, v]| [(u - 0.5) * width, 0.0, (0.5 - v) * depth])
            .collect(),
        normals: vec![[0.0, 1.0, 0.0]; coordinates.len()],
        texture_coordinates: coordinates,
        triangles,
        edges,
        primitive: Some(Primitive::Rectangle { width, depth }),
        ..Mesh::default()
    }
}

/// Corners of length 1, and faces that are counter-clockwise from outside.
fn icosahedron() -> (Vec<DVec3>, Vec<[u32; 3]>) {
    let golden = (1.0 + 5.0_f64.sqrt()) / 2.0;
    let mut corners = Vec::new();
    for (a, b) in [
        (-1.0, golden),
        (1.0, golden),
        (-1.0, -golden),
        (1.0, -golden),
    ] {
        corners.push(DVec3::new(a, b, 0.0));
    }
    for (a, b) in [
        (-1.0, golden),
        (1.0, golden),
        (-1.0, -golden),
        (1.0, -golden),
    ] {
        corners.push(DVec3::new(0.0, a, b));
    }
    for (a, b) in [
        (-1.0, golden),
        (1.0, golden),
        (-1.0, -golden),
        (1.0, -golden),
    ] {
        corners.push(DVec3::new(b, 0.0, a));
    }
    let faces = [
        [0, 11, 5],
        [0, 5, 1],
        [0, 1, 7],
        [0, 7, 10],
        [0, 10, 11],
        [1, 5, 9],
        [5, 11, 4],
        [11, 10, 2],
        [10, 7, 6],
        [7, 1, 8],
        [3, 9, 4],
        [3, 4, 2],
        [3, 2, 6],
        [3, 6, 8],
        [3, 8, 9],
        [4, 9, 5],
        [2, 4, 11],
        [6, 2, 10],
        [8, 6, 7],
        [9, 8, 1],
    ];
    let corners = corners.into_iter().map(DVec3::normalize).collect();
    (corners, faces.to_vec())
}

/// A flat polygon with holes, seen from the side from which its outline goes
/// round counter-clockwise; the holes may go either way. A corner off the
/// outline's plane is taken as it is: the surface bends there.
pub(crate) fn polygon(outline: &[[f64; 3]], holes: &[Vec<[f64; 3]>]) -> Result<Mesh, String> {
    let mut corners = outline.to_vec();
    let mut starts = Vec::new();
    for hole in holes {
        starts.push(corners.len() as u32);
        corners.extend(hole);
    }
    let (mut flat, mut indices) = (Vec::new(), Vec::new());
    if !project3d_to_2d(&corners, outline.len(), &mut flat) {
        return Err("has no area".to_owned());
    }
    Earcut::new().earcut(flat.iter().copied(), &starts, &mut indices);
    let (triangles, _) = indices.as_chunks::<3>();
    // The crate gives them clockwise or not, as it finds them.
    let area = |[a, b, c]: [u32; 3]| {
        let [[ax, ay], [bx, by], [cx, cy]] = [a, b, c].map(|i| flat[i as usize]);
        (bx - ax) * (cy - ay) - (cx - ax) * (by - ay)
    };
    let upright = |[a, b, c]: [u32; 3]| {
        if area([a, b, c]) < 0.0 {
            [a, c, b]
        } else {
            [a, b, c]
        }
    };
    let triangles: Vec<[u32; 3]> = triangles.iter().map(|t| upright(*t)).collect();
    let ring_sizes: Vec<usize> = std::iter::once(outline.len())
        .chain(holes.iter().map(Vec::len))
        .collect();
    let mut edges = Vec::new();
    for size in &ring_sizes {
        let (start, size) = (edges.len() as u32, *size as u32);
        edges.extend((0..size).map(|i| [start + i, start + (i + 1) % size]));
    }
    let mut remaining = edges.as_slice();
    let covered: f64 = triangles.iter().map(|t| area(*t)).sum();
    let ring_area = |side: &[u32; 2]| {
        let [[ax, ay], [bx, by]] = side.map(|i| flat[i as usize]);
        ax * by - bx * ay
    };
    let mut rings = ring_sizes.iter().map(|size| {
        let (ring, rest) = remaining.split_at(*size);
        remaining = rest;
        ring.iter().map(ring_area).sum::<f64>().abs()
    });
    let whole = rings.next().unwrap_or(0.0) - rings.sum::<f64>();
    if (covered - whole).abs() > 1e-6 * whole.abs() {
        return Err("crosses itself, or a hole is not inside".to_owned());
    }
    let soup_positions = corners.clone();
    let soup = Soup {
        normals: vec![None; corners.len()],
        positions: corners,
        triangles,
        ..Soup::default()
    };
    let loaded = finish("polygon", soup).map_err(|refusal: Refusal| refusal.message)?;
    let mut mesh = loaded.mesh;
    // A corner that lies on a straight line is in no triangle, but an end of
    // edges.
    let normal = mesh.normals.first().copied().unwrap_or_default();
    let mut vertex = |corner: u32| {
        let place = soup_positions[corner as usize];
        let known = mesh.positions.iter().position(|p| *p == place);
        known.unwrap_or_else(|| {
            mesh.positions.push(place);
            mesh.normals.push(normal);
            mesh.positions.len() - 1
        }) as u32
    };
    mesh.edges = edges.iter().map(|edge| edge.map(&mut vertex)).collect();
    Ok(mesh)
}
