//! Partial refresh: only what changed since the last frame goes over the bus.

use core::num::{NonZeroU16, NonZeroU32, NonZeroUsize};

use super::PackedRows;

/// A panel of which parts can be written.
pub trait PartialRows {
    /// What can go wrong on the way.
    type Error;

    /// Bytes from number `first` on of the row, or page, that begins at row `y`. A byte
    /// is the smallest part there is: 8 columns of a row of 1 bit, one column of 8
    /// rows of a page, two columns of 4 bits.
    ///
    /// # Errors
    /// Those of the panel's bus.
    fn part(&mut self, y: u16, first: u16, bytes: &[u8]) -> Result<(), Self::Error>;
}

/// Sends the tiles of rows that are not as they were in the last frame, neighbours
/// together. Keeps a sum of each tile (FNV-1a, 4 bytes), not the frame: with tiles of 16
/// bytes, 256 bytes of RAM for 128x64 pixels of 1 bit. Where one byte of a tile changed,
/// the sum always does; otherwise a change is missed once in 2^32.
#[derive(Debug)]
pub struct Changed<'a, R> {
    rows: R,
    tile: NonZeroUsize,
    /// Rows of a call: 8 for pages.
    rows_a_call: NonZeroU16,
    /// Tiles of a call.
    across: usize,
    sums: &'a mut [Option<NonZeroU32>],
}

impl<'a, R: PartialRows> Changed<'a, R> {
    /// For rows of `row_bytes` bytes ([`Packing::bytes`](super::Packing::bytes)), in tiles
    /// of `tile` bytes, which is at least 1; `rows_a_call` is 8 for
    /// [`Packing::Pages`](super::Packing::Pages), otherwise 1. `sums` has one for each
    /// tile, by rows: [`Changed::sums`]. Tiles past its end are always sent.
    pub fn new(
        rows: R,
        row_bytes: usize,
        tile: usize,
        rows_a_call: u16,
        sums: &'a mut [Option<NonZeroU32>],
    ) -> Self {
        let tile = NonZeroUsize::new(tile).unwrap_or(NonZeroUsize::MIN);
        sums.fill(None);
        Self {
            rows,
            tile,
            rows_a_call: NonZeroU16::new(rows_a_call).unwrap_or(NonZeroU16::MIN),
            across: row_bytes.div_ceil(tile.get()),
            sums,
        }
    }

    /// How many sums a screen needs. As in [`Changed::new`], a tile and a call are at least 1.
    pub const fn sums(row_bytes: usize, tile: usize, rows_a_call: u16, height: u16) -> usize {
        let tile = if tile == 0 { 1 } else { tile };
        let rows_a_call = if rows_a_call == 0 { 1 } else { rows_a_call };
        let calls = height.div_ceil(rows_a_call) as usize;
        row_bytes.div_ceil(tile).saturating_mul(calls)
    }

    /// The next frame is sent whole: after the panel slept, say.
    pub fn forget(&mut self) {
        self.sums.fill(None);
    }

    /// The panel.
    pub fn panel(&mut self) -> &mut R {
        &mut self.rows
    }
}

/// FNV-1a, never 0.
fn sum(bytes: &[u8]) -> Option<NonZeroU32> {
    let hash = bytes.iter().fold(0x811c_9dc5, |hash: u32, byte| {
        (hash ^ u32::from(*byte)).wrapping_mul(0x0100_0193)
    });
    NonZeroU32::new(hash).or(NonZeroU32::new(1))
}

impl<R: PartialRows> PackedRows for Changed<'_, R> {
    type Error = R::Error;

    fn rows(&mut self, y: u16, bytes: &[u8]) -> Result<(), R::Error> {
        let row = usize::from(y / self.rows_a_call).saturating_mul(self.across);
        // Bytes from here on are to be sent; all before it are done.
        let mut start = None;
        let mut tiles = bytes.chunks(self.tile.get()).enumerate();
        loop {
            let next = tiles.next();
            let at = next.map_or(bytes.len(), |(number, _)| number * self.tile.get());
            let changed = next.is_some_and(|(number, tile)| {
                let sum = sum(tile);
                self.sums
                    .get_mut(row.saturating_add(number))
                    .is_none_or(|kept| {
                        let changed = *kept != sum;
                        *kept = sum;
                        changed
                    })
            });
            if changed {
                start = start.or(Some(at));
            } else if let Some(first) = start.take() {
                let part = bytes.get(first..at).unwrap_or_default();
                if let Err(error) = self.rows.part(y, first as u16, part) {
                    // What the panel has now is not known.
                    self.sums.fill(None);
                    return Err(error);
                }
            }
            if next.is_none() {
                return Ok(());
            }
        }
    }
}

#[cfg(test)]
mod tests;
