//! A ray and a rectangle.

use super::actor::{Form, RayActor, plus};
use super::faces::Faces;
use super::holes::is_hole;
use super::ray::{Ray, between, moved};
use super::shades::Towards;
use super::surface::Surface;
use crate::math::{
    Scaled, Unit3, leading_zeros, mul_high_u, mul_q30, reciprocal, scaled_reciprocal,
};
use crate::scene::{Coordinates, Scene};

/// Where a ray meets a rectangle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct RectangleHit {
    /// Raw world bits along the ray.
    pub distance: u32,
    /// From the centre along the sides, raw world bits.
    off: [i32; 2],
    /// The place, raw world bits.
    place: [i32; 3],
    /// Whether it is seen from behind.
    back: bool,
}

/// A vector along an axis, saturating.
#[inline(always)]
fn along([x, y, z]: [i32; 3], axis: Unit3) -> i32 {
    let [ax, ay, az] = axis;
    mul_q30(x, ax)
        .saturating_add(mul_q30(y, ay))
        .saturating_add(mul_q30(z, az))
}

impl RayActor {
    /// Where a ray meets this rectangle, whose half sides are given.
    #[inline(never)]
    pub(super) fn meet_rectangle(
        &self,
        scene: &Scene<'_>,
        ray: &Ray,
        faces: Faces,
        half: [u32; 2],
    ) -> Option<RectangleHit> {
        // What is flat is not met again by a ray that starts on it.
        if ray.on == self.number.wrapping_add(1) {
            return None;
        }
        let [across, normal, down] = self.to_grid;
        let slope = along(ray.direction, normal);
        let back = (slope > 0) != self.faces_down();
        if slope == 0 || !(if back { faces.back } else { faces.front }) {
            return None;
        }
        let off = between(self.centre, ray.origin);
        let bits = off.iter().fold(1, |m, c| m | c.unsigned_abs());
        // To 30 bits, for rays that graze it.
        let up = leading_zeros(bits) as i32 - 2;
        let fine = if up >= 0 {
            off.map(|c| c << up)
        } else {
            off.map(|c| c >> -up)
        };
        let height = along(fine, normal);
        if (height ^ slope) < 0 {
            return None;
        }
        // Height over slope, which has 30 fractional bits: one over it has 62 - shift.
        let recip = reciprocal(slope.unsigned_abs());
        let height = height.unsigned_abs();
        let lead = leading_zeros(height | 1);
        let quotient = mul_high_u(height << lead, recip.mantissa as u32);
        let shift = lead as i32 + up - recip.shift as i32;
        let distance = if shift >= 0 {
            quotient >> shift.min(31)
        } else {
            quotient.saturating_mul(1 << shift.unsigned_abs().min(31))
        };
        if distance < ray.near || distance > ray.far {
            return None;
        }
        let place = ray.at(distance);
        let from_centre = between(place, self.centre);
        let off = [along(from_centre, across), along(from_centre, down)];
        let mut sides = off.iter().zip(half);
        if sides.any(|(c, half)| c.unsigned_abs() > half) {
            return None;
        }
        if let Some(texture) = self.holes
            && self.is_hole(scene, texture, off)
        {
            return None;
        }
        Some(RectangleHit {
            distance,
            off,
            place,
            back,
        })
    }

    /// Whether all ways from within `around` of a place to a lamp surely stay on one side of
    /// this rectangle.
    pub(super) fn is_beside(&self, place: [i32; 3], towards: &Towards, around: u32) -> bool {
        let Form::Rectangle { .. } = self.form else {
            return false;
        };
        let [_, normal, _] = self.to_grid;
        let height = |of: [i32; 3]| along(between(of, self.centre), normal);
        // What roundings take.
        let least = around as i32 + 64;
        let (from, to) = match *towards {
            // Of a direction, up to where rays end.
            Towards::Direction(direction) => (height(place), along(direction, normal)),
            Towards::Place(lamp, _) => (height(place), height(lamp)),
        };
        from.unsigned_abs() > least as u32 && to.unsigned_abs() > least as u32 && (from ^ to) >= 0
    }

    /// Whether its texture is cut out at a place.
    #[cold]
    #[inline(never)]
    fn is_hole(&self, scene: &Scene<'_>, texture: u8, off: [i32; 2]) -> bool {
        let mesh = scene.mesh(self.mesh);
        let place = mesh.coordinates.map(|own| self.coordinates(&own, off));
        place.is_some_and(|place| is_hole(scene, &mesh, texture, place))
    }

    /// The surface there.
    pub(super) fn rectangle_surface(&self, scene: &Scene<'_>, hit: &RectangleHit) -> Surface {
        let [_, up, _] = self.to_grid;
        let normal = if self.faces_down() {
            up.map(|c| -c)
        } else {
            up
        };
        let coordinates = scene.mesh(self.mesh).coordinates;
        Surface {
            place: hit.place,
            face: normal,
            normal,
            tint: None,
            coordinates: coordinates.map(|own| self.coordinates(&own, hit.off)),
            back: hit.back,
        }
    }

    /// Texture coordinates as the mesh's vertices have them, 8 fractional bits.
    fn coordinates(&self, own: &Coordinates, off: [i32; 2]) -> [i32; 2] {
        let Form::Rectangle { half, against } = self.form else {
            return [0; 2];
        };
        // The origin is in the middle: 0 to 1 are stored as -1/2 to 1/2.
        let bits = u32::from(own.exponent).min(20) + 7;
        let [ax, _, az] = against;
        let mut out = [0; 2];
        let sides = off.into_iter().zip(half).zip([ax, az]);
        for (out, ((off, half), against)) in out.iter_mut().zip(sides) {
            let ratio = Scaled::new(off.unsigned_abs(), 0)
                .times(scaled_reciprocal(Scaled::new(half, 0)))
                .fixed(bits);
            let ratio = ratio.min(1 << bits) as i32;
            *out = if (off < 0) != against { -ratio } else { ratio };
        }
        out
    }

    fn faces_down(&self) -> bool {
        matches!(
            self.form,
            Form::Rectangle {
                against: [_, true, _],
                ..
            }
        )
    }

    /// The corners, each twice, raw world bits.
    pub(super) fn rectangle_corners(&self, [x, z]: [u32; 2]) -> [[i32; 3]; 8] {
        let [across, _, down] = self.to_grid;
        let [x, z] = [x, z].map(|half| half as i32);
        let corner = |x: i32, z: i32| plus(moved(self.centre, across, x), moved([0; 3], down, z));
        let four = [corner(-x, -z), corner(x, -z), corner(-x, z), corner(x, z)];
        let [a, b, c, d] = four;
        [a, b, c, d, a, b, c, d]
    }
}
