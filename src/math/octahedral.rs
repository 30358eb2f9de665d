//! Octahedral normals and one over their length.

/// Least squared length of an integer vector with |x| + |y| + |z| = 127.
const LEAST: u32 = 127 * 127 / 3;
/// Squared lengths are looked up in steps of 2^STEP.
const STEP: u32 = 7;
const FIRST: u32 = LEAST >> STEP;
const ENTRIES: usize = ((127 * 127) >> STEP) as usize - FIRST as usize + 1;

/// `2^22 / sqrt(a)` for a in the middle of each step.
const SEEDS: [u16; ENTRIES] = seeds();

const fn seeds() -> [u16; ENTRIES] {
    let mut table = [0u16; ENTRIES];
    let mut i = 0;
    while i < ENTRIES {
        let middle = ((FIRST as u64 + i as u64) << STEP) + (1 << (STEP - 1));
        #[expect(clippy::indexing_slicing, reason = "evaluated by the compiler")]
        {
            table[i] = ((1u64 << 62) / (middle << 18)).isqrt() as u16;
        }
        i += 1;
    }
    table
}

/// `2^22 / sqrt(squared)` for the squared length of an integer vector whose
/// absolute components sum to 127 (5376..=16129; other values are taken to the
/// nearer end). Relative error below 2^-12, tested over the whole range: one
/// Newton-Raphson step on a table of 86 entries.
#[inline(always)]
pub(crate) fn normal_length_recip(squared: u32) -> u32 {
    let squared = squared.clamp(LEAST, 127 * 127);
    #[expect(
        clippy::indexing_slicing,
        reason = "clamped to the table's range just above"
    )]
    let seed = u32::from(SEEDS[((squared >> STEP) - FIRST) as usize]);
    let product = ((seed * seed) >> 16) * squared; // a * y * y in Q28
    let factor = (3u32 << 28).wrapping_sub(product) >> 14; // (3 - a y y) / 2 in Q15
    (seed * factor) >> 15
}

/// A vector on the octahedron |x| + |y| + |z| = 127 * 2^extra from two of its
/// components, and 2^22 over its length `/ 2^extra`. The decoding is that of Meyer et
/// al., "On Floating-Point Normal Vectors" (2010).
#[inline(always)]
pub(crate) fn decode_octahedral([mut x, mut y]: [i32; 2], extra: u32) -> ([i32; 3], u32) {
    let z = (127 << extra) - x.abs() - y.abs();
    if z < 0 {
        // The lower half is folded over the diamond's edges.
        let fold = |c: i32| if c >= 0 { c + z } else { c - z };
        (x, y) = (fold(x), fold(y));
    }
    let squared = (x * x + y * y + z * z) as u32 >> (2 * extra);
    ([x, y, z], normal_length_recip(squared))
}
