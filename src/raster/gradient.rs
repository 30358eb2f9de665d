//! How an attribute changes from pixel to pixel.

use crate::math::{Reciprocal, SUBPX_BITS, reciprocal};
use crate::vertex::ScreenVertex;

/// One over a triangle's doubled area, and its edges from the first vertex.
#[derive(Clone, Copy, Debug)]
pub(super) struct Plane {
    recip: Reciprocal,
    /// `area = (32-bit value) * 2^scale`.
    scale: i32,
    d1: [i32; 2],
    d2: [i32; 2],
}

/// Change of an attribute a pixel, 16 fractional bits.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Gradient {
    pub x: i32,
    pub y: i32,
}

impl Plane {
    /// For vertices with the doubled `area` (not 0; sub-pixels squared, its
    /// sign is that of the winding).
    #[inline(always)]
    pub(super) fn new([a, b, c]: [&ScreenVertex; 3], area: i64) -> Self {
        let bits = 64 - area.unsigned_abs().leading_zeros() as i32;
        let scale = (bits - 32).max(0);
        let (ax, ay) = (a.x.to_bits(), a.y.to_bits());
        let mut d1 = [b.x.to_bits() - ax, b.y.to_bits() - ay];
        let mut d2 = [c.x.to_bits() - ax, c.y.to_bits() - ay];
        if area < 0 {
            // Both numerators change sign with the area.
            d1 = d1.map(i32::wrapping_neg);
            d2 = d2.map(i32::wrapping_neg);
        }
        Self {
            recip: reciprocal((area.unsigned_abs() >> scale) as u32),
            scale,
            d1,
            d2,
        }
    }

    /// The gradient of an attribute that differs from the first vertex's by
    /// `v1` and `v2` at the others, in units with `fraction` fractional bits.
    /// `None` if it exceeds the format: the triangle is a sliver, thinner than
    /// two pixels.
    #[inline(always)]
    pub(super) fn gradient(&self, v1: i32, v2: i32, fraction: i32) -> Option<Gradient> {
        let ([x1, y1], [x2, y2]) = (self.d1, self.d2);
        let product = |a: i32, b: i32| i64::from(a) * i64::from(b);
        Some(Gradient {
            x: self.divide(product(v1, y2) - product(v2, y1), fraction)?,
            y: self.divide(product(x1, v2) - product(x2, v1), fraction)?,
        })
    }

    /// What stands in for a gradient that exceeds the format: along the
    /// triangle's `height`, from its top vertex to its bottom one, nothing
    /// across. A sliver is not wide enough for the difference to be seen.
    #[cold]
    pub(super) fn along(change: i32, height: i32, fraction: i32) -> Gradient {
        let change = i64::from(change) << (SUBPX_BITS as i32 + 16 - fraction);
        let y = change.checked_div(height.into()).unwrap_or(0);
        Gradient {
            x: 0,
            y: i32::try_from(y).unwrap_or(0),
        }
    }

    /// `n / |area|` a pixel, with 16 fractional bits.
    #[inline(always)]
    fn divide(&self, n: i64, fraction: i32) -> Option<i32> {
        // To 31 bits and a sign.
        let down = (33 - n.unsigned_abs().leading_zeros() as i32).max(0);
        let product = (n >> down) * i64::from(self.recip.mantissa);
        // n / area = product * 2^(down + shift - scale - 62); a pixel is 2^12
        // sub-pixels, and the result has 16 fractional bits.
        let up =
            down + self.recip.shift as i32 - self.scale - 62 + SUBPX_BITS as i32 + (16 - fraction);
        if up >= 0 {
            let most = i64::from(i32::MAX) >> up.min(31);
            return (product.abs() <= most).then(|| (product << up.min(31)) as i32);
        }
        let by = up.wrapping_neg();
        if by > 62 {
            return Some(0);
        }
        i32::try_from((product + (1i64 << (by - 1))) >> by).ok()
    }
}
