//! Colours of other depths, packed as panels take them.

use super::Palette;

/// A look-up table from index to RGB444. 512 bytes.
#[derive(Clone, Debug)]
pub struct Rgb444Table {
    table: [u16; 256],
}

impl Default for Rgb444Table {
    fn default() -> Self {
        Self::new()
    }
}

impl Rgb444Table {
    /// All black.
    pub const fn new() -> Self {
        Self { table: [0; 256] }
    }

    /// Takes over a palette: each channel rounded to the nearest of 16.
    pub fn set(&mut self, palette: &Palette<'_>) {
        for (entry, colour) in self.table.iter_mut().zip(palette.entries()) {
            let [r, g, b] = colour.map(|c| (u16::from(c) * 15 + 127) / 255);
            *entry = r << 8 | g << 4 | b;
        }
    }

    /// Two pixels in three bytes, red first and the higher bits first, as ST7789 and its
    /// kin take them (COLMOD 3); gives the bytes used. Of an odd number, the
    /// last pixel is in one and a half, and the rest 0. Only as many pixels as there is
    /// room for.
    pub fn pack(&self, indices: &[u8], bytes: &mut [u8]) -> usize {
        let mut used = 0;
        for (pixels, bytes) in indices.chunks(2).zip(bytes.as_chunks_mut::<3>().0) {
            let mut two = pixels.iter().map(|index| self.colour(*index));
            let (a, b) = (two.next().unwrap_or(0), two.next().unwrap_or(0));
            *bytes = [(a >> 4) as u8, (a << 4 | b >> 8) as u8, b as u8];
            used += if pixels.len() == 2 { 3 } else { 2 };
        }
        used
    }

    #[inline]
    fn colour(&self, index: u8) -> u16 {
        #[expect(clippy::indexing_slicing, reason = "a byte indexes 256 entries")]
        self.table[usize::from(index)]
    }
}

/// Three bytes a pixel: red, green, blue; gives the bytes used.
pub fn pack_rgb888(palette: &Palette<'_>, indices: &[u8], bytes: &mut [u8]) -> usize {
    let mut used = 0;
    for (index, pixel) in indices.iter().zip(bytes.as_chunks_mut::<3>().0) {
        *pixel = palette.rgb888(*index);
        used += 3;
    }
    used
}

#[cfg(test)]
mod tests {
    use super::*;

    const COLOURS: [[u8; 3]; 3] = [[0, 17, 255], [34, 51, 68], [255, 8, 9]];

    #[test]
    fn two_pixels_are_three_bytes() {
        let mut table = Rgb444Table::new();
        table.set(&Palette::new(&COLOURS));
        let mut bytes = [0x55; 7];
        assert_eq!(table.pack(&[0, 1, 2], &mut bytes), 5);
        assert_eq!(bytes, [0x01, 0xf2, 0x34, 0xf0, 0x10, 0, 0x55]);
        assert_eq!(table.pack(&[0, 1, 2], &mut bytes[..5]), 3);
    }

    #[test]
    fn a_pixel_is_three_bytes() {
        let mut bytes = [0; 7];
        let palette = Palette::new(&COLOURS);
        assert_eq!(pack_rgb888(&palette, &[1, 2, 0], &mut bytes), 6);
        assert_eq!(bytes, [34, 51, 68, 255, 8, 9, 0]);
    }
}
