//! Several pixels of the frame become one of the picture: the mean of a pixel's
//! samples, and two eyes' pictures in one.

use super::Display;
use crate::frame::BandRows;
use crate::palette::{Palette, rgb565_of_sum};
use crate::scene::{Output, Stereo};

/// A panel that takes RGB565.
pub trait Rgb565Rows {
    /// What can go wrong on the way.
    type Error;

    /// A row of the picture, in the byte order of panels: high byte first.
    ///
    /// # Errors
    /// Those of the panel's bus.
    fn row(&mut self, y: u16, pixels: &[u16]) -> Result<(), Self::Error>;
}

/// Shows a frame whose pixels are samples ([`Output::is_resolved`]) on a panel.
/// Samples are averaged as display-encoded colours. Needs a row of sums (4 bytes a
/// pixel of the picture) and a row of pixels (2 bytes), and 1 KB for the palette,
/// whatever the band's height.
#[derive(Debug)]
pub struct Resolve<'a, R> {
    output: Output,
    /// Colours of the palette, 10 bits a channel; see [`rgb565_of_sum`].
    table: [u32; 256],
    sums: &'a mut [u32],
    pixels: &'a mut [u16],
    rows: R,
}

/// The bits of red in a sum.
const RED: u32 = 0x3ff << 20;

impl<'a, R> Resolve<'a, R> {
    /// For frames of a scene with this output. Of rows wider than either buffer,
    /// only the beginning is shown.
    pub fn new(output: Output, sums: &'a mut [u32], pixels: &'a mut [u16], rows: R) -> Self {
        Self {
            output,
            table: [0; 256],
            sums,
            pixels,
            rows,
        }
    }

    /// The panel, to draw over the frame.
    pub fn rows(&mut self) -> &mut R {
        &mut self.rows
    }

    /// One row of samples; says whether the row of the picture is finished.
    fn add(&mut self, y: u16, indices: &[u8]) -> bool {
        let [across, down] = self.output.samples.map(|n| u16::from(n.max(1)));
        let across = usize::from(across);
        let which = y % down;
        if which == 0 {
            self.sums.fill(0);
        }
        if self.output.stereo == Stereo::Anaglyph {
            let (left, right) = indices.split_at(indices.len() / 2);
            add(self.sums, &self.table, left, across, RED);
            add(self.sums, &self.table, right, across, !RED);
        } else {
            add(self.sums, &self.table, indices, across, u32::MAX);
        }
        which + 1 == down
    }
}

/// Adds samples' colours to the sums of their pixels.
fn add(sums: &mut [u32], table: &[u32; 256], indices: &[u8], across: usize, channels: u32) {
    #[expect(clippy::indexing_slicing, reason = "a byte indexes 256 entries")]
    let colour = |index: u8| table[usize::from(index)];
    if across == 2 {
        for (sum, pair) in sums.iter_mut().zip(indices.as_chunks::<2>().0) {
            let [a, b] = *pair;
            *sum += (colour(a) + colour(b)) & channels;
        }
    } else {
        for (sum, index) in sums.iter_mut().zip(indices) {
            *sum += colour(*index) & channels;
        }
    }
}

impl<R: Rgb565Rows> Display for Resolve<'_, R> {
    type Error = R::Error;

    fn begin(&mut self, palette: &Palette<'_>) -> Result<(), R::Error> {
        let [across, down] = self.output.samples.map(|n| u32::from(n.max(1)));
        // Four of the largest fill 10 bits but for 3.
        let each = 4 / (across * down).clamp(1, 4);
        for (entry, colour) in self.table.iter_mut().zip(palette.entries()) {
            let [r, g, b] = colour.map(|c| u32::from(c) * each);
            *entry = r << 20 | g << 10 | b;
        }
        Ok(())
    }

    fn show(&mut self, rows: BandRows<'_>) -> Result<(), R::Error> {
        let width = usize::from(rows.width);
        let (picture_width, _) = self.output.picture_size((rows.width, 1));
        for (y, indices) in (rows.top..).zip(rows.indices.chunks_exact(width.max(1))) {
            if !self.add(y, indices) {
                continue;
            }
            for (pixel, sum) in self.pixels.iter_mut().zip(&*self.sums) {
                *pixel = rgb565_of_sum(*sum).to_be();
            }
            let shown = self.pixels.len().min(picture_width.into());
            let pixels = self.pixels.get(..shown).unwrap_or_default();
            let [_, down] = self.output.samples.map(|n| u16::from(n.max(1)));
            self.rows.row(y / down, pixels)?;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests;
