//! The inner loops: one run of pixels in one row.
//!
//! Each kernel steps a depth in 16.16 and writes where it is nearer than what
//! stands there. Slices are cut once a span, so that no index is checked in the
//! loop.

use crate::math::Depth;

/// What a triangle is filled with.
#[derive(Clone, Copy, Debug)]
pub enum Fill<'a> {
    /// One palette index.
    Flat(u8),
    /// The vertices' light level, interpolated, through a shade table's row.
    Gouraud(&'a [u8; 256]),
    /// Nothing: depth alone.
    Depth,
}

impl Fill<'_> {
    /// The index of a pixel with a light level, if it gets one.
    #[inline(always)]
    pub(crate) fn index(self, level: impl FnOnce() -> usize) -> Option<u8> {
        match self {
            Self::Flat(index) => Some(index),
            Self::Gouraud(shades) => shades.get(level()).copied(),
            Self::Depth => None,
        }
    }
}

/// One palette index, where there are likely few pixels.
#[inline(always)]
pub(super) fn flat(indices: &mut [u8], depths: &mut [Depth], mut z: u32, dz: i32, index: u8) {
    for (pixel, depth) in indices.iter_mut().zip(depths) {
        put(pixel, depth, z, index);
        z = z.wrapping_add_signed(dz);
        keep_rolled();
    }
}

/// The same where there are likely many. A function of its own, by fours: where it is
/// inlined, others take its registers.
#[inline(never)]
pub(super) fn long_flat(indices: &mut [u8], depths: &mut [Depth], mut z: u32, dz: i32, index: u8) {
    let (fours, rest) = indices.as_chunks_mut::<4>();
    let (four_depths, rest_depths) = depths.as_chunks_mut::<4>();
    for ([a, b, c, d], [ad, bd, cd, dd]) in fours.iter_mut().zip(four_depths) {
        put(a, ad, z, index);
        z = z.wrapping_add_signed(dz);
        put(b, bd, z, index);
        z = z.wrapping_add_signed(dz);
        put(c, cd, z, index);
        z = z.wrapping_add_signed(dz);
        put(d, dd, z, index);
        z = z.wrapping_add_signed(dz);
    }
    flat(rest, rest_depths, z, dz, index);
}

/// Draws a pixel if it is nearer than what stands there.
#[inline(always)]
fn put(pixel: &mut u8, depth: &mut Depth, z: u32, index: u8) {
    let here = (z >> 16) as Depth;
    if here > *depth {
        *depth = here;
        *pixel = index;
    }
}

/// Keeps the compiler from unrolling a loop: where it runs two or three times, what
/// goes before an unrolled one costs more than the loop.
#[inline(always)]
fn keep_rolled() {
    core::hint::black_box(());
}

/// Depth alone.
#[inline(always)]
pub(super) fn depth(depths: &mut [Depth], mut z: u32, dz: i32) {
    for depth in depths {
        *depth = (*depth).max((z >> 16) as Depth);
        z = z.wrapping_add_signed(dz);
    }
}

/// A light level in 16.16 through a shade table's row; `SHORT` if there are likely few
/// pixels.
#[inline(always)]
pub(super) fn gouraud<const SHORT: bool>(
    indices: &mut [u8],
    depths: &mut [Depth],
    (mut z, dz): (u32, i32),
    (mut level, dl): (u32, i32),
    shades: &[u8; 256],
) {
    for (pixel, depth) in indices.iter_mut().zip(depths) {
        let here = (z >> 16) as Depth;
        if here > *depth {
            *depth = here;
            #[expect(clippy::indexing_slicing, reason = "eight bits index 256 entries")]
            {
                *pixel = shades[((level >> 16) & 0xff) as usize];
            }
        }
        z = z.wrapping_add_signed(dz);
        level = level.wrapping_add_signed(dl);
        if SHORT {
            keep_rolled();
        }
    }
}
