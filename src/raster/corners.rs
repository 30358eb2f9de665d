//! What the corners of a surface's triangle have besides their place on the screen.

use super::run::Values;
use super::sliver::WEIGHT_BITS;
use crate::math::reciprocal;

/// What a corner of a triangle has besides its place on the screen.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Corner {
    /// Distance along the line of sight, at least 1, in any unit; the same at all
    /// corners for interpolation along the screen.
    pub distance: i32,
    /// Within -2^15..=2^15.
    pub attributes: Values,
}

/// What a surface is made of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SurfaceKind {
    /// Attributes in use.
    pub attributes: usize,
    /// Whether runs say how the first two change from row to row.
    pub footprint: bool,
    /// Whether attributes decide where the surface ends, so that they are to be four
    /// times as exact.
    pub outlined: bool,
}

/// Fractional bits of an attribute that is not divided.
pub(super) const AFFINE_FRACTION: u32 = 13;
/// The three corners, sorted, with 1 / distance.
pub(super) struct Corners {
    pub kind: SurfaceKind,
    /// In units that bring the nearest to 30 or 31 bits; at least 1.
    pub nearness: [i32; 3],
    pub attributes: [Values; 3],
    pub perspective: bool,
}

impl Corners {
    pub(super) fn new(sorted: [&Corner; 3], kind: SurfaceKind) -> Self {
        let reciprocals = sorted.map(|c| reciprocal(c.distance.max(1) as u32));
        let nearest = reciprocals.iter().fold(0, |m, r| m.max(r.shift));
        let nearness = reciprocals.map(|r| (r.mantissa >> (nearest - r.shift).min(30)).max(1));
        let [a, b, c] = sorted.map(|c| c.distance);
        Self {
            kind,
            nearness,
            attributes: sorted.map(|c| c.attributes),
            perspective: a != b || a != c,
        }
    }

    /// An attribute at the three corners, times nearness in perspective, in 30 bits
    /// and a sign, and the power of two that it was divided by.
    pub(super) fn products(&self, which: usize) -> ([i32; 3], i32) {
        let mut values = [0; 3];
        for (value, all) in values.iter_mut().zip(&self.attributes) {
            *value = i64::from(all.get(which).copied().unwrap_or(0));
        }
        if !self.perspective {
            return (values.map(|v| (v << AFFINE_FRACTION) as i32), 0);
        }
        for (value, nearness) in values.iter_mut().zip(self.nearness) {
            *value *= i64::from(nearness);
        }
        let bits = values.iter().fold(0, |m, v| m | v.unsigned_abs());
        let down = (34 - bits.leading_zeros() as i32).max(0);
        (values.map(|v| (v >> down) as i32), down)
    }

    /// Weights in space from those on the screen.
    pub(super) fn in_space(&self, [wb, wc]: [i64; 2]) -> [i64; 2] {
        if !self.perspective {
            return [wb, wc];
        }
        let [na, nb, nc] = self.nearness.map(i64::from);
        let [a, b, c] = [((1 << WEIGHT_BITS) - wb - wc) * na, wb * nb, wc * nc];
        let whole = (a + b + c) >> WEIGHT_BITS;
        [b, c].map(|w| {
            let weight = w.checked_div(whole).unwrap_or(0);
            weight.clamp(-1 << WEIGHT_BITS, 2 << WEIGHT_BITS)
        })
    }
}
