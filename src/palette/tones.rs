//! Grey panels: from a colour to a place between the panel's levels.

use super::Palette;

/// A level of the panel in its upper bits and, in the lower 8, the way from there to
/// the next one: level 1 is 256.
pub type Tone = u16;

/// ITU-R BT.601 luma of a display-encoded colour, rounded to nearest.
pub const fn luma([r, g, b]: [u8; 3]) -> u8 {
    ((299 * r as u32 + 587 * g as u32 + 114 * b as u32 + 500) / 1000) as u8
}

/// Where a grey of 0..=255 lies between the levels 0..=`most` of a panel, which are
/// evenly spaced as display-encoded values. Between two levels it is light that counts,
/// as a person sees it who does not tell the pixels apart: light is taken as the
/// square of the value. Rounded to nearest, 256 steps a level.
pub const fn tone(grey: u8, most: u8) -> Tone {
    let (grey, most) = (grey as u32, if most == 0 { 1 } else { most as u32 });
    let level = grey * most / 255;
    // In units of 1 / (255 most).
    let (here, next, value) = (255 * level, 255 * (level + 1), grey * most);
    // At most 2^17 (most + 1): with 4 bits, 256 of them are below 2^29. It is 255^2 times an
    // odd number, hence odd, and saying so takes the check for division by zero away.
    let step = (next * next - here * here) | 1;
    // Of more than 126 levels, which no panel has, it wraps.
    let way = (value * value - here * here).wrapping_mul(256);
    let part = way.wrapping_add(step / 2) / step;
    (level * 256 + part) as Tone
}

/// The tone of each palette entry. 512 bytes.
#[derive(Clone, Debug)]
pub struct Tones {
    table: [Tone; 256],
    most: u8,
}

impl Tones {
    /// For a panel with levels 0..=`most`, which is 1, 3 or 15; all black.
    pub const fn new(most: u8) -> Self {
        Self {
            table: [0; 256],
            most,
        }
    }

    /// The panel's highest level.
    pub fn most(&self) -> u8 {
        self.most
    }

    /// Takes over a palette.
    pub fn set(&mut self, palette: &Palette<'_>) {
        for (entry, colour) in self.table.iter_mut().zip(palette.entries()) {
            *entry = tone(luma(colour), self.most);
        }
    }

    /// The tone of an index.
    #[inline]
    pub fn of(&self, index: u8) -> Tone {
        #[expect(clippy::indexing_slicing, reason = "a byte indexes 256 entries")]
        self.table[usize::from(index)]
    }
}

#[cfg(test)]
mod tests;
