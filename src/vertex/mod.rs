//! Vertices from the grid to the screen. In: a meshlet's vertices and an
//! [`ActorView`](crate::view::ActorView). Out: [`ScreenVertex`] for each, lit.
//! Used by `clip` (which asks again for clip coordinates), `line`, `raster`, `render` and
//! `immediate`.
#![expect(
    clippy::arithmetic_side_effects,
    reason = "coordinates of 16 and 24 bits by rows of the view, in 64; tests stop at overflow"
)]

mod clip_coordinates;
mod meshlet;
mod projection;
mod screen_vertex;
mod used;

pub use clip_coordinates::ClipVertex;
pub use meshlet::{
    COLOUR_ROOM, Room, TransformedMeshlet, surface_point, transform_meshlet, vertex,
};
use projection::Perspective;
pub(crate) use projection::{guard, outcode};
pub use projection::{outside, project};
use screen_vertex::Heights;
pub use screen_vertex::{Rest, ScreenVertex};
pub use used::Used;
