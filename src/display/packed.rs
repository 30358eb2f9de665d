//! Panels with few levels of grey: several pixels in a byte.

use super::{Display, Dither};
use crate::frame::BandRows;
use crate::palette::{Palette, Tone, Tones};

/// A panel that takes packed pixels.
pub trait PackedRows {
    /// What can go wrong on the way.
    type Error;

    /// The picture's rows from `y` on are finished: one of them, or with
    /// [`Packing::Pages`] a page of eight (fewer at the bottom of a screen whose height is no
    /// multiple of eight). `bytes` are theirs.
    ///
    /// # Errors
    /// Those of the panel's bus.
    fn rows(&mut self, y: u16, bytes: &[u8]) -> Result<(), Self::Error>;
}

/// How pixels lie in bytes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Packing {
    /// 8 pixels of a row in a byte, the left one in the highest bit: e-paper (SSD1680,
    /// UC8151), memory LCDs, Linux framebuffers. A row starts a byte.
    Rows1,
    /// 4 pixels of a row in a byte, the left one in the highest bits.
    Rows2,
    /// 2 pixels of a row in a byte, the left one in the high half: SSD1327, SSD1322.
    Rows4,
    /// 8 pixels of a column in a byte, the top one in the lowest bit; pages of 8 rows,
    /// each from left to right: SSD1306, SH1106, ST7567.
    Pages,
}

impl Packing {
    /// Bits of a pixel.
    pub const fn bits(self) -> u8 {
        match self {
            Self::Rows1 | Self::Pages => 1,
            Self::Rows2 => 2,
            Self::Rows4 => 4,
        }
    }

    /// The highest level.
    pub const fn most(self) -> u8 {
        (1 << self.bits()) - 1
    }

    /// Bytes of a row, or of a page.
    pub const fn bytes(self, width: u16) -> usize {
        match self {
            Self::Pages => width as usize,
            rows => (width as usize * rows.bits() as usize).div_ceil(8),
        }
    }

    /// Logarithms of the pixels of a row in a byte and of a pixel's bits, and by how much the
    /// level of a byte's first pixel is shifted.
    const fn places(self, y: u16) -> (u8, u8, u8) {
        match self {
            Self::Rows1 => (3, 0, 7),
            Self::Rows2 => (2, 1, 6),
            Self::Rows4 => (1, 2, 4),
            Self::Pages => (0, 0, y as u8 & 7),
        }
    }

    /// The level of a pixel in the bytes of its row or page; 0 if it is past them.
    pub fn level(self, bytes: &[u8], x: usize, y: u16) -> u8 {
        let (in_byte, log_bits, first) = self.places(y);
        let (byte, shift) = place(x, in_byte, log_bits, first);
        bytes
            .get(byte)
            .map_or(0, |byte| byte >> shift & self.most())
    }
}

/// The byte of a pixel, and by how much its level is shifted there.
#[inline(always)]
const fn place(x: usize, in_byte: u8, log_bits: u8, first: u8) -> (usize, u8) {
    let within = x as u8 & ((1 << in_byte) - 1);
    (x >> in_byte, first - (within << log_bits))
}

/// Shows frames on a panel of 1, 2 or 4 bits a pixel: a palette entry's grey is dithered to
/// the panel's levels, which are packed. 1 is white. Needs the bytes of one row (or page), and
/// 512 bytes for the palette, whatever the band's height; the bytes do not depend on it.
///
/// ```
/// use fixel::display::{Ordered, Packed, PackedRows, Packing};
///
/// struct Oled;
/// impl PackedRows for Oled {
///     type Error = ();
///     fn rows(&mut self, y: u16, page: &[u8]) -> Result<(), ()> {
///         // Page y / 8, then its bytes.
///         Ok(())
///     }
/// }
/// let mut page = [0; 128];
/// let display = Packed::new(Packing::Pages, 64, Ordered::BAYER8, &mut page, Oled);
/// // render_frame(.., &mut display)
/// ```
#[derive(Debug)]
pub struct Packed<'a, D, R> {
    tones: Tones,
    packer: Packer<'a, D, R>,
}

