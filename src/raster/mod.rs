//! Scan conversion. In: three [`ScreenVertex`](crate::vertex::ScreenVertex) and
//! what to fill them with. Out: indices and depths in a
//! [`Target`](crate::frame::Target). Used by `line`, `shade`, `render`, `immediate`.
//!
//! A pixel belongs to a triangle if its centre lies inside, or on a top or a
//! left edge. Edges are followed in exact integer quotients and remainders
//! (Bresenham's error term), so the rule holds to the last sub-pixel bit, and
//! two triangles of one edge share it without gap or overlap.
#![expect(
    clippy::arithmetic_side_effects,
    reason = "screen places of 25 bits and depths of 20, in products of 64; tests stop at overflow"
)]

mod attribute;
mod attributes;
mod corners;
mod cubic;
mod edge;
mod footprint;
mod gradient;
mod nearer;
mod perspective;
mod run;
mod scan;
mod shaded;
mod sliver;
mod small;
mod span;
mod surface;
mod surface_planes;
mod tiny;
mod triangle;

pub use corners::{Corner, SurfaceKind};
pub use cubic::{Cubic, FINE, Fours};
pub use footprint::Footprint;
pub use gradient::Gradient as Change;
pub use run::{LONGEST_RUN, MOST_ATTRIBUTES, Path, RUN_FRACTION, Run, Shade, Values};
pub use shaded::{ShadePixel, draw_shaded};
pub use span::Fill;
pub use surface::draw_surface;
pub use triangle::{Drawn, How, Sides, draw_depth, draw_triangle};
