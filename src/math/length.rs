//! Lengths and directions in 32 bits.

use super::recip::{leading_zeros, normal_reciprocal};
use super::wide::mul_high_u;
use super::{Scaled, mul_high, mul_q30, square};

/// `2^15 / sqrt(x)` for x in the middle of each 64th of 1..4, by x in 64ths; what is
/// below is not looked up.
const SEEDS: [u16; 256] = seeds();

const fn seeds() -> [u16; 256] {
    let mut table = [0u16; 256];
    let mut i = 64;
    while i < 256 {
        // x = (2 i + 1) / 128.
        let x = ((1 + 2 * i as u64) << 50) / 128; // Q50
        #[expect(clippy::indexing_slicing, reason = "evaluated by the compiler")]
        {
            // 2^15 / sqrt(x) = 2^40 / sqrt(x * 2^50).
            table[i] = ((1u64 << 41) / x.isqrt()).div_ceil(2) as u16;
        }
        i += 1;
    }
    table
}

/// `1 / sqrt(value)` as `mantissa * 2^-exponent`, mantissa in 2^29..=2^30.
/// Relative error below 2^-15, tested over the whole range against f64; one
/// Newton-Raphson step on a table of 192 entries. 0 counts as 1.
#[inline(always)]
pub fn reciprocal_root(value: u32) -> (u32, u32) {
    let value = value.max(1);
    // To 2^30..2^32, by an even power of two.
    let up = leading_zeros(value) & !1;
    let root = normal_reciprocal_root(value << up);
    (root.clamp(1 << 29, 1 << 30), 45 - up / 2)
}

/// `1 / sqrt(x)` for x in 1..4 (30 fractional bits), 30 fractional bits; relative error
/// below 2^-15, to either side.
#[inline(always)]
fn normal_reciprocal_root(x: u32) -> u32 {
    #[expect(clippy::indexing_slicing, reason = "eight bits index 256 entries")]
    let seed = u32::from(SEEDS[(x >> 24) as usize]); // Q15
    // y (3 - x y y) / 2
    let product = mul_high_u(x, seed * seed); // Q28, about 1
    let factor = ((3u32 << 28) + (1 << 12)).wrapping_sub(product) >> 13; // Q15 of 3 - x y y, about 2
    (seed * factor) >> 1 // Q30 of twice the root, halved twice
}

/// `1 / sqrt(x)` for x in 1..4 (30 fractional bits), 30 fractional bits; relative error
/// below 2^-27: one more Newton-Raphson step.
#[inline(always)]
fn fine_reciprocal_root(x: u32) -> u32 {
    let root = normal_reciprocal_root(x);
    let squared = mul_high_u(root << 1, root << 1); // Q30
    let product = mul_high_u(x, squared << 1); // Q29, about 1
    let error = (1i32 << 29).wrapping_sub(product as i32);
    root.wrapping_add_signed(((root >> 15) as i32).wrapping_mul(error) >> 15)
}

/// The direction of a vector in Q30, and one over its length; `None` for length 0.
/// Components are off by 2^-28 at most.
#[inline(never)]
pub fn unit(v: [i32; 3]) -> Option<(super::Unit3, Scaled)> {
    let (unit, y, exponent) = unit_parts(v)?;
    // 2^29..=2^30, or a little more.
    Some((unit, Scaled::nearly_normal(y << 1, exponent - 1)))
}

/// The direction of a vector alone, as [`unit()`] gives it.
#[inline(never)]
pub fn unit_vector(v: [i32; 3]) -> Option<super::Unit3> {
    unit_parts(v).map(|(unit, ..)| unit)
}

