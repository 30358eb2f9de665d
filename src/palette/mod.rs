//! From palette indices to a panel's colours. In: indices of finished rows and
//! the palette. Out: bytes that a panel takes. Used by `display`.

mod rgb565;

pub use rgb565::{Rgb565Table, rgb565, rgb565_of_sum};

/// Red, green and blue of up to 256 entries, 8 bits each.
#[derive(Clone, Copy, Debug)]
pub struct Palette<'a> {
    /// The entries; an index past the end is black.
    pub colours: &'a [[u8; 3]],
}

impl Palette<'_> {
    /// The colour of an index.
    pub fn rgb888(&self, index: u8) -> [u8; 3] {
        self.colours
            .get(usize::from(index))
            .copied()
            .unwrap_or_default()
    }
}

#[cfg(test)]
mod tests;
