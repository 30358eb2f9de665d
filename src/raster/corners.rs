//! What the corners of a surface's triangle have besides their place on the screen.

use super::run::{RUN_FRACTION, Values};
use super::sliver::WEIGHT_BITS;
use crate::math::reciprocal;

/// What a corner of a triangle has besides its place on the screen.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Corner<const A: usize> {
    /// Distance along the line of sight, at least 1, in any unit; the same at all
    /// corners for interpolation along the screen.
    pub distance: i32,
    /// Within -2^15..=2^15, [`RUN_FRACTION`] fractional bits.
    pub attributes: Values<A>,
}

/// What a surface is made of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SurfaceKind {
    /// Attributes in use.
    pub attributes: usize,
    /// Whether runs say how the first two change from row to row.
    pub footprint: bool,
    /// Whether attributes decide where the surface ends, so that they are to be more exact.
    pub outlined: bool,
}

/// The three corners, sorted, with 1 / distance.
pub(super) struct Corners<const A: usize> {
    pub kind: SurfaceKind,
    /// In units that bring the nearest to 30 or 31 bits; at least 1.
    pub nearness: [i32; 3],
    pub attributes: [Values<A>; 3],
    pub perspective: bool,
}

impl<const A: usize> Corners<A> {
    pub(super) fn new(sorted: [&Corner<A>; 3], kind: SurfaceKind) -> Self {
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
    /// and a sign, and the power of two that it was divided by; otherwise as it is.
    pub(super) fn products(&self, which: usize) -> ([i32; 3], i32) {
        let own = |all: &Values<A>| all.get(which).copied().unwrap_or(0);
        let own = self.attributes.each_ref().map(own);
        if !self.perspective {
            return (own, 0);
        }
        let mut values = [0; 3];
        for (value, (own, nearness)) in values.iter_mut().zip(own.into_iter().zip(self.nearness)) {
            *value = i64::from(own) * i64::from(nearness);
        }
        let bits = values.iter().fold(0, |m, v| m | v.unsigned_abs());
        let down = (34 - bits.leading_zeros() as i32).max(0);
        (
            values.map(|v| (v >> down) as i32),
            down - RUN_FRACTION as i32,
        )
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
