//! Several pixels of the frame become one of the picture: the mean of a pixel's
//! samples, and two eyes' pictures in one.

use super::Display;
use super::samples::Samples;
use crate::frame::BandRows;
use crate::palette::{Palette, rgb565_of_sum};
use crate::scene::Output;

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
    samples: Samples<'a>,
    pixels: &'a mut [u16],
    rows: R,
}

impl<'a, R> Resolve<'a, R> {
    /// For frames of a scene with this output. Of rows wider than either buffer,
    /// only the beginning is shown.
    pub fn new(output: Output, sums: &'a mut [u32], pixels: &'a mut [u16], rows: R) -> Self {
        Self {
            samples: Samples::new(output, sums),
            pixels,
            rows,
        }
    }

    /// The panel, to draw over the frame.
    pub fn rows(&mut self) -> &mut R {
        &mut self.rows
    }
}

impl<R: Rgb565Rows> Display for Resolve<'_, R> {
    type Error = R::Error;

    fn begin(&mut self, palette: &Palette<'_>) -> Result<(), R::Error> {
        self.samples.set(palette);
        Ok(())
    }

    fn show(&mut self, rows: BandRows<'_>) -> Result<(), R::Error> {
        let Self {
            samples,
            pixels,
            rows: panel,
        } = self;
        samples.rows(rows, |y, sums| {
            for (pixel, sum) in pixels.iter_mut().zip(sums) {
                *pixel = rgb565_of_sum(*sum).to_be();
            }
            let shown = pixels.len().min(sums.len());
            panel.row(y, pixels.get(..shown).unwrap_or_default())
        })
    }
}

#[cfg(test)]
mod tests;
