//! A ray and a triangle.

use super::actor::GridPlace;
use super::faces::Faces;
use super::grid_ray::GridRay;
use crate::math::{mul_high, mul_high_u, product, reciprocal};
use crate::scene::{Mesh, Meshlet, Scene};

/// Where a ray meets a triangle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct TriangleHit {
    /// How far along the ray, in units of the sheared space's third axis.
    pub ahead: i32,
    /// The second and the third corner's weights, Q30.
    pub weights: [i32; 2],
    /// The meshlet, counted in the mesh.
    pub meshlet: u32,
    /// The triangle, counted in the meshlet.
    pub triangle: u8,
    /// Whether it is seen from behind.
    pub back: bool,
}

impl TriangleHit {
    /// Whether it comes before another one: where both are as far, the triangle's number
    /// decides, so that the way through the hierarchy does not.
    pub(super) fn before(&self, other: &Self) -> bool {
        let key = |hit: &Self| (hit.ahead, hit.meshlet, hit.triangle);
        key(self) < key(other)
    }
}

/// A triangle's corners as they are off a place.
pub(super) type Corners = [[i32; 3]; 3];

/// A meshlet's vertices as they are off a place.
#[derive(Clone, Copy, Debug)]
pub(super) struct Points<'a> {
    vertices: &'a [[i16; 4]],
    fine: &'a [[u8; 4]],
    triangles: &'a [[u8; 3]],
    /// The meshlet's base in the place's units, off it; if steps are finer than these, in steps
    /// and not off it.
    base: [i32; 3],
    /// Left shifts of a vertex' components, and of their low bits.
    shifts: [u32; 3],
    left: u32,
    /// Right shift to the place's units, where steps are finer, and the place.
    right: u32,
    from: [i32; 3],
}

impl<'a> Points<'a> {
    #[inline(always)]
    pub(super) fn new(scene: &Scene<'a>, mesh: &Mesh, meshlet: Meshlet, from: &GridPlace) -> Self {
        let left = from.fraction.max(0) as u32;
        let right = from.fraction.wrapping_neg().clamp(0, 31) as u32;
        let mut base = meshlet.base;
        if right == 0 {
            for (c, from) in base.iter_mut().zip(from.place) {
                *c = c.wrapping_shl(left).wrapping_sub(from);
            }
        }
        Self {
            vertices: scene.meshlet_vertices(&meshlet),
            fine: scene.meshlet_fine(&meshlet, mesh),
            triangles: scene.meshlet_triangles(&meshlet),
            base,
            shifts: meshlet.shifts.map(|shift| u32::from(shift) + left),
            left,
            right,
            from: from.place,
        }
    }

    /// The corners' numbers.
    #[inline(always)]
    pub(super) fn corners(&self, triangle: u8) -> [usize; 3] {
        let corners = self.triangles.get(usize::from(triangle)).copied();
        corners.unwrap_or_default().map(usize::from)
    }

    /// A triangle as it is off the place.
    #[inline(always)]
    pub(super) fn triangle(&self, number: u8) -> Corners {
        let [a, b, c] = self.corners(number);
        [self.off(a), self.off(b), self.off(c)]
    }

    /// A vertex as it is off the place, in its units.
    #[inline(always)]
    pub(super) fn off(&self, number: usize) -> [i32; 3] {
        let [x, y, z, _] = self.vertices.get(number).copied().unwrap_or_default();
        let ([bx, by, bz], [sx, sy, sz]) = (self.base, self.shifts);
        let along = |base: i32, own: i16, shift: u32| {
            base.wrapping_add(i32::from(i16::from_le(own)).wrapping_shl(shift))
        };
        let mut off = [along(bx, x, sx), along(by, y, sy), along(bz, z, sz)];
        if let Some(fine) = self.fine.get(number) {
            for (c, low) in off.iter_mut().zip(fine) {
                *c = c.wrapping_add(i32::from(*low).wrapping_shl(self.left));
            }
        }
        if self.right != 0 {
            for (c, from) in off.iter_mut().zip(self.from) {
                *c = (*c >> self.right).wrapping_sub(from);
            }
        }
        off
    }
}

/// Where a ray meets a triangle of some points between `nearest` and `farthest`.
#[inline(always)]
pub(super) fn meet(
    ray: &GridRay,
    points: &Points<'_>,
    number: (u32, u8),
    faces: Faces,
    range: (i32, i32),
) -> Option<TriangleHit> {
    meet_corners(ray, &points.triangle(number.1), number, faces, range)
}

/// The same of a triangle's corners as they are off the ray's start.
#[inline(always)]
pub(super) fn meet_corners(
    ray: &GridRay,
    &[a, b, c]: &Corners,
    (meshlet, triangle): (u32, u8),
    faces: Faces,
    (nearest, farthest): (i32, i32),
) -> Option<TriangleHit> {
    let vertex = |corner: [i32; 3]| ray.sheared(ray.in_order(corner));
    let (a, b, c) = (vertex(a), vertex(b), vertex(c));
    let ([ax, ay, az], [bx, by, bz], [cx, cy, cz]) = (a, b, c);
    // All to one side of the ray.
    if (ax & bx & cx | all_above(ax, bx, cx)) < 0 {
        return None;
    }
    if (ay & by & cy | all_above(ay, by, cy)) < 0 {
        return None;
    }
    // Twice the areas that the ray forms with the edges: 31 bits by 31.
    let area = |px: i32, py: i32, qx: i32, qy: i32| product(px, qy).wrapping_sub(product(qx, py));
    let u = area(bx, by, cx, cy);
    let v = area(cx, cy, ax, ay);
    let w = area(ax, ay, bx, by);
    let counter_clockwise = (u | v | w) >= 0;
    if !counter_clockwise && (u > 0 || v > 0 || w > 0) {
        return None;
    }
    let whole = u.wrapping_add(v).wrapping_add(w);
    let back = counter_clockwise == ray.up;
    if whole == 0 || !(if back { faces.back } else { faces.front }) {
        return None;
    }
    let weights = weights(whole.unsigned_abs(), [v, w].map(i64::unsigned_abs));
    let [second, third] = weights;
    // Q31 and a bit less of the result.
    let part = |weight: i32, from: i32, to: i32| {
        mul_high(weight << 1, to.wrapping_sub(from)).wrapping_shl(1)
    };
    let z = az
        .wrapping_add(part(second, az, bz))
        .wrapping_add(part(third, az, cz));
    let ahead = ray.ahead(z);
    (nearest..=farthest)
        .contains(&ahead)
        .then_some(TriangleHit {
            ahead,
            weights,
            meshlet,
            triangle,
            back,
        })
}

/// Below 0 if all are above 0.
#[inline(always)]
fn all_above(a: i32, b: i32, c: i32) -> i32 {
    a.wrapping_neg() & b.wrapping_neg() & c.wrapping_neg()
}

/// Parts of a whole in Q30, below 1.
#[inline(never)]
fn weights(whole: u64, parts: [u64; 2]) -> [i32; 2] {
    let down = 32u32.saturating_sub(whole.leading_zeros());
    let recip = reciprocal((whole >> down) as u32);
    parts.map(|part| {
        let part = ((part >> down) as u32) << recip.shift;
        mul_high_u(part, recip.mantissa as u32).min((1 << 30) - 1) as i32
    })
}
