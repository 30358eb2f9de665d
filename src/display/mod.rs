//! Where finished rows go. In: [`BandRows`] and the palette. Out: a panel's
//! pixels. Used by `render` and `ray`, implemented by applications.
#![expect(
    clippy::arithmetic_side_effects,
    reason = "columns, rows and tones of 16 bits, in wider integers; tests stop at overflow"
)]

mod changed;
mod dither;
mod double_buffered;
mod draw_target;
mod draw_target_rows;
mod faulty;
mod overlay;
mod packed;
mod resolve;
mod resolve_packed;
mod samples;

use crate::frame::BandRows;
use crate::palette::Palette;

pub use changed::{Changed, PartialRows};
pub use dither::{Diffused, Dither, Nearest, Ordered};
pub use double_buffered::{Background, BufferedError, DoubleBuffered};
pub use draw_target::DrawTargetDisplay;
pub use draw_target_rows::DrawTargetRows;
pub use faulty::{Fault, Faulty};
pub use overlay::{Ink, Overlay, PaletteIndex};
pub use packed::{Packed, PackedRows, Packing};
pub use resolve::{Resolve, Rgb565Rows};
pub use resolve_packed::ResolvePacked;

/// A panel, or anything that takes rows from the top of the screen to its
/// bottom.
pub trait Display {
    /// What can go wrong on the way.
    type Error;

    /// A frame begins.
    ///
    /// # Errors
    /// Those of the panel's bus.
    fn begin(&mut self, palette: &Palette<'_>) -> Result<(), Self::Error>;

    /// Rows are finished. Each row of the screen comes once a frame.
    ///
    /// # Errors
    /// Those of the panel's bus. The frame is given up; the next one may be
    /// drawn.
    fn show(&mut self, rows: BandRows<'_>) -> Result<(), Self::Error>;
}
