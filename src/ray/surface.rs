//! The surface where a ray meets an actor.

use super::actor::RayActor;
use super::grid_ray::GridRay;
use super::ray::Ray;
use super::triangle::{Points, TriangleHit};
use crate::light::vertex_normal;
use crate::math::{Unit3, mul_q30, product, unit};
use crate::scene::{Mesh, Meshlet, Record, Scene};

/// A point of a surface.
#[derive(Clone, Copy, Debug)]
pub(super) struct Surface {
    /// Raw world bits.
    pub place: [i32; 3],
    /// The face's normal, outward.
    pub face: Unit3,
    /// The normal that it is lit with.
    pub normal: Unit3,
    /// The vertex colour.
    pub tint: Option<[u8; 3]>,
    /// Texture coordinates as the mesh has them, 8 fractional bits.
    pub coordinates: Option<[i32; 2]>,
    /// Seen from behind.
    pub back: bool,
}

/// What a surface is wanted for.
#[derive(Clone, Copy, Debug)]
pub(super) struct Need {
    /// The face's normal.
    pub face: bool,
    /// It is lit with the face's normal.
    pub flat: bool,
}

impl RayActor {
    /// The surface where a ray meets one of its triangles.
    #[inline(never)]
    pub(super) fn surface(
        &self,
        scene: &Scene<'_>,
        ray: &Ray,
        grid: &GridRay,
        hit: &TriangleHit,
        need: Need,
    ) -> Option<Surface> {
        let mesh = scene.mesh(self.mesh);
        let words = scene.meshlets_of(&mesh).get(hit.meshlet as usize)?;
        let meshlet = Meshlet::from_words(words);
        let points = Points::new(scene, &mesh, meshlet, &grid.from);
        let corners = points.corners(hit.triangle);
        let [a, b, c] = corners.map(|corner| points.off(corner));
        let (ab, ac) = (minus(b, a), minus(c, a));
        let [second, third] = hit.weights;
        let mut off = a;
        for ((off, b), c) in off.iter_mut().zip(ab).zip(ac) {
            let along = mul_q30(second, b).wrapping_add(mul_q30(third, c));
            *off = off.wrapping_add(along);
        }
        let mut place = ray.origin;
        let way = self.vector_to_world(off, grid.from.fraction);
        for (c, w) in place.iter_mut().zip(way) {
            *c = c.saturating_add(w);
        }
        let face = if need.face || need.flat {
            let in_grid = unit(cross(ab, ac))?.0;
            self.direction_to_world(in_grid).map(|c| c << 2)
        } else {
            [0; 3]
        };
        let normal = if need.flat {
            face
        } else {
            let all = scene.meshlet_vertices(&meshlet);
            let fine = scene.meshlet_fine(&meshlet, &mesh);
            // 14 fractional bits each, and 16 of the weights.
            let weights = [(1 << 30) - second - third, second, third].map(|w| w >> 14);
            let mut sum = [0; 3];
            for (corner, weight) in corners.into_iter().zip(weights) {
                let [.., code] = all.get(corner).copied().unwrap_or_default();
                let low = fine.get(corner).map(|[.., low]| *low);
                let normal = vertex_normal(i16::from_le(code), low);
                for (sum, c) in sum.iter_mut().zip(normal) {
                    *sum += c * weight;
                }
            }
            let in_grid = unit(sum).map_or([0, 0, 1 << 30], |(unit, _)| unit);
            self.direction_to_world(in_grid).map(|c| c << 2)
        };
        let colours = scene.meshlet_colours(&meshlet, &mesh);
        let colour = |corner: usize| colours.get(corner).copied();
        let tint = match corners.map(colour) {
            [Some(a), Some(b), Some(c)] => {
                let [a, b, c] = [a, b, c].map(|[r, g, b, _]| [r, g, b].map(i32::from));
                Some(between(a, b, c, hit.weights).map(|c| ((c + 128) >> 8).clamp(0, 255) as u8))
            }
            _ => None,
        };
        let coordinates = coordinates(scene, &mesh, &meshlet, corners, hit.weights);
        Some(Surface {
            place,
            face,
            normal,
            tint,
            coordinates,
            back: hit.back,
        })
    }
}

/// Texture coordinates between a triangle's corners as the mesh has them, 8 fractional bits.
pub(super) fn coordinates(
    scene: &Scene<'_>,
    mesh: &Mesh,
    meshlet: &Meshlet,
    corners: [usize; 3],
    weights: [i32; 2],
) -> Option<[i32; 2]> {
    let all = scene.meshlet_coordinates(meshlet, mesh);
    let own = |corner: usize| {
        all.get(corner)
            .map(|uv| uv.map(|c| i32::from(i16::from_le(c))))
    };
    match corners.map(own) {
        [Some(a), Some(b), Some(c)] => Some(between(a, b, c, weights)),
        _ => None,
    }
}

/// Values of up to 16 bits between three corners, 8 fractional bits.
fn between<const N: usize>(
    a: [i32; N],
    b: [i32; N],
    c: [i32; N],
    [second, third]: [i32; 2],
) -> [i32; N] {
    let mut out = a;
    for ((out, b), c) in out.iter_mut().zip(b).zip(c) {
        let along = mul_q30(second, (b - *out) << 8) + mul_q30(third, (c - *out) << 8);
        *out = (*out << 8) + along;
    }
    out
}

fn minus([ax, ay, az]: [i32; 3], [bx, by, bz]: [i32; 3]) -> [i32; 3] {
    [
        ax.wrapping_sub(bx),
        ay.wrapping_sub(by),
        az.wrapping_sub(bz),
    ]
}

/// The cross product of two vectors, brought to 30 bits.
fn cross(a: [i32; 3], b: [i32; 3]) -> [i32; 3] {
    let ([ax, ay, az], [bx, by, bz]) = (a, b);
    // 31 bits by 31.
    let area = |p: i32, q: i32, r: i32, s: i32| product(p, q).wrapping_sub(product(r, s));
    let wide = [
        area(ay, bz, az, by),
        area(az, bx, ax, bz),
        area(ax, by, ay, bx),
    ];
    let most = wide.iter().fold(1, |m, c| m | c.unsigned_abs());
    let down = 34u32.saturating_sub(most.leading_zeros());
    wide.map(|c| (c >> down) as i32)
}
