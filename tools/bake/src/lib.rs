//! The baker: a scene description becomes a `.fxl` blob for flash.
//!
//! In: [`fixel_scene::Scene`]. Out: [`Baked`]: the blob, and the way back from
//! its triangles to the description's. Used by the commands, by build scripts
//! and by tests.

mod blob;
mod coordinates;
mod error;
mod fog;
mod grid;
mod group;
mod instance;
mod light;
mod light_error;
mod look;
mod mesh;
mod meshlet;
mod normal;
mod oklab;
mod palette;
mod panel;
mod picture;
mod placement;
mod ray;
mod records;
mod simplify;
mod snap;
mod texture;
mod texturing;
mod track;
mod transparency;
mod unbake;
mod units;
mod viewport;

pub use blob::{Baked, bake, bake_for_rays};
pub use error::{BakeError, Problem};
pub use mesh::{Source, Sources};
pub use records::camera_in;
pub use simplify::{Reduced, reduce};
pub use unbake::unbake;
