//! The way from an actor's grid to clip space. In: a [`Pose`](crate::scene::Pose)
//! and the screen's size. Out: [`ViewFrame`] once a frame and `ActorView` once
//! an actor, with everything that later stages need of camera and lights.
//! Used by all that draws in space: `cull` to `clip`, `light`, `fog`, `immediate`, `ray`.
#![expect(
    clippy::arithmetic_side_effects,
    reason = "a pose's numbers of 32 bits, in products of 64; what may be larger saturates; tests stop at overflow"
)]

mod actor_view;
mod depth_map;
mod level;
mod lights;
mod mapping;
mod meshlet_rows;
mod model_frame;
mod on_screen;
mod row;
mod view_frame;
mod world;

pub use mapping::{DisplayPoint, Ndc, Ray};
pub use view_frame::{Lens, ViewFrame};

#[cfg(not(feature = "stages"))]
pub(crate) use of_actors::*;
#[cfg(feature = "stages")]
pub use of_actors::*;

/// What actors are transformed and lit with: a stage, see the crate's features.
mod of_actors {
    pub use super::actor_view::{ActorView, EyeInGrid};
    pub use super::depth_map::{DepthMap, PerspectiveDepth};
    pub use super::lights::{ModelLights, round_level};
    pub use super::meshlet_rows::MeshletRows;
    pub use super::model_frame::ModelFrame;

    /// Fractional bits of [`ActorView`]'s rows beyond those of a clip coordinate: as
    /// many as leave a row's entry, times the power of two of a meshlet's vertices,
    /// within 31 bits (a vertex has 15 and a sign, a clip coordinate 28). With 14, a
    /// cube's edges were off by 10^-4 pixels.
    pub const ROW_FRACTION: u32 = 17;

    /// The same for a fine mesh, whose vertices have all 22 bits themselves.
    pub const FINE_ROW_FRACTION: u32 = 22;
}
