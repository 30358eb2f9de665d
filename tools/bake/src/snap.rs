//! Which grid point a vertex becomes.
//!
//! A vertex that slides along the surface changes nothing that is seen but
//! where two triangles of it meet; one that leaves the surface changes depth,
//! most where the surface is steep. So of the grid points around a vertex the
//! one is taken that is least off the planes of the faces that meet there: the
//! quadric error of Garland and Heckbert, "Surface simplification using quadric
//! error metrics" (1997).

use std::collections::HashMap;

use glam::{DMat3, DVec3, IVec3};

use crate::grid::{Grid, Shifts};

/// Weight of the plain distance beside the planes': keeps a vertex from
/// sliding far where that gains little.
const SLIDE: f64 = 0.02;

/// The grid point of every vertex, a multiple of 2 to the `shifts` of its place.
/// Vertices at one place get one point.
pub(crate) fn snap(
    positions: &[DVec3],
    triangles: &[[u32; 3]],
    grid: &Grid,
    shifts: &HashMap<PlaceKey, Shifts>,
) -> Vec<IVec3> {
    let quadrics = quadrics(positions, triangles);
    positions
        .iter()
        .map(|p| {
            let exact = grid.steps(*p);
            let steps = shifts.get(&place_key(p)).copied().unwrap_or_default();
            let step = DVec3::from(steps.map(|s| f64::from(1u32 << s)));
            let nearest = (exact / step).round() * step;
            let quadric = quadrics
                .get(&place_key(p))
                .copied()
                .unwrap_or(DMat3::IDENTITY);
            let cost = |candidate: DVec3| {
                let off = candidate - exact;
                off.dot(quadric * off)
            };
            neighbours(nearest, step)
                .map(|c| (cost(c), c))
                .fold((f64::INFINITY, nearest), |best, c| {
                    if c.0 < best.0 { c } else { best }
                })
                .1
                .as_ivec3()
        })
        .collect()
}

/// The bits of a place, as a key: vertices share it, whatever else they differ in.
pub(crate) type PlaceKey = [u64; 3];

pub(crate) fn place_key(p: &DVec3) -> PlaceKey {
    // Adding 0 makes -0 and 0 one place.
    p.to_array().map(|c| (c + 0.0).to_bits())
}

/// The nearest point and those around it.
fn neighbours(nearest: DVec3, step: DVec3) -> impl Iterator<Item = DVec3> {
    let around = [0.0, -1.0, 1.0];
    around.into_iter().flat_map(move |x| {
        around
            .into_iter()
            .flat_map(move |y| around.map(move |z| nearest + step * DVec3::new(x, y, z)))
    })
}

/// For each place, what being off it costs.
fn quadrics(positions: &[DVec3], triangles: &[[u32; 3]]) -> HashMap<PlaceKey, DMat3> {
    let mut borders: HashMap<[PlaceKey; 2], i32> = HashMap::new();
    let ends = |a: u32, b: u32| {
        [
            place_key(&positions[a as usize]),
            place_key(&positions[b as usize]),
        ]
    };
    for [a, b, c] in triangles {
        for (from, to) in [(*a, *b), (*b, *c), (*c, *a)] {
            let [p, q] = ends(from, to);
            // An edge that two faces pass in opposite ways sums to 0.
            let (key, way) = if p < q { ([p, q], 1) } else { ([q, p], -1) };
            *borders.entry(key).or_default() += way;
        }
    }
    let mut quadrics: HashMap<PlaceKey, DMat3> = HashMap::new();
    let mut add = |at: PlaceKey, normal: DVec3, weight: f64| {
        let plane = DMat3::from_cols(normal * normal.x, normal * normal.y, normal * normal.z);
        *quadrics.entry(at).or_insert(DMat3::ZERO) +=
            (plane + DMat3::from_diagonal(DVec3::splat(SLIDE))) * weight;
    };
    for triangle in triangles {
        let corners = triangle.map(|v| positions[v as usize]);
        for i in 0..3 {
            let [p, q, r] = [corners[i], corners[(i + 1) % 3], corners[(i + 2) % 3]];
            let normal = (q - p).cross(r - p).normalize_or_zero();
            add(place_key(&p), normal, (q - p).angle_between(r - p));
            let [from, to] = [place_key(&p), place_key(&q)];
            let key = if from < to { [from, to] } else { [to, from] };
            if borders.get(&key) != Some(&0) {
                // The rim of an open surface is seen as an outline from all
                // around: neither off its face nor across its edge.
                let across = (q - p).cross(normal).normalize_or_zero();
                add(from, across, 2.0);
                add(to, across, 2.0);
            }
        }
    }
    quadrics
}