/// All but the palette.
#[derive(Debug)]
struct Packer<'a, D, R> {
    packing: Packing,
    height: u16,
    dither: D,
    bytes: &'a mut [u8],
    rows: R,
}

impl<'a, D: Dither, R: PackedRows> Packed<'a, D, R> {
    /// For a screen of so many rows. `bytes` are as many as [`Packing::bytes`]; of a
    /// row that has more, only the beginning is shown.
    pub fn new(packing: Packing, height: u16, dither: D, bytes: &'a mut [u8], rows: R) -> Self {
        Self {
            tones: Tones::new(packing.most()),
            packer: Packer {
                packing,
                height,
                dither,
                bytes,
                rows,
            },
        }
    }

    /// The panel.
    pub fn rows(&mut self) -> &mut R {
        &mut self.packer.rows
    }

    /// How its pixels lie in bytes.
    pub fn packing(&self) -> Packing {
        self.packer.packing
    }

    /// Shows one row of tones, for what does not come from the palette. Rows come from
    /// the top of the screen to its bottom.
    ///
    /// # Errors
    /// Those of the panel's bus.
    pub fn row(
        &mut self,
        y: u16,
        tones: impl DoubleEndedIterator<Item = Tone> + ExactSizeIterator,
    ) -> Result<(), R::Error> {
        self.packer.row(y, tones)
    }
}

/// One row's levels into its bytes; the constants are those of [`place`], because small cores
/// have few registers.
#[inline(never)]
fn pack<D: Dither, const IN_BYTE: u8, const LOG_BITS: u8>(
    dither: &mut D,
    y: u16,
    first: u8,
    tones: impl DoubleEndedIterator<Item = Tone> + ExactSizeIterator,
    bytes: &mut [u8],
) {
    let most = (1 << (1 << LOG_BITS)) - 1;
    dither.row(y, most, tones, |x, level| {
        let (byte, shift) = place(x, IN_BYTE, LOG_BITS, first);
        if let Some(byte) = bytes.get_mut(byte) {
            *byte |= level << shift;
        }
    });
}

impl<D: Dither, R: PackedRows> Packer<'_, D, R> {
    fn row(
        &mut self,
        y: u16,
        tones: impl DoubleEndedIterator<Item = Tone> + ExactSizeIterator,
    ) -> Result<(), R::Error> {
        let packing = self.packing;
        let bytes = &mut *self.bytes;
        let pages = packing == Packing::Pages;
        if !pages || y.is_multiple_of(8) {
            bytes.fill(0);
        }
        let width = tones.len().min(usize::from(u16::MAX)) as u16;
        let dither = &mut self.dither;
        match packing {
            Packing::Rows1 => pack::<_, 3, 0>(dither, y, 7, tones, bytes),
            Packing::Rows2 => pack::<_, 2, 1>(dither, y, 6, tones, bytes),
            Packing::Rows4 => pack::<_, 1, 2>(dither, y, 4, tones, bytes),
            Packing::Pages => pack::<_, 0, 0>(dither, y, y as u8 & 7, tones, bytes),
        }
        if pages && y % 8 != 7 && y.saturating_add(1) != self.height {
            return Ok(());
        }
        let top = if pages { y & !7 } else { y };
        let used = packing.bytes(width).min(bytes.len());
        self.rows.rows(top, bytes.get(..used).unwrap_or_default())
    }
}

impl<D: Dither, R: PackedRows> Display for Packed<'_, D, R> {
    type Error = R::Error;

    fn begin(&mut self, palette: &Palette<'_>) -> Result<(), R::Error> {
        self.tones.set(palette);
        Ok(())
    }

    fn show(&mut self, rows: BandRows<'_>) -> Result<(), R::Error> {
        let width = usize::from(rows.width).max(1);
        let Self { tones, packer } = self;
        let mut y = rows.top;
        for indices in rows.indices.chunks_exact(width) {
            packer.row(y, indices.iter().map(|index| tones.of(*index)))?;
            y = y.wrapping_add(1);
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests;
