//! The core on the desktop: whole frames with every plane that a comparison, a
//! picture or a viewer needs.
//!
//! In: a baked scene. Out: [`Planes`], and for scenes baked from a description
//! the [`fixel_reference::Frame`] that is held against the reference. Used by
//! the commands and by tests.

mod colour;
mod compare;
mod direct;
mod levels;
mod overdraw;
mod panel;
mod picture;
mod planes;
mod rays;

pub use colour::{colours, shown};
pub use compare::frame;
pub use direct::direct;
pub use levels::levels;
pub use overdraw::overdraw;
pub use panel::is_dithered;
pub use picture::picture;
pub use planes::{Options, Planes, actors, pick, render, render_turned, triangles};
pub use rays::{ray_frame, render_rays};
