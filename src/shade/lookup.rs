//! From light to a palette index.

use crate::light::Lit;
use crate::math::{bayer4, bayer8};
use crate::scene::layout::{BASES, COLOURS, TEXTURE_SHADES};
use crate::scene::{Dither, DitherPattern};

/// A material's way from light to a palette index.
#[derive(Clone, Copy, Debug)]
pub enum Lookup<'a> {
    /// By the level, which is the first channel.
    Levels(&'a [u8; 256]),
    /// By the colour, 4 bits a channel.
    Colours(&'a [u8; COLOURS]),
    /// By the level's highest 6 bits and the base colour of a texel.
    Texel(&'a [u8; TEXTURE_SHADES], u8),
}

/// A pixel of a surface.
#[derive(Clone, Copy, Debug)]
pub struct Pixel<'a> {
    /// The way to its index.
    pub lookup: Lookup<'a>,
    /// Its light.
    pub lit: Lit,
    /// Its screen column and row.
    pub place: [i32; 2],
    /// Where in a texture it is, in texels with 16 fractional bits, modulo 2^32.
    pub texel: [i32; 2],
}

/// A channel's full light, and what a 15th of it is.
const STEP: u32 = (255 << 6) / 15;

/// The index of the nearest colour that the look-up has; colours between palette
/// entries become patterns of them, by ordered
/// dithering (Bayer, "An optimum method for two-level rendition of continuous-tone
/// pictures", 1973). Levels are not dithered.
#[inline(always)]
pub fn dithered(pixel: &Pixel<'_>, dither: Dither) -> u8 {
    index(pixel.lookup, pixel.lit, dither.offset(pixel.place))
}

impl Dither {
    /// What is added to a channel at a screen column and row, in 1/64 of a level.
    #[inline(always)]
    pub fn offset(self, [column, row]: [i32; 2]) -> i32 {
        let threshold = match self.pattern {
            DitherPattern::None => return 0,
            DitherPattern::Bayer4 => bayer4([column, row]) << 2 | 2,
            DitherPattern::Bayer8 => bayer8([column, row]),
        };
        let spread = i32::from(self.spread);
        (((threshold << 1 | 1) * spread) >> 7) - (spread >> 1)
    }
}

#[inline(always)]
fn index(lookup: Lookup<'_>, lit: Lit, offset: i32) -> u8 {
    match lookup {
        Lookup::Levels(shades) => {
            let [level, ..] = lit;
            let level = ((u32::from(level) + 32) >> 6).min(255);
            shades.get(level as usize).copied().unwrap_or(0)
        }
        Lookup::Texel(shades, base) => {
            let [level, ..] = lit;
            let row = (usize::from(level) + 32) >> 8;
            #[expect(clippy::indexing_slicing, reason = "held below the length")]
            shades[row * BASES % TEXTURE_SHADES + usize::from(base) % BASES]
        }
        Lookup::Colours(colours) => {
            // (c + half a step) / STEP, below 16.
            let step = |c: u16| {
                let c = (i32::from(c) + offset).clamp(0, 255 << 6) as u32;
                ((c + STEP / 2) * ((1 << 26) / STEP + 1)) >> 26
            };
            let [r, g, b] = lit.map(step);
            #[expect(clippy::indexing_slicing, reason = "held below the length")]
            colours[(r << 8 | g << 4 | b) as usize % COLOURS]
        }
    }
}
