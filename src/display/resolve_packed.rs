//! Frames of several samples a pixel on panels with few levels of grey.

use super::packed::{Packed, PackedRows};
use super::samples::Samples;
use super::{Display, Dither};
use crate::frame::BandRows;
use crate::palette::{Palette, luma, tone};
use crate::scene::Output;

/// Shows a frame whose pixels are samples ([`Output::is_resolved`]) on a panel of 1, 2 or 4
/// bits a pixel: samples are averaged as display-encoded colours, whose grey is dithered as
/// [`Packed`] does it. Needs a row of sums (4 bytes a pixel of the picture) and 1 KB
/// for the palette beside what that needs, whatever the band's height.
#[derive(Debug)]
pub struct ResolvePacked<'a, 'p, D, R> {
    samples: Samples<'a>,
    packed: Packed<'p, D, R>,
}

impl<'a, 'p, D: Dither, R: PackedRows> ResolvePacked<'a, 'p, D, R> {
    /// For frames of a scene with this output; of rows wider than `sums`, only the
    /// beginning is shown.
    pub fn new(output: Output, sums: &'a mut [u32], packed: Packed<'p, D, R>) -> Self {
        Self {
            samples: Samples::new(output, sums),
            packed,
        }
    }

    /// The panel.
    pub fn rows(&mut self) -> &mut R {
        self.packed.rows()
    }
}

/// The mean of what a sum has, 8 bits a channel, each rounded to nearest.
const fn mean(sum: u32) -> [u8; 3] {
    const fn channel(sum: u32) -> u8 {
        (((sum & 0x3ff) + 2) >> 2) as u8
    }
    [channel(sum >> 20), channel(sum >> 10), channel(sum)]
}

impl<D: Dither, R: PackedRows> Display for ResolvePacked<'_, '_, D, R> {
    type Error = R::Error;

    fn begin(&mut self, palette: &Palette<'_>) -> Result<(), R::Error> {
        self.samples.set(palette);
        Ok(())
    }

    fn show(&mut self, rows: BandRows<'_>) -> Result<(), R::Error> {
        let Self { samples, packed } = self;
        let most = packed.packing().most();
        samples.rows(rows, |y, sums| {
            packed.row(y, sums.iter().map(|sum| tone(luma(mean(*sum)), most)))
        })
    }
}
