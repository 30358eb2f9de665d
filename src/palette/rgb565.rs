//! 16-bit colour.

use super::Palette;

/// 5, 6 and 5 bits of red, green and blue, each rounded to nearest.
pub const fn rgb565([r, g, b]: [u8; 3]) -> u16 {
    round(r, 31) << 11 | round(g, 63) << 5 | round(b, 31)
}

/// 5 bits each of blue, green and red, blue in the highest but one, each rounded to
/// nearest: as the palettes of some consoles' panels have them.
pub const fn bgr555([r, g, b]: [u8; 3]) -> u16 {
    round(b, 31) << 10 | round(g, 31) << 5 | round(r, 31)
}

const fn round(v: u8, most: u16) -> u16 {
    (v as u16 * most + 127) / 255
}

/// 5, 6 and 5 bits of a sum of four samples, whose red, green and blue have 10 bits
/// each (1020 is full), red in the highest, each rounded to nearest: of four times the same
/// colour, [`rgb565`] of that.
#[inline]
pub const fn rgb565_of_sum(sum: u32) -> u16 {
    const fn round(sum: u32, most: u32) -> u16 {
        // most / 1020 in 2^-20, rounded up: off by less than 0.001 at most, less
        // than any sum of four equal samples is from the middle of two steps.
        let factor = (most << 20).div_ceil(1020);
        (((sum & 0x3ff) * factor + (1 << 19)) >> 20) as u16
    }
    round(sum >> 20, 31) << 11 | round(sum >> 10, 63) << 5 | round(sum, 31)
}

/// 5, 6 and 5 bits of red, green and blue in 1/64 of 255 levels, at most full, each rounded
/// to nearest.
#[inline]
pub const fn rgb565_of_light([r, g, b]: [u16; 3]) -> u16 {
    const fn round(c: u16, most: u32) -> u16 {
        // most / (255 * 64) in 2^-20: off by less than a 250th of a step at most.
        let factor = ((most << 20) + 255 * 32) / (255 * 64);
        ((c as u32 * factor + (1 << 19)) >> 20) as u16
    }
    round(r, 31) << 11 | round(g, 63) << 5 | round(b, 31)
}

/// The way back: red, green and blue in 1/64 of 255 levels, rounded to nearest.
#[inline]
pub const fn light_of_rgb565(colour: u16) -> [u16; 3] {
    const fn widen(c: u16, most: u32) -> u16 {
        // 255 * 64 / most in 2^-6.
        let factor = ((255 * 64) << 6) / most;
        ((c as u32 * factor + (1 << 5)) >> 6) as u16
    }
    [
        widen(colour >> 11, 31),
        widen(colour >> 5 & 63, 63),
        widen(colour & 31, 31),
    ]
}

/// A look-up table from index to RGB565 in the byte order of panels: high byte
/// first. 512 bytes.
#[derive(Clone, Debug)]
pub struct Rgb565Table {
    table: [u16; 256],
}

impl Default for Rgb565Table {
    fn default() -> Self {
        Self::new()
    }
}

impl Rgb565Table {
    /// All black.
    pub const fn new() -> Self {
        Self { table: [0; 256] }
    }

    /// Takes over a palette.
    pub fn set(&mut self, palette: &Palette<'_>) {
        for (entry, colour) in self.table.iter_mut().zip(palette.entries()) {
            *entry = rgb565(colour).to_be();
        }
    }

    /// The colour of each index, in the byte order of panels; as many as both
    /// slices hold.
    ///
    /// Four at a time: where all four are as the last ones were, as in a background, their
    /// colours are, too, so that a pixel takes two instructions on a Cortex-M, else
    /// five.
    #[inline]
    pub fn resolve(&self, indices: &[u8], pixels: &mut [u16]) {
        let count = indices.len().min(pixels.len());
        let indices = indices.get(..count).unwrap_or_default();
        let (before, words, after) = bytemuck::pod_align_to::<u8, u32>(indices);
        // The three have `count` indices together, so that both are there.
        let Some((first, rest)) = pixels.split_at_mut_checked(before.len()) else {
            return;
        };
        let Some((middle, last)) = rest.split_at_mut_checked(4 * words.len()) else {
            return;
        };
        self.one_by_one(before, first);
        match bytemuck::try_cast_slice_mut(middle) {
            Ok(middle) => self.by_words(words, middle),
            // Pixels of which four do not begin on a word where four indices do.
            Err(_) => self.one_by_one(bytemuck::cast_slice(words), middle),
        }
        self.one_by_one(after, last);
    }

    /// Not inlined: where the table is a static, its address would be made anew for each
    /// word.
    #[inline(never)]
    fn by_words(&self, words: &[u32], pixels: &mut [[u32; 2]]) {
        let four = |word: u32| {
            let colours = word.to_ne_bytes().map(|index| self.colour(index));
            bytemuck::cast::<[u16; 4], [u32; 2]>(colours)
        };
        let mut known = 0;
        let mut colours = four(known);
        for (pixels, word) in pixels.iter_mut().zip(words) {
            if *word != known {
                known = *word;
                colours = four(known);
            }
            *pixels = colours;
        }
    }

    fn one_by_one(&self, indices: &[u8], pixels: &mut [u16]) {
        for (pixel, index) in pixels.iter_mut().zip(indices) {
            *pixel = self.colour(*index);
        }
    }

    #[inline(always)]
    fn colour(&self, index: u8) -> u16 {
        #[expect(clippy::indexing_slicing, reason = "a byte indexes 256 entries")]
        self.table[usize::from(index)]
    }
}
