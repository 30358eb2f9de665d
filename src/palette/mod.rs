//! From palette indices to a panel's colours. In: indices of finished rows and
//! the palette. Out: bytes that a panel takes. Used by `display`, `render` and
//! `ray`.
#![expect(
    clippy::arithmetic_side_effects,
    reason = "channels of 8 bits, in wider integers; tests stop at overflow"
)]

mod convert;
mod packed;
mod rgb565;
mod tones;

pub use convert::{cmy, cmyk, cmyk_of, cross_fade, fade, hsv, hsv_of, mixed};
pub use packed::{Rgb444Table, pack_rgb888};
pub use rgb565::{Rgb565Table, bgr555, light_of_rgb565, rgb565, rgb565_of_light, rgb565_of_sum};
pub use tones::{Tone, Tones, luma, tone};

/// Red, green and blue of up to 256 entries, 8 bits each.
#[derive(Clone, Copy, Debug)]
pub struct Palette<'a> {
    /// The entries as the scene has them; an index past the end is black.
    pub colours: &'a [[u8; 3]],
    /// What of them goes round.
    pub cycle: Cycle,
}

/// Palette entries that take each other's place, so that a picture moves without
/// being drawn again.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Cycle {
    /// The first entry.
    pub first: u16,
    /// How many there are.
    pub count: u16,
    /// An entry looks as the one so many further on, the last one being followed by
    /// the first; any number.
    pub shift: u16,
}

impl Cycle {
    /// The entry whose colour an entry has now.
    fn source(&self, index: u8) -> usize {
        let (index, first) = (usize::from(index), usize::from(self.first));
        let count = usize::from(self.count);
        match index.checked_sub(first) {
            Some(place) if place < count => {
                let moved = place + usize::from(self.shift);
                first + moved.checked_rem(count).unwrap_or(0)
            }
            _ => index,
        }
    }
}

impl<'a> Palette<'a> {
    /// Entries that stay.
    pub const fn new(colours: &'a [[u8; 3]]) -> Self {
        let cycle = Cycle {
            first: 0,
            count: 0,
            shift: 0,
        };
        Self { colours, cycle }
    }

    /// The colour of an index.
    pub fn rgb888(&self, index: u8) -> [u8; 3] {
        self.colours
            .get(self.cycle.source(index))
            .copied()
            .unwrap_or_default()
    }

    /// The index of the colour that is nearest, by squares of the differences in red, green and
    /// blue, weighted 3, 6 and 1 as the eye does; the first of several.
    pub fn nearest(&self, colour: [u8; 3]) -> u8 {
        let distance = |entry: [u8; 3]| {
            let mut sum = 0;
            for ((a, b), weight) in entry.into_iter().zip(colour).zip([3, 6, 1]) {
                let off = u32::from(a.abs_diff(b));
                sum += off * off * weight;
            }
            sum
        };
        let all = (0..=u8::MAX).zip(self.entries());
        let nearest = all.min_by_key(|(_, entry)| distance(*entry));
        nearest.map_or(0, |(index, _)| index)
    }

    /// The colours of all indices up to the last one in use.
    pub fn entries(&self) -> impl Iterator<Item = [u8; 3]> + use<'_> {
        let all = 0..=u8::MAX;
        all.take(self.colours.len()).map(|index| self.rgb888(index))
    }
}

#[cfg(test)]
mod tests;
