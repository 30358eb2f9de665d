//! Spheres about actors in 16 bits: most rays pass most actors by, which products of 32
//! bits show.

use super::ray::Ray;

/// Fractional bits of a direction.
const BITS: u32 = 14;
/// Places are below this, in coarse units.
const REACH: i32 = 1 << BITS;
/// What roundings may take: one each of both places and the radius, 2 of a direction at
/// the farthest, 5 of the products.
const MARGIN: i32 = 12;

/// A sphere that holds an actor, in units of the frame.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sphere {
    centre: [i16; 3],
    /// Margins included; 0: nothing is there.
    radius: i16,
}

/// A frame's unit: `2^shift` raw world bits.
#[derive(Clone, Copy, Debug)]
pub(super) struct Unit {
    shift: u32,
}

/// The actors that a ray may meet, in their order: a bit each of the first 32, if they have
/// spheres, and all others.
#[derive(Clone, Copy, Debug)]
pub(super) struct Candidates {
    bits: u32,
    others: (u16, u16),
}

/// A ray in coarse units.
#[derive(Clone, Copy, Debug)]
struct CoarseRay {
    origin: [i32; 3],
    direction: [i32; 3],
    far: i32,
    /// It is as thick as this to all sides.
    around: i32,
}

impl Unit {
    /// Such that spheres of this size fit, given as the or of how far they reach from
    /// the world's origin, raw world bits.
    pub(super) fn of(reach: u32) -> Self {
        let bits = 32 - reach.leading_zeros();
        Self {
            shift: bits.saturating_sub(BITS),
        }
    }

    /// Raw world bits of it, as a power of two.
    pub(super) fn shift(self) -> u32 {
        self.shift
    }

    /// A sphere, raw world bits; of radius 0: nothing.
    pub(super) fn sphere(self, centre: [i32; 3], radius: i32) -> Sphere {
        let held = |c: i32| (c >> self.shift).clamp(-REACH, REACH) as i16;
        Sphere {
            centre: centre.map(held),
            radius: if radius == 0 {
                0
            } else {
                held(radius).saturating_add(MARGIN as i16)
            },
        }
    }

    /// Whether a ray surely passes by a sphere.
    pub(super) fn passes_by(self, ray: &Ray, sphere: &Sphere) -> bool {
        let ray = self.ray(ray, 0);
        ray.is_some_and(|ray| sphere.missed(&ray))
    }

    /// A ray that is as thick as `around`; `None` if that is too much, or if it starts too
    /// far away.
    #[inline(always)]
    fn ray(self, ray: &Ray, around: u32) -> Option<CoarseRay> {
        let origin = ray.origin.map(|c| c >> self.shift);
        let near = |c: i32| c.wrapping_add(REACH) as u32 <= 2 * REACH as u32;
        let [x, y, z] = origin;
        let around = (around >> self.shift) as i32 + i32::from(around != 0);
        if !(near(x) && near(y) && near(z) && around <= REACH / 2) {
            return None;
        }
        Some(CoarseRay {
            origin,
            direction: ray.direction.map(|c| (c + (1 << 15)) >> (30 - BITS)),
            // Farther than any place that is told apart.
            far: (ray.far >> self.shift).min(1 << 20) as i32 + MARGIN,
            around,
        })
    }
}

impl Candidates {
    /// Of `count` actors, the first of which have spheres, those that a ray may meet that is
    /// as thick as `around`, raw world bits.
    #[inline(never)]
    pub(super) fn of(
        ray: &Ray,
        around: u32,
        unit: Unit,
        spheres: &[impl AsRef<Sphere>],
        count: u16,
    ) -> Self {
        let Some(ray) = unit.ray(ray, around) else {
            return Self::all(count);
        };
        let first = spheres.len().min(count.min(32).into());
        let (mut bits, mut bit) = (0, 1u32);
        for sphere in spheres.get(..first).unwrap_or_default() {
            if !sphere.as_ref().missed(&ray) {
                bits |= bit;
            }
            bit <<= 1;
        }
        Self {
            bits,
            others: (first as u16, count),
        }
    }

    /// All of `count` actors.
    pub(super) fn all(count: u16) -> Self {
        Self {
            bits: 0,
            others: (0, count),
        }
    }

    /// None at all.
    pub(super) const NONE: Self = Self {
        bits: 0,
        others: (0, 0),
    };

    /// Whether there is none.
    #[inline(always)]
    pub(super) fn is_empty(&self) -> bool {
        let (next, end) = self.others;
        self.bits == 0 && next >= end
    }

    /// All but one, if that has a sphere.
    #[inline(always)]
    pub(super) fn without(mut self, number: u16) -> Self {
        self.bits &= !1u32.checked_shl(number.into()).unwrap_or(0);
        self
    }

    /// The next actor that has a sphere.
    #[inline(always)]
    pub(super) fn next_sphere(&mut self) -> Option<u16> {
        let number = self.bits.trailing_zeros() as u16;
        self.bits &= self.bits.wrapping_sub(1);
        (number < 32).then_some(number)
    }

    /// The next actor, and whether its sphere is still to be tried.
    #[inline(always)]
    pub(super) fn next(&mut self) -> Option<(u16, bool)> {
        if self.bits != 0 {
            let number = self.bits.trailing_zeros() as u16;
            self.bits &= self.bits.wrapping_sub(1);
            return Some((number, false));
        }
        let (next, end) = self.others;
        self.others.0 = next.wrapping_add(1);
        (next < end).then_some((next, true))
    }
}

impl Sphere {
    pub(super) const NONE: Self = Self {
        centre: [0; 3],
        radius: 0,
    };

    /// Whether a ray surely passes by, or ends before it.
    #[inline(always)]
    fn missed(&self, ray: &CoarseRay) -> bool {
        let radius = i32::from(self.radius) + ray.around;
        let ([cx, cy, cz], [ox, oy, oz]) = (self.centre.map(i32::from), ray.origin);
        // 15 bits and 14, three times: below 2^31.
        let (x, y, z) = (cx - ox, cy - oy, cz - oz);
        let [dx, dy, dz] = ray.direction;
        let middle = (x * dx + y * dy + z * dz) >> BITS;
        let beside = |c: i32, d: i32| {
            let off = ((middle * d) >> BITS) - c;
            (off + radius) as u32 > 2 * radius as u32
        };
        middle < -radius
            || beside(x, dx)
            || beside(y, dy)
            || beside(z, dz)
            || middle - radius > ray.far
            || self.radius == 0
    }
}

#[cfg(test)]
mod tests;
