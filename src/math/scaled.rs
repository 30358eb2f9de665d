//! Numbers of any size, for the few places that need them: attenuation over all
//! distances that a world holds.

use super::recip::leading_zeros;
use super::wide::mul_high_u;

/// `mantissa * 2^exponent`, not negative; relative error below 2^-29 an operation. Exponents of
/// new ones are within 2^12 either way; those of products add up, for which there is room.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Scaled {
    /// 2^31.. or 0.
    mantissa: u32,
    exponent: i32,
}

impl Scaled {
    /// 0.
    pub const ZERO: Self = Self {
        mantissa: 0,
        exponent: 0,
    };

    /// `mantissa * 2^exponent`.
    pub fn new(mantissa: u32, exponent: i32) -> Self {
        if mantissa == 0 {
            return Self::ZERO;
        }
        let up = leading_zeros(mantissa);
        Self {
            mantissa: mantissa << up.min(31),
            exponent: exponent.saturating_sub(up as i32).clamp(-4096, 4096),
        }
    }

    /// 2^31.., or 0.
    pub fn mantissa(self) -> u32 {
        self.mantissa
    }

    /// See [`Scaled::new`].
    pub fn exponent(self) -> i32 {
        self.exponent
    }

    /// The same of a mantissa of 31 or 32 bits, or 0: without counting zeros, which takes
    /// cores without an instruction for it as long as the rest.
    #[inline(always)]
    pub(super) fn nearly_normal(mantissa: u32, exponent: i32) -> Self {
        if mantissa == 0 {
            return Self::ZERO;
        }
        let up = u32::from(mantissa >> 31 == 0);
        Self {
            mantissa: mantissa << up,
            exponent: exponent - up as i32,
        }
    }

    /// The product.
    #[must_use]
    pub fn times(self, other: Self) -> Self {
        let exponent = self.exponent + other.exponent + 32;
        Self::nearly_normal(mul_high_u(self.mantissa, other.mantissa), exponent)
    }

    /// The sum.
    #[must_use]
    pub fn plus(self, other: Self) -> Self {
        let (large, small) =
            if self.mantissa == 0 || (other.mantissa != 0 && other.exponent > self.exponent) {
                (other, self)
            } else {
                (self, other)
            };
        let down = (large.exponent - small.exponent).clamp(0, 31);
        let small = (small.mantissa >> 1) >> down;
        Self::nearly_normal((large.mantissa >> 1) + small, large.exponent + 1)
    }

    /// `2^by` times as much.
    #[must_use]
    pub fn shifted(self, by: i32) -> Self {
        let exponent = self.exponent.saturating_add(by).clamp(-4096, 4096);
        Self { exponent, ..self }
    }

    /// With `bits` fractional bits, rounded down; saturates.
    pub fn fixed(self, bits: u32) -> u32 {
        let up = self.exponent.saturating_add_unsigned(bits);
        if self.mantissa != 0 && up > 0 {
            return u32::MAX;
        }
        self.mantissa.checked_shr(up.unsigned_abs()).unwrap_or(0)
    }
}
