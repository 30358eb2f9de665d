//! The f64 truth that fixel's pictures are held against.
//!
//! [`render()`] finds, for the centre of each pixel, the nearest surface by
//! casting a ray at the original, unsnapped triangles, all in double
//! precision. [`compare()`] measures a [`Frame`] from the renderer under test
//! against that [`Truth`]. Nothing here shares arithmetic with the fixed-point
//! core: not the matrices, not the fill rule, not the light.
//!
//! In: a [`fixel_scene::Scene`] and a [`Frame`] of plain arrays. Out: a
//! [`Truth`], a [`Report`] and [`heatmap`]s. Used by the command line and by
//! the accuracy tests.

mod bases;
mod bitmap;
mod bvh;
mod camera;
mod compare;
mod fog;
mod frame;
mod geometry;
pub mod heatmap;
mod hit;
mod letters;
mod light;
mod metric;
mod model;
mod oklab;
mod overlay;
mod path;
mod ray;
mod render;
mod report;
mod shadow;
mod texture;
mod through;
mod trace;
mod track;
mod truth;
mod view;
mod window;

pub use camera::camera_at;
pub use compare::compare;
pub use frame::{COLOURS, Frame, FrameError, Lookup, NO_TRIANGLE};
pub use hit::{Hit, Layer};
pub use metric::psnr_db;
pub use model::actor_matrix;
pub use path::Path;
pub use render::{Options, render, render_watched};
pub use report::{Mismatch, MismatchKind, PSNR_IDENTICAL_DB, Report};
pub use trace::{RayCounts, render_rays, render_rays_watched};
pub use truth::Truth;
pub use view::View;
