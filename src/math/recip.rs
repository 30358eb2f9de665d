//! Reciprocals without a division: a table of 256 entries and two
//! Newton-Raphson steps (Ercegovac and Lang, "Digital Arithmetic", chapter 7).

use super::wide::mul_high_u;

/// `round(2^16 / x)` for x in the middle of each 256th of 1..2.
const SEEDS: [u16; 256] = seeds();

const fn seeds() -> [u16; 256] {
    let mut table = [0u16; 256];
    let mut i = 0;
    while i < 256 {
        let twice_x = 513 + 2 * i as u32; // 512 * x
        #[expect(clippy::indexing_slicing, reason = "evaluated by the compiler")]
        {
            table[i] = (((1u32 << 26) / twice_x + 1) >> 1) as u16;
        }
        i += 1;
    }
    table
}

/// `1 / value` as `mantissa * 2^(shift - 62)`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Reciprocal {
    /// In 2^30 ..= 2^31 - 1; relative error below 2^-28.
    pub mantissa: i32,
    /// How far `value` was shifted left to fill 32 bits, 0..=31.
    pub shift: u32,
}

/// [`u32::leading_zeros`] of a value other than 0: a long function where it is no
/// instruction.
#[inline(always)]
pub(crate) fn leading_zeros(value: u32) -> u32 {
    if cfg!(narrow_multiply) {
        leading_zeros_by_parts(value)
    } else {
        value.leading_zeros()
    }
}

/// The same for values other than 0, by halving what is left.
#[inline(always)]
pub(super) fn leading_zeros_by_parts(mut value: u32) -> u32 {
    const OF_FOUR_BITS: [u8; 16] = [4, 3, 2, 2, 1, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0];
    let mut count = 0;
    for part in [16, 8, 4] {
        if value >> (32 - part) == 0 {
            value <<= part;
            count += part;
        }
    }
    #[expect(clippy::indexing_slicing, reason = "four bits index 16 entries")]
    let last = OF_FOUR_BITS[(value >> 28) as usize];
    count + u32::from(last)
}

/// The reciprocal of `value`. Relative error below 2^-28 for every value but
/// 0, whose result is that of 1. A test goes over the whole range of seeds
/// against f64.
#[inline(always)]
pub fn reciprocal(value: u32) -> Reciprocal {
    let value = value | u32::from(value == 0);
    let shift = leading_zeros(value);
    Reciprocal {
        mantissa: normal_reciprocal(value << shift),
        shift,
    }
}

/// The mantissa of the reciprocal of a value of 32 bits.
#[inline(always)]
pub(super) fn normal_reciprocal(x: u32) -> i32 {
    // x / 2^31 is in 1..2.
    #[expect(clippy::indexing_slicing, reason = "eight bits index 256 entries")]
    let seed = u32::from(SEEDS[((x >> 23) & 0xff) as usize]); // 2^16 / x, 9 bits good

    // First step in 16-bit factors: 15 bits good, as many as x >> 16 has.
    let error = (1i32 << 31).wrapping_sub((x >> 16).wrapping_mul(seed) as i32); // Q31, below 2^23
    let first = (seed << 15).wrapping_add_signed((seed as i32 * (error >> 8)) >> 8); // Q31

    // Second step in full width.
    let error = (1i32 << 30) - mul_high_u(x, first) as i32; // Q30, below 2^16
    let second = first.wrapping_add_signed(((first >> 16) as i32 * error) >> 14);
    // 2^31 becomes 2^31 - 1.
    (second - (second >> 31)) as i32
}
