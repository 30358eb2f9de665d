//! Exact integer quotients. Scan conversion lives on these: an edge's crossing
//! with a row is a quotient and a remainder, not an approximation.

use super::{Reciprocal, mul_high, reciprocal};

/// Divides by one number more than once. A core without a divide estimates by
/// the reciprocal and corrects: the quotients are exact on every core.
#[derive(Clone, Copy, Debug)]
pub struct Divider {
    divisor: i32,
    recip: Reciprocal,
}

impl Divider {
    /// For a divisor of 1 or more; less counts as 1.
    #[inline(always)]
    pub fn new(divisor: i32) -> Self {
        let divisor = divisor.max(1);
        let recip = if cfg!(narrow_multiply) {
            reciprocal(divisor as u32)
        } else {
            Reciprocal {
                mantissa: 0,
                shift: 0,
            }
        };
        Self { divisor, recip }
    }

    /// What it divides by.
    pub fn divisor(&self) -> i32 {
        self.divisor
    }

    /// `(floor(n / d), n - floor(n / d) * d)`.
    #[inline(always)]
    pub fn floor(&self, n: i32) -> (i32, i32) {
        let d = self.divisor;
        if cfg!(narrow_multiply) && d < 1 << 26 {
            return floor_by_reciprocal(n, d, self.recip);
        }
        let q = n.wrapping_div_euclid(d);
        (q, n.wrapping_sub(q.wrapping_mul(d)))
    }

    /// `(ceil(n / d), ceil(n / d) * d - n)`: the remainder, in `0..d`, is what the
    /// quotient is too large by. `n` above `i32::MIN`.
    #[inline(always)]
    pub fn ceil(&self, n: i32) -> (i32, i32) {
        let (q, r) = self.floor(n.wrapping_neg());
        (q.wrapping_neg(), r)
    }

    /// [`Divider::floor`] of a wide number whose quotient fits `i32`; it
    /// saturates otherwise.
    #[cold]
    #[inline(never)]
    pub fn floor_wide(&self, n: i64) -> (i32, i32) {
        let d = i64::from(self.divisor.max(1));
        let q = n.wrapping_div_euclid(d);
        let r = n.wrapping_sub(q.wrapping_mul(d));
        (
            q.clamp(i64::from(i32::MIN), i64::from(i32::MAX)) as i32,
            r as i32,
        )
    }

    /// [`Divider::ceil`] of a wide number whose quotient fits `i32`.
    #[cold]
    #[inline(never)]
    pub fn ceil_wide(&self, n: i64) -> (i32, i32) {
        let (q, r) = self.floor_wide(n.wrapping_neg());
        (q.wrapping_neg(), r)
    }
}

/// The floored quotient for `d` below 2^26. The estimate is off by 2^-28 of the
/// quotient and its rounding, so that few steps correct it.
#[inline(always)]
pub(super) fn floor_by_reciprocal(n: i32, d: i32, recip: Reciprocal) -> (i32, i32) {
    let high = mul_high(n, recip.mantissa);
    let mut q = match recip.shift {
        31 => n,
        shift => high >> (30 - shift.min(30)),
    };
    let mut r = n.wrapping_sub(q.wrapping_mul(d));
    while r < 0 {
        q = q.wrapping_sub(1);
        r = r.wrapping_add(d);
    }
    while r >= d {
        q = q.wrapping_add(1);
        r = r.wrapping_sub(d);
    }
    (q, r)
}
