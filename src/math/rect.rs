//! A rectangle of pixels.

/// Pixels of a frame, half-open, from its top left corner; y points down.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Rect {
    /// First column.
    pub left: u16,
    /// First row.
    pub top: u16,
    /// One past the last column.
    pub right: u16,
    /// One past the last row.
    pub bottom: u16,
}

impl Rect {
    /// A whole frame.
    pub const fn of_size(width: u16, height: u16) -> Self {
        Self {
            left: 0,
            top: 0,
            right: width,
            bottom: height,
        }
    }

    /// Columns.
    pub const fn width(&self) -> u16 {
        self.right.saturating_sub(self.left)
    }

    /// Rows.
    pub const fn height(&self) -> u16 {
        self.bottom.saturating_sub(self.top)
    }
}
