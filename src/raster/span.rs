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

/// One palette index; `SHORT` if there are likely few pixels. About 9 instructions a
/// hidden pixel, 11 a drawn one on Cortex-M4.
#[inline(always)]
pub(super) fn flat<const SHORT: bool>(
    indices: &mut [u8],
    depths: &mut [Depth],
    mut z: u32,
    dz: i32,
    index: u8,
) {
    for (pixel, depth) in indices.iter_mut().zip(depths) {
        let here = (z >> 16) as Depth;
        if here > *depth {
            *depth = here;
            *pixel = index;
        }
        z = z.wrapping_add_signed(dz);
        if SHORT {
            keep_rolled();
        }
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
