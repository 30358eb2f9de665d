//! The inner loops: one run of pixels in one row.
//!
//! Each kernel steps a depth in 16.16 and writes where it is nearer than what
//! stands there. Slices are cut once a span, so that no index is checked in the
//! loop.

use super::nearer::{BY_WORDS, put_nearer, put_nearer_of};
use crate::frame::{Stored, fill};
use crate::math::{Depth, keep_rolled};

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

/// Pixels from which on it pays to look for those that are all nearer than what stands there.
const MANY: usize = if BY_WORDS { 16 } else { 96 };

/// Pixels from which on it pays to fill in their indices afterwards.
const FILLED: usize = 128;

/// The same where there are likely many: those before the first that is not nearer than what
/// stands there, then the others by twos. A function of its own: where it is inlined, others
/// take its registers.
#[inline(never)]
pub(super) fn long_flat(
    mut indices: &mut [u8],
    mut depths: &mut [Depth],
    mut z: u32,
    dz: i32,
    index: u8,
) {
    if indices.len() >= MANY {
        let drawn = if BY_WORDS && indices.len() < FILLED {
            put_nearer_of(index, indices, depths, z, dz)
        } else {
            let drawn = put_nearer(depths, z, dz);
            fill(
                indices.get_mut(..drawn).unwrap_or_default(),
                index,
                index.word(),
            );
            drawn
        };
        let rest = (indices.get_mut(drawn..), depths.get_mut(drawn..));
        let (Some(rest), Some(rest_depths)) = rest else {
            return;
        };
        (indices, depths) = (rest, rest_depths);
        z = z.wrapping_add_signed(dz.wrapping_mul(drawn as i32));
    }
    flat_by_twos(indices, depths, z, dz, index);
}

/// The same by twos.
#[inline(always)]
fn flat_by_twos(indices: &mut [u8], depths: &mut [Depth], mut z: u32, dz: i32, index: u8) {
    let (twos, last) = indices.as_chunks_mut::<2>();
    let (two_depths, last_depth) = depths.as_chunks_mut::<2>();
    for ([a, b], [da, db]) in twos.iter_mut().zip(two_depths) {
        put(a, da, z, index);
        z = z.wrapping_add_signed(dz);
        put(b, db, z, index);
        z = z.wrapping_add_signed(dz);
        keep_rolled();
    }
    flat(last, last_depth, z, dz, index);
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

/// Depth alone.
#[inline(always)]
pub(super) fn depth(depths: &mut [Depth], mut z: u32, dz: i32) {
    for depth in depths {
        *depth = (*depth).max((z >> 16) as Depth);
        z = z.wrapping_add_signed(dz);
    }
}

/// A light level in 16.16 through a shade table's row, where there are likely few pixels.
#[inline(always)]
pub(super) fn gouraud(
    indices: &mut [u8],
    depths: &mut [Depth],
    (mut z, dz): (u32, i32),
    (mut level, dl): (u32, i32),
    shades: &[u8; 256],
) {
    for (pixel, depth) in indices.iter_mut().zip(depths) {
        put_level(pixel, depth, z, level, shades);
        z = z.wrapping_add_signed(dz);
        level = level.wrapping_add_signed(dl);
        keep_rolled();
    }
}

/// The same where there are likely many, by twos: a function of its own, as for one index.
#[inline(never)]
pub(super) fn long_gouraud(
    indices: &mut [u8],
    depths: &mut [Depth],
    (mut z, dz): (u32, i32),
    (mut level, dl): (u32, i32),
    shades: &[u8; 256],
) {
    let (twos, last) = indices.as_chunks_mut::<2>();
    let (two_depths, last_depths) = depths.as_chunks_mut::<2>();
    for ([a, b], [da, db]) in twos.iter_mut().zip(two_depths) {
        put_level(a, da, z, level, shades);
        z = z.wrapping_add_signed(dz);
        level = level.wrapping_add_signed(dl);
        put_level(b, db, z, level, shades);
        z = z.wrapping_add_signed(dz);
        level = level.wrapping_add_signed(dl);
        keep_rolled();
    }
    gouraud(last, last_depths, (z, dz), (level, dl), shades);
}

/// Draws a pixel of a level if it is nearer than what stands there.
#[inline(always)]
fn put_level(pixel: &mut u8, depth: &mut Depth, z: u32, level: u32, shades: &[u8; 256]) {
    let here = (z >> 16) as Depth;
    if here > *depth {
        *depth = here;
        #[expect(clippy::indexing_slicing, reason = "eight bits index 256 entries")]
        {
            *pixel = shades[((level >> 16) & 0xff) as usize];
        }
    }
}
