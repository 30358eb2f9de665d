//! Geometry that is made on the device: lines, marks, triangles and spheres by call.
//! In: places in the world and the [`Target`](crate::frame::Target) of a band. Out: pixels
//! and depths in it, tested against what is there. Used by applications, beside `render`.
//!
//! What comes by call is drawn again in each band, over the scene's own surfaces and after
//! its fog and what it mixes: whatever order it comes in, what is nearer stays.
#![expect(
    clippy::arithmetic_side_effects,
    reason = "places of 32 bits, in products of 64; directions have length 1; tests stop at overflow"
)]

mod drawing;
mod lit;
mod sphere;

pub use drawing::{Immediate, Pen};
