//! A band: some rows of the screen, full width.

use core::fmt;

use super::Stored;
use super::fill::fill;
use crate::math::{Depth, Rect};

/// Buffers for a band: a palette index (or what else is [`Stored`]) and a depth for each
/// pixel. A band as
/// high as the screen holds a whole frame; a lower one is used again and again,
/// from the top of the screen to its bottom.
#[derive(Debug)]
pub struct Band<'a, C = u8> {
    indices: &'a mut [C],
    depths: &'a mut [Depth],
    width: u16,
    rows: u16,
}

/// The buffers given do not hold one row.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct BandError {
    /// Pixels a row needs.
    pub width: u16,
    /// Pixels there are in the smaller buffer.
    pub pixels: usize,
}

impl fmt::Display for BandError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "a band needs at least one row of 1..=2048 pixels: width {}, buffers hold {}",
            self.width, self.pixels
        )
    }
}

impl core::error::Error for BandError {}

impl<'a, C: Stored> Band<'a, C> {
    /// A band of a screen `width` pixels wide, with as many rows as both
    /// buffers hold.
    ///
    /// # Errors
    /// If not even one row fits, or `width` is not in 1..=2048.
    pub fn new(
        width: u16,
        indices: &'a mut [C],
        depths: &'a mut [Depth],
    ) -> Result<Self, BandError> {
        let pixels = indices.len().min(depths.len());
        let rows = pixels
            .checked_div(usize::from(width))
            .unwrap_or(0)
            .min(2048) as u16;
        if rows == 0 || width > 2048 {
            return Err(BandError { width, pixels });
        }
        Ok(Self {
            indices,
            depths,
            width,
            rows,
        })
    }

    /// A band of as many columns and rows as both buffers have; that they are 1..=2048 is
    /// checked when the program is compiled.
    pub const fn of_rows<const WIDTH: usize, const ROWS: usize>(
        indices: &'a mut [[C; WIDTH]; ROWS],
        depths: &'a mut [[Depth; WIDTH]; ROWS],
    ) -> Self {
        const {
            assert!(WIDTH > 0 && WIDTH <= 2048, "a band has 1..=2048 columns");
            assert!(ROWS > 0 && ROWS <= 2048, "a band has 1..=2048 rows");
        }
        Self {
            indices: indices.as_flattened_mut(),
            depths: depths.as_flattened_mut(),
            width: WIDTH as u16,
            rows: ROWS as u16,
        }
    }

    /// Width in pixels, 1..=2048.
    pub fn width(&self) -> u16 {
        self.width
    }

    /// Rows that fit, 1..=2048.
    pub fn rows(&self) -> u16 {
        self.rows
    }

    /// The part that stands for screen rows `top..end`; at most as many as fit.
    pub fn target(&mut self, top: u16, end: u16) -> Target<'_, C> {
        let end = end.max(top).min(top.saturating_add(self.rows));
        let pixels = usize::from(end - top) * usize::from(self.width);
        Target {
            indices: self.indices.get_mut(..pixels).unwrap_or_default(),
            depths: self.depths.get_mut(..pixels).unwrap_or_default(),
            width: self.width,
            stride: self.width,
            top,
            end,
        }
    }
}

/// Screen rows being drawn: of a band, or of a viewport, which is drawn as if it
/// were a screen of its own.
#[derive(Debug)]
pub struct Target<'a, C = u8> {
    /// Palette indices, or what else is [`Stored`], row by row, each from the screen's left
    /// column on.
    pub indices: &'a mut [C],
    /// Depths, as the indices; 0 where nothing is.
    pub depths: &'a mut [Depth],
    /// Columns of the screen.
    pub width: u16,
    /// Pixels from a row to the next, at least the width.
    pub stride: u16,
    /// First screen row.
    pub top: u16,
    /// One past the last screen row.
    pub end: u16,
}

impl<'a, C: Stored> Target<'a, C> {
    /// The part of these rows within `rect`, as a screen of that size: pixel
    /// (0, 0) is the rectangle's top left one.
    #[inline(never)] // once a meshlet, in three places
    pub fn part(&mut self, rect: &Rect) -> Target<'_, C> {
        let right = rect.right.min(self.width);
        let left = rect.left.min(right);
        let end = self.end.min(rect.bottom);
        let top = self.top.max(rect.top).min(end);
        let stride = usize::from(self.stride);
        let start = usize::from(top.saturating_sub(self.top)) * stride + usize::from(left);
        let stop = usize::from(end.saturating_sub(self.top)) * stride;
        Target {
            indices: self.indices.get_mut(start..stop).unwrap_or_default(),
            depths: self.depths.get_mut(start..stop).unwrap_or_default(),
            width: right - left,
            stride: self.stride,
            top: top.saturating_sub(rect.top),
            end: end.saturating_sub(rect.top),
        }
    }

    /// Empties the rows: depth 0, and in row `y` what `background` gives for it.
    pub fn clear(&mut self, mut background: impl FnMut(u16) -> C) {
        let (width, stride) = (usize::from(self.width), usize::from(self.stride).max(1));
        let whole = width == stride;
        let mut backgrounds = (self.top..self.end).map(&mut background).peekable();
        let mut below = &mut *self.indices;
        while let Some(index) = backgrounds.next() {
            let mut pixels = width;
            // Rows that look alike at once, if nothing lies between them.
            while whole
                && backgrounds
                    .next_if(|next| next.word() == index.word())
                    .is_some()
            {
                pixels += stride;
            }
            let end = pixels.max(stride).min(below.len());
            let Some((rows, rest)) = below.split_at_mut_checked(end) else {
                break;
            };
            fill(
                rows.get_mut(..pixels).unwrap_or_default(),
                index,
                index.word(),
            );
            below = rest;
        }
        if whole {
            fill(self.depths, 0, 0);
            return;
        }
        for row in self.depths.chunks_mut(stride) {
            fill(row.get_mut(..width).unwrap_or_default(), 0, 0);
        }
    }

    /// The finished rows, for as long as the band is not drawn into again.
    pub fn into_finished(self) -> BandRows<'a, C> {
        BandRows {
            indices: self.indices,
            depths: self.depths,
            width: self.width,
            top: self.top,
        }
    }

    /// The finished rows.
    pub fn finished(&self) -> BandRows<'_, C> {
        BandRows {
            indices: self.indices,
            depths: self.depths,
            width: self.width,
            top: self.top,
        }
    }
}

/// Finished rows, for a display.
#[derive(Clone, Copy, Debug)]
pub struct BandRows<'a, C = u8> {
    /// Palette indices, or what else is [`Stored`], row by row.
    pub indices: &'a [C],
    /// Depths, row by row; 0 where nothing is.
    pub depths: &'a [Depth],
    /// Pixels in a row.
    pub width: u16,
    /// The first row's place on the screen.
    pub top: u16,
}

impl<C> BandRows<'_, C> {
    /// Number of rows.
    pub fn rows(&self) -> u16 {
        self.indices
            .len()
            .checked_div(usize::from(self.width))
            .unwrap_or(0) as u16
    }
}
