//! Dithering of a grey panel's levels: from tones to levels.

use crate::math::{bayer4, bayer8, blue_noise};
use crate::palette::Tone;

/// A way from tones to a panel's levels. Firmware names the one it wants, so that only
/// that one is linked.
pub trait Dither {
    /// The levels of row `y`, 0..=`most`, from the tones of its pixels; `put` gets each
    /// column once, in some order. Rows come from the top of the screen to its
    /// bottom, whatever the bands.
    fn row(
        &mut self,
        y: u16,
        most: u8,
        tones: impl DoubleEndedIterator<Item = Tone> + ExactSizeIterator,
        put: impl FnMut(usize, u8),
    );
}

/// The level that is nearest as a display-encoded value.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Nearest;

impl Dither for Nearest {
    fn row(
        &mut self,
        _: u16,
        most: u8,
        tones: impl DoubleEndedIterator<Item = Tone> + ExactSizeIterator,
        mut put: impl FnMut(usize, u8),
    ) {
        for (x, tone) in tones.enumerate() {
            let (level, part) = (u32::from(tone >> 8), u32::from(tone & 255));
            // Half of the way from k to k + 1 has (k + 1/4) / (2k + 1) of the light
            // between them.
            let up = part * (2 * level + 1) >= 64 * (4 * level + 1);
            put(x, (level as u8).saturating_add(up.into()).min(most));
        }
    }
}

/// By thresholds: patterns that stand still while things move.
#[derive(Clone, Copy, Debug)]
pub struct Ordered(fn([i32; 2]) -> i32);

impl Ordered {
    /// Bayer's pattern of 4 by 4 pixels: 16 tones between two levels.
    pub const BAYER4: Self = Self(|place| bayer4(place) << 4 | 8);
    /// Bayer's pattern of 8 by 8 pixels: 64 tones between two levels.
    pub const BAYER8: Self = Self(|place| bayer8(place) << 2 | 2);
    /// 32 by 32 pixels without a visible pattern, 256 tones; 1 KB of flash.
    pub const BLUE_NOISE: Self = Self(blue_noise);
}

/// Columns after which every pattern repeats.
const PERIOD: usize = 32;

impl Dither for Ordered {
    fn row(
        &mut self,
        y: u16,
        most: u8,
        tones: impl DoubleEndedIterator<Item = Tone> + ExactSizeIterator,
        mut put: impl FnMut(usize, u8),
    ) {
        let mut thresholds = [0; PERIOD];
        for (x, threshold) in (0..).zip(&mut thresholds) {
            *threshold = (self.0)([x, y.into()]);
        }
        for (x, tone) in tones.enumerate() {
            #[expect(clippy::indexing_slicing, reason = "it is below the length")]
            let threshold = thresholds[x % PERIOD];
            let level = (i32::from(tone) + threshold) >> 8;
            put(x, (level as u8).min(most));
        }
    }
}

/// Error diffusion (Floyd and Steinberg, "An adaptive algorithm for spatial greyscale",
/// 1976), every other row from right to left. What leaves at the sides is lost.
#[derive(Debug)]
pub struct Diffused<'a> {
    /// What the row above left to each column.
    errors: &'a mut [i16],
}

impl<'a> Diffused<'a> {
    /// Needs an entry for each column of the screen; columns past them are not
    /// shown.
    pub fn new(errors: &'a mut [i16]) -> Self {
        Self { errors }
    }
}

impl Dither for Diffused<'_> {
    fn row(
        &mut self,
        y: u16,
        most: u8,
        tones: impl DoubleEndedIterator<Item = Tone> + ExactSizeIterator,
        mut put: impl FnMut(usize, u8),
    ) {
        if y == 0 {
            self.errors.fill(0);
        }
        let width = tones.len().min(self.errors.len());
        let errors = self.errors.get_mut(..width).unwrap_or_default();
        let pixels = errors.iter_mut().zip(tones).enumerate();
        let put = |(x, level)| put(x, level);
        if y.is_multiple_of(2) {
            diffuse(most, pixels, put);
        } else {
            diffuse(most, pixels.rev(), put);
        }
    }
}

/// One row, in the order of its pixels.
fn diffuse<'e>(
    most: u8,
    pixels: impl Iterator<Item = (usize, (&'e mut i16, Tone))>,
    mut put: impl FnMut((usize, u8)),
) {
    // What goes to the next pixel, to the one below the last, and to the one below this.
    let (mut ahead, mut below_last, mut below) = (0, 0, 0);
    let mut last: Option<&mut i16> = None;
    for (x, (error, tone)) in pixels {
        // Levels are at most 15, and what is passed on is less than one of them.
        let wanted = i32::from(tone) + i32::from(*error) + ahead;
        let level = ((wanted + 128) >> 8).clamp(0, most.into());
        put((x, level as u8));
        let off = (wanted - (level << 8)).clamp(-256, 256);
        ahead = (off * 7) >> 4;
        let (back, straight) = ((off * 3) >> 4, (off * 5) >> 4);
        if let Some(last) = last {
            *last = (below_last + back) as i16;
        }
        last = Some(error);
        below_last = below + straight;
        below = off - ahead - back - straight;
    }
    if let Some(last) = last {
        *last = below_last as i16;
    }
}

#[cfg(test)]
mod tests;
