//! Vectors in space, and the exact products that the view needs once a frame.

use super::{World, keep_rolled, product, rolled, square_root};

/// A place or a distance in space.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Vec3 {
    /// To the right.
    pub x: World,
    /// Up.
    pub y: World,
    /// Towards the viewer (right-handed).
    pub z: World,
}

impl Vec3 {
    /// The origin.
    pub const ZERO: Self = Self::from_bits([0; 3]);

    /// From three lengths.
    pub const fn new(x: World, y: World, z: World) -> Self {
        Self { x, y, z }
    }

    /// From three whole numbers.
    pub const fn from_ints(x: i16, y: i16, z: i16) -> Self {
        Self::from_bits([(x as i32) << 16, (y as i32) << 16, (z as i32) << 16])
    }

    /// From raw bits of [`World`] lengths.
    pub const fn from_bits(bits: [i32; 3]) -> Self {
        let [x, y, z] = bits;
        Self {
            x: World::from_bits(x),
            y: World::from_bits(y),
            z: World::from_bits(z),
        }
    }

    /// Raw bits of the three lengths.
    pub const fn to_bits(self) -> [i32; 3] {
        [self.x.to_bits(), self.y.to_bits(), self.z.to_bits()]
    }

    /// The sum with raw bits; saturates.
    pub(crate) fn plus(self, by: [i64; 3]) -> Self {
        let mut bits = self.to_bits();
        for (sum, c) in bits.iter_mut().zip(by) {
            let wide = c.saturating_add(i64::from(*sum));
            *sum = wide.clamp(i32::MIN.into(), i32::MAX.into()) as i32;
        }
        Self::from_bits(bits)
    }

    /// `self - other` in raw bits, exact.
    pub(crate) fn minus(self, other: Self) -> [i64; 3] {
        let ([ax, ay, az], [bx, by, bz]) = (self.to_bits(), other.to_bits());
        [
            i64::from(ax) - i64::from(bx),
            i64::from(ay) - i64::from(by),
            i64::from(az) - i64::from(bz),
        ]
    }
}

/// A direction of length 1: components in Q30, -2^30..=2^30.
pub type Unit3 = [i32; 3];

/// The direction of `v`, which may have any scale below 2^62; a vector of
/// length 0 gives `None`. Error below 2^-28 a component.
#[inline(never)]
pub fn normalise(v: [i64; 3]) -> Option<Unit3> {
    let [x, y, z] = v;
    let largest = x.unsigned_abs().max(y.unsigned_abs()).max(z.unsigned_abs());
    if largest == 0 {
        return None;
    }
    // Bring the largest component to 30 bits.
    let shift = 30 - (64 - largest.leading_zeros() as i32);
    let mut unit = v;
    let mut squared = 0u64;
    for c in rolled(&mut unit) {
        *c = if shift >= 0 {
            *c << shift
        } else {
            *c >> -shift
        };
        squared += (*c * *c) as u64;
        keep_rolled();
    }
    let length = i64::from(square_root(squared).max(1));
    for c in rolled(&mut unit) {
        *c = ((*c << 30) / length).clamp(-(1 << 30), 1 << 30);
        keep_rolled();
    }
    Some(unit.map(|c| c as i32))
}

/// Cross product of two Q30 directions, in Q60 before any rounding.
#[inline(never)]
pub fn cross(a: Unit3, b: Unit3) -> [i64; 3] {
    let ([ax, ay, az], [bx, by, bz]) = (a.map(i64::from), b.map(i64::from));
    [ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx]
}

/// Dot product of two Q30 directions in Q30, rounded to nearest; of what is longer, modulo
/// 2^32.
#[inline(never)] // used once an actor, in many places
pub fn dot(a: Unit3, b: Unit3) -> i32 {
    let ([ax, ay, az], [bx, by, bz]) = (a, b);
    // Two directions of length 1: at most 1 + 2^-27.
    let sum = product(ax, bx)
        .wrapping_add(product(ay, by))
        .wrapping_add(product(az, bz));
    (sum.wrapping_add(1 << 29) >> 30) as i32
}
