//! One frame: the one place that knows all stages. In: a
//! [`Scene`](crate::scene::Scene), a [`Pose`](crate::scene::Pose), a
//! [`Scratch`] and a [`Band`](crate::frame::Band). Out: rows to a
//! [`Display`](crate::display::Display), and [`FrameStats`].
#![expect(
    clippy::arithmetic_side_effects,
    reason = "places in lists of bounded length, counts of what a frame draws; tests stop at overflow"
)]

mod actors;
mod bands;
mod corner_source;
mod direct;
mod draw;
mod entry;
mod facing;
mod frame;
mod lines;
mod meshlet_cache;
mod paint;
mod pick;
mod renderer;
mod scratch;
mod short_list;
mod stats;
mod surface;
mod surface_pixels;
mod surface_runs;
mod triangles;
mod viewports;
mod visible_list;

pub use bands::Bands;
pub use direct::Direct;
pub use frame::{palette, render_frame, render_frame_with, render_rows_with};
pub use paint::{Ids, Paint, PaintActor, PaintLight, PaintTexel, PaintTriangle, Shaded};
pub use pick::{Picked, pick};
pub use renderer::Renderer;
pub use scratch::{Scratch, Workspace};
pub use stats::FrameStats;
