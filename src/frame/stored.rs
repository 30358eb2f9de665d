//! What a band holds for a pixel.

use core::fmt;

use bytemuck::{AnyBitPattern, NoUninit};

use super::Target;

/// What a band holds for a pixel: a palette index (`u8`), or, for those who have the RAM
/// and want no palette, a colour of 5, 6 and 5 bits in the byte order of panels (`u16`).
pub trait Stored: Copy + fmt::Debug + NoUninit + AnyBitPattern {
    /// As many as fill 32 bits.
    fn word(self) -> u32;

    /// It, if it is a palette index.
    fn index(self) -> Option<u8>;

    /// Rows as those of palette indices, if they are that: for kernels that draw nothing
    /// else.
    fn indices<'t, 'a>(target: &'t mut Target<'a, Self>) -> Option<&'t mut Target<'a>>;
}

impl Stored for u8 {
    #[inline(always)]
    fn word(self) -> u32 {
        u32::from_ne_bytes([self; 4])
    }

    #[inline(always)]
    fn index(self) -> Option<u8> {
        Some(self)
    }

    #[inline(always)]
    fn indices<'t, 'a>(target: &'t mut Target<'a>) -> Option<&'t mut Target<'a>> {
        Some(target)
    }
}

impl Stored for u16 {
    #[inline(always)]
    fn word(self) -> u32 {
        u32::from(self) | u32::from(self) << 16
    }

    #[inline(always)]
    fn index(self) -> Option<u8> {
        None
    }

    #[inline(always)]
    fn indices<'t, 'a>(_: &'t mut Target<'a, Self>) -> Option<&'t mut Target<'a>> {
        None
    }
}
