//! The surface where a ray meets an actor.

use super::actor::RayActor;
use super::facet::{Facet, Need};
use super::grid_ray::GridRay;
use super::ray::Ray;
use super::triangle::TriangleHit;
use crate::math::{Unit3, mul_q30, unit_vector};
use crate::scene::{Mesh, Meshlet, Record, Scene};

/// A point of a surface.
#[derive(Clone, Copy, Debug)]
pub(super) struct Surface {
    /// Raw world bits; of a triangle, the ray's start where nobody asks for the place.
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

impl RayActor {
    /// The surface where a ray meets one of its triangles, which is `kept` for the next.
    #[inline(never)]
    pub(super) fn surface(
        &self,
        scene: &Scene<'_>,
        ray: &Ray,
        (grid, hit): (&GridRay, &TriangleHit),
        need: Need,
        kept: &mut Facet,
    ) -> Option<Surface> {
        let facet = kept.find((scene, self), &grid.from, hit, need)?;
        let [second, third] = hit.weights;
        let mut place = ray.origin;
        if need.place {
            let [ab, ac] = facet.edges;
            let mut off = facet.off(&grid.from);
            for ((off, b), c) in off.iter_mut().zip(ab).zip(ac) {
                let along = mul_q30(second, b).wrapping_add(mul_q30(third, c));
                *off = off.wrapping_add(along);
            }
            let way = self.vector_to_world(off, grid.from.fraction);
            for (c, w) in place.iter_mut().zip(way) {
                *c = c.saturating_add(w);
            }
        }
        let normal = if need.flat {
            facet.face
        } else {
            // 14 fractional bits each, and 16 of the weights.
            let weights = [(1 << 30) - second - third, second, third].map(|w| w >> 14);
            let mut sum = [0; 3];
            for (normal, weight) in facet.normals.into_iter().zip(weights) {
                for (sum, c) in sum.iter_mut().zip(normal) {
                    *sum += i32::from(c) * weight;
                }
            }
            let in_grid = unit_vector(sum).unwrap_or([0, 0, 1 << 30]);
            self.direction_to_world(in_grid).map(|c| c << 2)
        };
        let (tint, coordinates) = if facet.is_plain {
            (None, None)
        } else {
            self.painted(scene, hit, facet.corners.map(usize::from))
        };
        Some(Surface {
            place,
            face: facet.face,
            normal,
            tint,
            coordinates,
            back: hit.back,
        })
    }

    /// The colour and the texture coordinates where a triangle is met.
    #[inline(never)]
    fn painted(
        &self,
        scene: &Scene<'_>,
        hit: &TriangleHit,
        corners: [usize; 3],
    ) -> (Option<[u8; 3]>, Option<[i32; 2]>) {
        let mesh = scene.mesh(self.mesh);
        let Some(words) = scene.meshlets_of(&mesh).get(hit.meshlet as usize) else {
            return (None, None);
        };
        let meshlet = Meshlet::from_words(words);
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
        (tint, coordinates)
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