/// The direction, and one over the length as a mantissa (2^29..=2^30) and an exponent.
#[inline(always)]
fn unit_parts(v: [i32; 3]) -> Option<(super::Unit3, u32, i32)> {
    let bits = v.iter().fold(0, |m, c| m | c.unsigned_abs());
    if bits == 0 {
        return None;
    }
    // To 30 bits.
    let up = leading_zeros(bits) as i32 - 2;
    let v = if up >= 0 {
        v.map(|c| c << up)
    } else {
        v.map(|c| c >> -up)
    };
    let squared: u64 = v.map(square).iter().sum();
    // 2^58 and above, below 2^62.
    let (high, low) = ((squared >> 32) as u32, squared as u32);
    let long = high >> 28 != 0;
    let x = if long {
        high << 2 | low >> 30
    } else {
        high << 4 | low >> 28
    };
    let y = fine_reciprocal_root(x);
    let (v, up) = if long {
        (v, up - 60)
    } else {
        (v.map(|c| c << 1), up - 59)
    };
    Some((v.map(|c| mul_q30(c, y as i32)), y, up))
}

/// The square root of a number below 2^62, rounded down; relative error below 2^-26.
#[inline(never)]
pub fn root(square: u64) -> u32 {
    if square == 0 {
        return 0;
    }
    let (high, low) = ((square >> 32) as u32, square as u32);
    let (lead, x) = if high != 0 {
        // 2 at least; what is beyond wraps.
        let lead = leading_zeros(high) & !1;
        (lead, high << lead | low.wrapping_shr(32 - lead))
    } else {
        let lead = leading_zeros(low) & !1;
        (32 + lead, low << lead)
    };
    let root = mul_high_u(x, fine_reciprocal_root(x)); // Q28
    let up = (62 - lead as i32) / 2 - 28;
    if up >= 0 { root << up } else { root >> -up }
}

/// A direction of length 1, 14 fractional bits: -2^14..=2^14 each.
pub type ShortUnit = [i32; 3];

/// The direction of a vector, and its length; `None` for length 0. Components are
/// off by 1.5 * 2^-14 at most, the length by 2^-13 of it.
#[inline(never)]
pub fn direction(v: [i32; 3]) -> Option<(ShortUnit, Scaled)> {
    let bits = v.iter().fold(0, |m, c| m | c.unsigned_abs());
    if bits == 0 {
        return None;
    }
    // To 15 bits.
    let down = 17 - leading_zeros(bits) as i32;
    let short = if down > 0 {
        // Rounded to nearest.
        v.map(|c| ((c >> (down - 1)) + 1) >> 1)
    } else {
        v.map(|c| c << down.wrapping_neg().min(31))
    };
    let [x, y, z] = short;
    // |short| is in 2^14..2^16: 2^28 and above.
    let squared = (x * x) as u32 + (y * y) as u32 + (z * z) as u32;
    let up = if squared >> 30 == 0 { 1 } else { 0 };
    let root = normal_reciprocal_root(squared << (2 * up)).clamp(1 << 29, 1 << 30);
    let down_by = 14 - up;
    let round = 1 << (13 - up);
    let unit = short.map(|c| (mul_high(c << 15, root as i32) + round) >> down_by);
    let length = mul_high((squared >> 2) as i32, root as i32) as u32;
    Some((unit, Scaled::new(length, up - 11 + down)))
}

/// The dot product of two directions, 28 fractional bits; of what is longer, modulo 2^32.
#[inline(always)]
pub fn short_dot([ax, ay, az]: ShortUnit, [bx, by, bz]: ShortUnit) -> i32 {
    let [x, y, z] = [(ax, bx), (ay, by), (az, bz)].map(|(a, b)| a.wrapping_mul(b));
    x.wrapping_add(y).wrapping_add(z)
}

/// `1 / value` for a [`Scaled`] above 0.
#[inline(never)]
pub fn scaled_reciprocal(value: Scaled) -> Scaled {
    let mantissa = value.mantissa();
    if mantissa == 0 {
        return Scaled::new((1 << 31) - 1, -31 - value.exponent());
    }
    // 62 fractional bits; the first of its 32 is 0.
    let recip = normal_reciprocal(mantissa) as u32;
    Scaled::nearly_normal(recip << 1, -63 - value.exponent())
}
