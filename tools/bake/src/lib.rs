//! The baker: a scene description becomes a `.fxl` blob for flash.
//!
//! In: [`fixel_scene::Scene`]. Out: [`Baked`]: the blob, and the way back from
//! its triangles to the description's. Used by the commands, by build scripts
//! and by tests.
//!
//! In the build script of a firmware, a scene file becomes `scene.fxl` in `OUT_DIR`:
//!
//! ```no_run
//! fixel_bake::scene("scene.toml");
//! ```
//!
//! and the firmware has it by `fixel::include_scene!(OUT_DIR, "scene.fxl")`. [`SceneFile`]
//! has the options.

mod blob;
mod build_script;
mod coordinates;
mod error;
mod facing;
mod fog;
mod grid;
mod group;
mod input;
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
pub use build_script::{SceneFile, scene};
pub use error::{BakeError, Problem};
pub use input::{Input, Options};
pub use mesh::{Source, Sources};
pub use records::camera_in;
pub use simplify::{Reduced, reduce};
pub use unbake::unbake;
