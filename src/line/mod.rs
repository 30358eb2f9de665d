//! Lines and marks. In: [`ScreenVertex`](crate::vertex::ScreenVertex), and what
//! to draw there. Out: indices and depths in a [`Target`](crate::frame::Target).
//! Used by `render` and `immediate`.
//!
//! **Which pixels a line has.** The diamond rule of OpenGL and Direct3D, in exact
//! integers. Along the line's longer extent (x if both are the same) it has one
//! pixel for each column (row) whose centre line it crosses, from the end with the
//! lower coordinate up to, but not including, the other one; the pixel is the one
//! that holds the crossing, and one on a border goes right and down. At its ends, a
//! pixel whose diamond (less than half a pixel from its centre, by |x| + |y|) holds
//! the end belongs to the line, or not, as the caller says for each end. So the
//! pixels are the same whichever way the line is given and however the screen is
//! cut into bands; and a chain of lines, each of which leaves its last end to the
//! next, has no pixel missing and none twice (unless it bends so that it comes back
//! into a diamond that it has left).
//!
//! **Width.** A line of `w` pixels has `w` pixels in each column (row): those
//! whose first is the pixel of a line that lies `(w - 1) / 2` pixels further up
//! (left).
//!
//! **Depth** is linear on the screen along the line's longer extent and held within
//! that of the ends, plus a bias. Light, a level or a colour, is interpolated in space.
#![expect(
    clippy::arithmetic_side_effects,
    reason = "screen places of 25 bits, in products of 64; tests stop at overflow"
)]

mod mark;
mod pixel;
mod ramp;
mod segment;

pub use mark::{Mark, draw_mark};
pub use segment::{Line, draw_coloured_line, draw_line};

/// How lines and marks meet the depth buffer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct DepthRule {
    /// Whether what is nearer stays.
    pub test: bool,
    /// Added to the depth, in its units.
    pub bias: u16,
}
