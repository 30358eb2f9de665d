//! The baker: a scene description becomes a `.fxl` blob for flash.
//!
//! In: [`fixel_scene::Scene`]. Out: [`Baked`]: the blob, and the way back from
//! its triangles to the description's. Used by the commands, by build scripts
//! and by tests.

mod blob;
mod error;
mod fog;
mod grid;
mod group;
mod instance;
mod light;
mod look;
mod mesh;
mod meshlet;
mod normal;
mod not_yet;
mod oklab;
mod palette;
mod placement;
mod records;
mod snap;
#[cfg_attr(
    not(test),
    expect(dead_code, reason = "the blob holds no textures yet")
)]
mod texture;
mod track;
mod unbake;
mod units;
mod viewport;

pub use blob::{Baked, bake};
pub use error::BakeError;
pub use mesh::{Source, Sources};
pub use unbake::unbake;
