//! The inner loops: one run of pixels in one row.
//!
//! Each kernel steps a depth in 16.16 and writes where it is nearer than what
//! stands there. Slices are cut once a span, so that no index is checked in the
//! loop.

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

/// Pixels from which on it pays to go by words.
const MANY: usize = 12;

/// The same where there are likely many. A function of its own: where it is inlined,
/// others take its registers.
#[inline(never)]
pub(super) fn long_flat(indices: &mut [u8], depths: &mut [Depth], mut z: u32, dz: i32, index: u8) {
    if !cfg!(narrow_multiply) {
        flat_by_words(indices, depths, z, dz, index);
        return;
    }
    // Cores with few registers go by twos.
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

/// Two pixels at a time, from a place on where two depths are a word and their indices
/// half of one.
#[inline(always)]
fn flat_by_words(indices: &mut [u8], depths: &mut [Depth], mut z: u32, dz: i32, index: u8) {
    if indices.len() < MANY {
        flat(indices, depths, z, dz, index);
        return;
    }
    let (before, pairs, after) = bytemuck::pod_align_to_mut::<u8, u16>(indices);
    let rest = depths.split_at_mut_checked(before.len());
    let Some((depths_before, rest)) = rest else {
        return;
    };
    let Some((middle, depths_after)) = rest.split_at_mut_checked(2 * pairs.len()) else {
        return;
    };
    flat(before, depths_before, z, dz, index);
    let along = |pixels: usize| dz.wrapping_mul(pixels as i32);
    z = z.wrapping_add_signed(along(before.len()));
    match bytemuck::try_cast_slice_mut(middle) {
        Ok(depths) => flat_pairs(pairs, depths, z, dz, index),
        // Depths of which two do not begin on a word where two indices do.
        Err(_) => flat(bytemuck::cast_slice_mut(pairs), middle, z, dz, index),
    };
    z = z.wrapping_add_signed(along(2 * pairs.len()));
    flat(after, depths_after, z, dz, index);
}

/// A function of its own again, for its registers.
#[inline(never)]
fn flat_pairs(pairs: &mut [u16], depths: &mut [u32], mut z: u32, dz: i32, index: u8) {
    let both = u16::from_ne_bytes([index; 2]);
    for (pair, depth) in pairs.iter_mut().zip(depths) {
        let behind = ordered(*depth);
        let next = z.wrapping_add_signed(dz);
        let (first, second) = (z >> 16, next & 0xffff_0000);
        // The second depth's lower half is empty, and so no larger than what is behind
        // unless its upper half is.
        if second > behind && first > behind & 0xffff {
            *depth = ordered(second | first);
            *pair = both;
        } else if second > behind || first > behind & 0xffff {
            one_of_two(pair, depth, [first, second], index);
        }
        z = next.wrapping_add_signed(dz);
        keep_rolled();
    }
}

/// Draws the one of two pixels that is nearer than what stands there.
#[cold]
#[inline(never)]
fn one_of_two(pair: &mut u16, depths: &mut u32, [first, second]: [u32; 2], index: u8) {
    let ([a, b], behind) = (pair.to_ne_bytes(), ordered(*depths));
    let (indices, nearer) = if second > behind {
        ([a, index], behind & 0xffff | second)
    } else {
        ([index, b], behind & 0xffff_0000 | first)
    };
    *pair = u16::from_ne_bytes(indices);
    *depths = ordered(nearer);
}

/// Two depths in memory as a word, or back: the first is in the lower half.
#[inline(always)]
const fn ordered(depths: u32) -> u32 {
    if cfg!(target_endian = "big") {
        depths.rotate_left(16)
    } else {
        depths
    }
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
