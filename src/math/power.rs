//! Powers of numbers up to 1, by logarithm and exponential from tables.

use super::wide::mul_high_u;

const BITS: u32 = 7;
const ENTRIES: usize = (1 << BITS) + 1;

/// `2^16 * log2(1 + i / 128)`, rounded to nearest.
const LOGARITHMS: [u32; ENTRIES] = logarithms();

/// By repeated squaring (Knuth, "The Art of Computer Programming", 1.2.2).
const fn logarithms() -> [u32; ENTRIES] {
    let mut table = [0; ENTRIES];
    let mut i = 0;
    while i < ENTRIES {
        let mut x = ((128 + i as u64) << 31) >> BITS; // Q31, 1..=2
        let mut log = 0u32;
        let mut bit = 0;
        while bit < 18 {
            log <<= 1;
            if x >= 1 << 32 {
                log += 1;
                x >>= 1;
            }
            if bit < 17 {
                x = (x * x) >> 31;
            }
            bit += 1;
        }
        #[expect(clippy::indexing_slicing, reason = "evaluated by the compiler")]
        {
            table[i] = (log + 1) >> 1;
        }
        i += 1;
    }
    table
}

/// `2^15 * 2^(i / 128)`, rounded to nearest.
const EXPONENTIALS: [u32; ENTRIES] = exponentials();

const fn exponentials() -> [u32; ENTRIES] {
    // 2^(1/128) in Q62, by seven square roots of 2.
    let mut root = 2u128 << 60; // Q60
    let mut i = 0;
    while i < BITS {
        root = (root << 60).isqrt();
        i += 1;
    }
    let mut table = [0; ENTRIES];
    let mut value = 1u128 << 60;
    let mut i = 0;
    while i < ENTRIES {
        #[expect(clippy::indexing_slicing, reason = "evaluated by the compiler")]
        {
            table[i] = ((value + (1 << 44)) >> 45) as u32;
        }
        value = (value * root) >> 60;
        i += 1;
    }
    table
}

/// Between two entries of a table; `x` has 32 fractional bits of its range.
#[inline(always)]
fn between(table: &[u32; ENTRIES], x: u32) -> u32 {
    let at = (x >> (32 - BITS)) as usize;
    let (from, to) = (
        table.get(at).copied().unwrap_or(0),
        table.get(at + 1).copied().unwrap_or(0),
    );
    let part = (x << BITS) >> 16;
    from + (((to - from) * part + (1 << 15)) >> 16)
}

/// `base^exponent` for a base of 0..=1 (28 fractional bits) and an exponent of
/// 0..256 (8 fractional bits): 14 fractional bits. Off by at most 2^-9 for a base as
/// exact as it is given; tested against f64.
#[inline(never)]
pub fn power(base: u32, exponent: u16) -> u32 {
    const ONE: u32 = 1 << 14;
    if exponent == 0 {
        return ONE;
    }
    let base = base.min(1 << 28);
    if base == 0 {
        return 0;
    }
    let up = base.leading_zeros();
    let mantissa = base << up; // Q31, 1..2
    // -log2(base), 16 fractional bits; 2^28 has three leading zeros.
    let log = ((up - 3) << 16) - between(&LOGARITHMS, mantissa << 1);
    // 29 bits with 24 fractional ones, and 32 with 24: the high half has 16.
    let power = mul_high_u(log << 8, u32::from(exponent) << 16);
    let (whole, part) = (power >> 16, power << 16);
    // 2^-(whole + part) = 2^(1 - part) / 2^(whole + 1).
    let value = match part {
        0 => 1 << 15,
        _ => between(&EXPONENTIALS, part.wrapping_neg()) >> 1,
    };
    value.checked_shr(whole + 1).unwrap_or(0)
}
