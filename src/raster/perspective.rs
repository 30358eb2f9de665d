//! Perspective-correct light levels, for triangles so large and so inclined that
//! a level interpolated along the screen would be seen to be off.
//!
//! Depth is linear in screen space and, in perspective, proportional to 1 / w;
//! so are level * depth and, for their quotient, one reciprocal each 16 pixels
//! (Heckbert and Moreton, "Interpolation for polygon texture mapping and
//! shading", 1991).

use super::attribute::Attribute;
use super::triangle::Seen;
use crate::math::{Depth, Level, SUBPX_BITS, keep_rolled, mul_high, reciprocal};
use crate::vertex::ScreenVertex;

/// Pixels between exact levels.
const RUN: usize = 16;

/// Whether interpolation along the screen may be off by a level, over a span of
/// 8 pixels: by at most the levels' difference times (r - 1) / 4, with r the
/// ratio of the depths. In smaller triangles it may be off, in few pixels.
#[inline(always)]
pub(super) fn shows(triangle: [&ScreenVertex; 3], seen: &Seen) -> bool {
    let [[left, _], [right, _]] = seen.bounds;
    if right - left < 8 << SUBPX_BITS {
        return false;
    }
    let [a, b, c] = triangle.map(|v| v.z().to_bits() >> 4);
    let (near, far) = (a.max(b).max(c), a.min(b).min(c));
    let [a, b, c] = triangle.map(|v| u32::from(v.level().to_bits()));
    let difference = a.max(b).max(c) - a.min(b).min(c);
    // 16 and 14 bits; a level has 6 fractional bits.
    difference * (near - far) > (far << (2 + 6))
}

/// Level times depth at a vertex: 30 bits.
pub(super) fn level_times_depth(v: &ScreenVertex) -> i32 {
    ((u64::from(v.level().to_bits()) * u64::from(v.z().to_bits())) >> 4) as i32
}

/// The least and the most level of the corners, 8.16. Far away, where depth has few bits,
/// a quotient may leave it.
pub(super) fn range(triangle: [&ScreenVertex; 3]) -> [u32; 2] {
    let [a, b, c] = triangle.map(|v| u32::from(v.level().to_bits()) << 10);
    [a.min(b).min(c), a.max(b).max(c).min(MOST)]
}

/// Full light.
const MOST: u32 = 255 << 16;

/// The level, 8.16, where depth (16.16, with the half that rounds it) and level
/// times depth are as given.
#[inline(always)]
fn level(z: u32, level_times_depth: u32, [least, most]: [u32; 2]) -> u32 {
    let depth = z.saturating_sub(1 << 15) >> 2; // 30 bits
    let recip = reciprocal(depth);
    // The quotient is the level / 2^14, hence this level * 2^(16 - shift) with 6
    // fractional bits.
    let high = mul_high(level_times_depth as i32, recip.mantissa).max(0) as u32;
    let level = if recip.shift >= 6 {
        high.checked_shl(recip.shift - 6).unwrap_or(MOST)
    } else {
        high >> (6 - recip.shift)
    };
    level.max(least).min(most)
}

/// `2^13 / n` for runs of n + 1 pixels, rounded to nearest: off by a 2000th at
/// most.
const STEPS: [i32; RUN] = {
    let mut table = [0; RUN];
    let mut n = 1;
    while n < RUN {
        #[expect(clippy::indexing_slicing, reason = "evaluated by the compiler")]
        {
            table[n] = ((1 << 14) / n as i32 + 1) >> 1;
        }
        n += 1;
    }
    table
};

/// A span whose level is exact at both ends of each run of 16 pixels. A function of its own: where
/// it is inlined, it is there twice.
#[inline(never)]
pub(super) fn gouraud(
    indices: &mut [u8],
    depths: &mut [Depth],
    (z, level_depth): (&Attribute, &Attribute),
    range: [u32; 2],
    mut column: i32,
    shades: &[u8; 256],
) {
    for (indices, depths) in indices.chunks_mut(RUN).zip(depths.chunks_mut(RUN)) {
        let last = indices.len() as i32 - 1;
        let mut ends = [column, column + last].map(|column| column as u32);
        for end in &mut ends {
            let column = *end as i32;
            *end = level(z.at(column), level_depth.at(column), range);
            // There once: it is long.
            keep_rolled();
        }
        let [from, to] = ends;
        let over = STEPS.get(last as usize).copied().unwrap_or(0);
        // 18 bits and a sign, times 14: 31 bits and a sign, as 255 is below 256.
        let step = (((to as i32 - from as i32) >> 6) * over) >> 7;
        let mut here = from.saturating_add(1 << 15);
        let mut z_here = z.at(column);
        for (pixel, depth) in indices.iter_mut().zip(depths) {
            let deep = (z_here >> 16) as Depth;
            if deep > *depth {
                *depth = deep;
                #[expect(clippy::indexing_slicing, reason = "a byte indexes 256 entries")]
                {
                    *pixel = shades[usize::from((here >> 16) as Level)];
                }
            }
            z_here = z_here.wrapping_add_signed(z.gradient.x);
            here = here.wrapping_add_signed(step);
            keep_rolled();
        }
        column += RUN as i32;
    }
}
