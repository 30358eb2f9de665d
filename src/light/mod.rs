//! The whole light model at one point of a surface: coloured lights, places,
//! cones, highlights. In: the scene's lights and an actor's
//! [`ActorView`](crate::view::ActorView). Out: [`Channels`](crate::scene::Channels)
//! summed to a light level or a colour. Used by `vertex` (at vertices), `render`
//! (at faces), `shade` (at pixels), `immediate` and `ray` (in the world). Grey lights without a place go by
//! [`ModelLights`](crate::view::ModelLights), which is faster.
#![expect(
    clippy::arithmetic_side_effects,
    reason = "directions of length 1, levels and distances that are held in range; tests stop at overflow"
)]

mod model;
mod normal;
mod patch;
mod world;

pub use model::{Lit, Parts, SurfaceLights, sum};
pub use normal::{face_normal, vertex_normal};
pub use patch::Patch;
pub use world::{WorldLights, WorldSums};

/// A normal or a direction in an actor's grid; 14 fractional bits.
pub use crate::math::ShortUnit;
