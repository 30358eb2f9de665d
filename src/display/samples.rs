//! Sums of a pixel's samples, and of two eyes' pictures.

use crate::frame::BandRows;
use crate::palette::Palette;
use crate::scene::{Output, Stereo};

/// The samples of a row of the picture, summed up as rows of samples come. Four bytes a
/// pixel, and 1 KB for the palette.
#[derive(Debug)]
pub(super) struct Samples<'a> {
    output: Output,
    /// Colours of the palette, 10 bits a channel; see
    /// [`rgb565_of_sum`](crate::palette::rgb565_of_sum).
    table: [u32; 256],
    sums: &'a mut [u32],
}

/// The bits of red in a sum.
const RED: u32 = 0x3ff << 20;

impl<'a> Samples<'a> {
    pub(super) fn new(output: Output, sums: &'a mut [u32]) -> Self {
        Self {
            output,
            table: [0; 256],
            sums,
        }
    }

    /// Takes over a palette.
    pub(super) fn set(&mut self, palette: &Palette<'_>) {
        let [across, down] = self.output.samples.map(|n| u32::from(n.max(1)));
        // Four of the largest fill 10 bits but for 3.
        let each = 4 / (across * down).clamp(1, 4);
        for (entry, colour) in self.table.iter_mut().zip(palette.entries()) {
            let [r, g, b] = colour.map(|c| u32::from(c) * each);
            *entry = r << 20 | g << 10 | b;
        }
    }

    /// Hands on each row of the picture that a band finishes: its number and sums.
    pub(super) fn rows<E>(
        &mut self,
        rows: BandRows<'_>,
        mut finished: impl FnMut(u16, &[u32]) -> Result<(), E>,
    ) -> Result<(), E> {
        let width = usize::from(rows.width);
        let (picture_width, _) = self.output.picture_size((rows.width, 1));
        let [_, down] = self.output.samples.map(|n| u16::from(n.max(1)));
        let mut y = rows.top;
        for indices in rows.indices.chunks_exact(width.max(1)) {
            if self.add(y, indices) {
                let shown = self.sums.len().min(picture_width.into());
                finished(y / down, self.sums.get(..shown).unwrap_or_default())?;
            }
            y = y.wrapping_add(1);
        }
        Ok(())
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
            let halves = indices.split_at_checked(indices.len() / 2);
            let (left, right) = halves.unwrap_or_default();
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
            *sum = sum.wrapping_add(colour(a).wrapping_add(colour(b)) & channels);
        }
    } else {
        for (sum, index) in sums.iter_mut().zip(indices) {
            *sum = sum.wrapping_add(colour(*index) & channels);
        }
    }
}
