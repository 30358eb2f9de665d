//! Real-time 3D in fixed point for displays on microcontrollers.
//!
//! One frame, in order:
//!
//! ```text
//! Scene (flash, zero-copy)                 scene/    what there is
//!   -> per actor: matrix, lights           view/     model -> world -> view -> clip
//!   -> per meshlet: frustum, cone, rows    cull/     decides from bounds alone
//!   -> per vertex: transform, light        vertex/   screen position, depth, level
//!   -> per triangle: near clip, setup      clip/, raster/
//!   -> per span: depth test, shade         raster/
//!   -> per edge, per point: lines, marks   line/
//!   -> per pixel: fog                       fog/       by depth
//!   -> Band: rows of indices and depth     frame/
//!   -> geometry made on the device         immediate/ lines, triangles, spheres by call
//!   -> palette: index -> panel colour      palette/
//!   -> Display                             display/
//! ```
//!
//! [`render::render_frame`] is that list as code.

#![no_std]
#![cfg_attr(
    test,
    allow(
        clippy::unwrap_used,
        clippy::indexing_slicing,
        clippy::float_arithmetic,
        clippy::panic
    )
)]

#[cfg(test)]
extern crate std;

pub mod clip;
pub mod cull;
pub mod display;
pub mod fog;
pub mod frame;
pub mod immediate;
mod include;
pub mod light;
pub mod line;
pub mod math;
pub mod palette;
pub mod raster;
#[cfg(feature = "ray")]
pub mod ray;
pub mod render;
pub mod scene;
pub mod shade;
pub mod vertex;
pub mod view;

pub use display::{Display, DrawTargetDisplay};
pub use frame::Band;
pub use include::Aligned;
pub use render::{FrameStats, Scratch, render_frame};
pub use scene::{Camera, Place, Placement, Pose, Scene, SceneError};
