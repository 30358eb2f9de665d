//! Surfaces that let what is behind them show through.

use super::lookup::{Lookup, Pixel, dithered};
use crate::light::Lit;
use crate::math::{Depth, bayer8};
use crate::raster::{LONGEST_RUN, Run};
use crate::scene::Dither;

/// The pattern of pixels that are a surface's.
#[derive(Clone, Copy, Debug)]
pub struct ScreenDoor {
    /// Where in the 64 thresholds those of the surface begin.
    pub first: u8,
    /// How many of 64 pixels are the surface's.
    pub pixels: u8,
}

impl ScreenDoor {
    /// Whether a pixel is the surface's.
    #[inline(always)]
    pub fn shows(self, place: [i32; 2]) -> bool {
        let threshold = bayer8(place) - i32::from(self.first);
        threshold & 63 < i32::from(self.pixels)
    }

    /// Shades the pixels of a run that are the surface's. For as long as it takes, the
    /// others are as near as can be, so that no kernel of runs draws them and none knows of
    /// patterns.
    pub fn shade<const A: usize, C: Copy>(
        self,
        run: &mut Run<'_, A, C>,
        shade: impl FnOnce(Run<'_, A, C>) -> usize,
    ) -> usize {
        const NEAREST: Depth = Depth::MAX;
        let mut kept = [0; LONGEST_RUN];
        let [left, row] = run.place;
        let hidden = |column: i32| !self.shows([column, row]);
        let pixels = run.depths.iter_mut().zip(&mut kept).zip(left..);
        for ((depth, kept), _) in pixels.filter(|(_, column)| hidden(*column)) {
            *kept = core::mem::replace(depth, NEAREST);
        }
        let drawn = shade(run.again());
        let pixels = run.depths.iter_mut().zip(kept).zip(left..);
        for ((depth, kept), _) in pixels.filter(|(_, column)| hidden(*column)) {
            *depth = kept;
        }
        drawn
    }
}

/// What a surface's colours are mixed with.
#[derive(Clone, Copy, Debug)]
pub struct Blend<'a> {
    /// The surface's part in 256.
    pub opacity: u16,
    /// The colours of what is behind it, by index.
    pub palette: &'a [[u8; 3]],
}

impl Blend<'_> {
    /// The light of a surface with `own` through which `behind` shows.
    #[inline(always)]
    pub fn over(&self, own: Lit, behind: Lit) -> Lit {
        let opacity = u32::from(self.opacity);
        let rest = 256 - opacity.min(256);
        let mut lit = own;
        for (c, behind) in lit.iter_mut().zip(behind) {
            let mixed = u32::from(*c) * opacity + u32::from(behind) * rest;
            *c = ((mixed + (1 << 7)) >> 8) as u16;
        }
        lit
    }
}

/// The index of a pixel of a surface through which the index `behind` shows. Of levels,
/// which have no colours to mix, none does.
#[inline(always)]
pub fn blended(pixel: &Pixel<'_>, behind: u8, blend: &Blend<'_>, dither: Dither) -> u8 {
    let Lookup::Colours(_) = pixel.lookup else {
        return dithered(pixel, dither);
    };
    let colour = blend.palette.get(usize::from(behind));
    let colour = colour.copied().unwrap_or_default();
    let lit = blend.over(pixel.lit, colour.map(|c| u16::from(c) << 6));
    dithered(&Pixel { lit, ..*pixel }, dither)
}
