//! Lengths and directions in 32 bits.

use super::recip::normal_reciprocal;
use super::wide::mul_high_u;
use super::{Scaled, mul_high, mul_q30, square};

/// `2^15 / sqrt(x)` for x in the middle of each 64th of 1..4.
const SEEDS: [u16; 192] = seeds();

const fn seeds() -> [u16; 192] {
    let mut table = [0u16; 192];
    let mut i = 0;
    while i < 192 {
        // x = (129 + 2 i) / 128, from 64 / 64 on.
        let x = ((129 + 2 * i as u64) << 50) / 128; // Q50
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
    let up = value.leading_zeros() & !1;
    let x = value << up; // Q30, 1..4
    #[expect(clippy::indexing_slicing, reason = "x >> 24 is in 64..256")]
    let seed = u32::from(SEEDS[((x >> 24) as usize).wrapping_sub(64) % 192]); // Q15
    // y (3 - x y y) / 2
    let product = mul_high_u(x, seed * seed); // Q28, about 1
    let factor = ((3u32 << 28) + (1 << 12)).wrapping_sub(product) >> 13; // Q15 of 3 - x y y, about 2
    let root = (seed * factor) >> 1; // Q30 of twice the root, halved twice
    (root.clamp(1 << 29, 1 << 30), 45 - up / 2)
}

/// `1 / sqrt(x)` for x in 1..4 (30 fractional bits), 30 fractional bits; relative error
/// below 2^-27: one more Newton-Raphson step.
#[inline(always)]
fn fine_reciprocal_root(x: u32) -> u32 {
    let (root, _) = reciprocal_root(x);
    let squared = mul_high_u(root << 1, root << 1); // Q30
    let product = mul_high_u(x, squared << 1); // Q29, about 1
    let error = (1i32 << 29).wrapping_sub(product as i32);
    root.wrapping_add_signed(((root >> 15) as i32).wrapping_mul(error) >> 15)
}

/// The direction of a vector in Q30, and one over its length; `None` for length 0.
/// Components are off by 2^-28 at most.
#[inline(never)]
pub fn unit(v: [i32; 3]) -> Option<(super::Unit3, Scaled)> {
    let bits = v.iter().fold(0, |m, c| m | c.unsigned_abs());
    if bits == 0 {
        return None;
    }
    // To 30 bits.
    let up = bits.leading_zeros() as i32 - 2;
    let v = v.map(|c| if up >= 0 { c << up } else { c >> -up });
    let squared: u64 = v.map(square).iter().sum();
    // 2^58 and above, below 2^62.
    let lead = squared.leading_zeros() & !1;
    let y = fine_reciprocal_root((squared << lead >> 32) as u32);
    let unit = if lead <= 2 {
        v.map(|c| mul_q30(c, y as i32))
    } else {
        v.map(|c| mul_q30(c << 1, y as i32))
    };
    Some((unit, Scaled::new(y, up - 30 - (62 - lead as i32) / 2)))
}

/// The square root of a number below 2^62, rounded down; relative error below 2^-26.
#[inline(never)]
pub fn root(square: u64) -> u32 {
    if square == 0 {
        return 0;
    }
    let lead = square.leading_zeros() & !1;
    let x = (square << lead >> 32) as u32;
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
    let down = 17 - bits.leading_zeros() as i32;
    let short = v.map(|c| {
        if down > 0 {
            (c.saturating_add(1 << (down.min(31) - 1))) >> down.min(31)
        } else {
            c << down.wrapping_neg().min(31)
        }
    });
    let [x, y, z] = short;
    let squared = (x * x) as u32 + (y * y) as u32 + (z * z) as u32;
    let (root, exponent) = reciprocal_root(squared);
    // |short| is in 2^14..2^16: the root's exponent in 43..=46.
    let down_by = exponent.saturating_sub(31).clamp(1, 31);
    let round = 1 << (down_by - 1);
    let unit = short.map(|c| (mul_high(c << 15, root as i32) + round) >> down_by);
    let length = mul_high((squared >> 2) as i32, root as i32) as u32;
    Some((unit, Scaled::new(length, 34 - exponent as i32 + down)))
}

/// The dot product of two directions, 28 fractional bits.
#[inline(always)]
pub fn short_dot([ax, ay, az]: ShortUnit, [bx, by, bz]: ShortUnit) -> i32 {
    ax * bx + ay * by + az * bz
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
