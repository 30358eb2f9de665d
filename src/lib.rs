//! Real-time 3D in fixed point for displays on microcontrollers: no FPU, no heap, RAM for
//! a few rows of the screen.
//!
//! # One frame
//!
//! ```text
//!              flash                                              RAM
//! ┌──────────────────────────┐        ┌────────────────────────────────────────────────┐
//! │ Scene: meshes, materials,│        │ Pose: camera, turns       Scratch: lists, slots│
//! │ lights, palette          │        │ Band: some rows of indices and depth           │
//! └────────────┬─────────────┘        └───────────┬────────────────────────────────────┘
//!              │                                  │
//!              ├──────────────┬───────────────────┘
//!              v              v
//!  an actor     matrix, lights in its space         view/      model -> world -> view -> clip
//!  a meshlet    frustum, cone, rows                 cull/      decided from bounds alone
//!  a vertex     transform, project, light           vertex/    place, depth, level
//!  a triangle   near, far, guard; setup             clip/, raster/
//!  a span       depth test, shade                   raster/, shade/, light/
//!  an edge      lines, points, marks                line/
//!  a pixel      fog, by its depth                   fog/
//!              │
//!              v
//!  Band: rows of palette indices and of depth       frame/
//!              │  palette: index -> colour          palette/
//!              v
//!  Display: an embedded-graphics DrawTarget,        display/
//!  or a bus of your own
//! ```
//!
//! [`Renderer`] owns the RAM of it; [`render::render_frame`] goes through it in memory of your
//! own, [`render::Bands`] a band at a time. Data flows
//! down only: a stage imports those before it, and `render` alone knows all. By rays instead
//! of triangles, with shadows, mirrors and glass: [`ray`].
//!
//! # In firmware
//!
//! The baker makes a scene of a description and its meshes (`fixel bake`, or `fixel_bake::scene`
//! in a build script), which is read in place:
//!
//! ```
//! use embedded_graphics_core::{draw_target::DrawTarget, geometry::Point, pixelcolor::Rgb565};
//! use fixel::{DrawTargetDisplay, Renderer, Scene, SceneError};
//!
//! /// Shows a scene, such as `fixel::include_scene!(OUT_DIR, "teapot.fxl")`, on any display.
//! /// The renderer is what drawing needs of RAM, whatever the mesh: into a `static`.
//! fn show<D: DrawTarget<Color = Rgb565>>(
//!     blob: &[u8],
//!     lcd: D,
//!     renderer: &mut Renderer<320, 16>, // columns, rows of a band
//! ) -> Result<(), SceneError> {
//!     let scene = Scene::embedded(blob)?; // whole, and nothing missing in this program
//!     let mut panel = DrawTargetDisplay::new(lcd, Point::zero());
//!     for frame in 0.. {
//!         let pose = scene.pose(frame); // camera, turns: change what you like
//!         if renderer.draw(&scene, &pose, &mut panel).is_err() {
//!             break; // the bus; drawing itself cannot fail
//!         }
//!     }
//!     Ok(())
//! }
//! ```
//!
//! The baker has checked every number of it. Blobs from elsewhere, such as an SD card, are for
//! [`Scene::parse`], which does so again. Bytes that are no scene are refused, with what is wrong
//! with them:
//!
//! ```
//! use fixel::{Aligned, Scene, SceneError};
//!
//! let text = Aligned([b'?'; 1024]);
//! assert_eq!(Scene::parse(&text.0).err(), Some(SceneError::NotAScene));
//! ```
//!
//! # Where to look
//!
//! | for | see |
//! |---|---|
//! | a turning object, a moving eye | [`Pose`], [`Placement`], [`Camera`] |
//! | lines, triangles and spheres made on the device | [`immediate`] |
//! | a panel, grey ones too; 2D over 3D; sending while drawing; what changed alone | [`display`] |
//! | where a point is on the screen, what a pixel shows | [`view::ViewFrame`], [`render::pick`] |
//! | colours that move without drawing | [`palette`], [`Pose::palette_shift`] |
//! | number formats | [`math`] |
//! | the pipeline's stages themselves, for tools | feature `stages`, which no promise holds for |
//!
//! What is not used is not linked: see the features in `Cargo.toml`. How each algorithm is done
//! in integers, with its source and its error bound, is told in the repository's `docs/how/`.

#![no_std]
#![cfg_attr(
    test,
    allow(
        clippy::disallowed_methods,
        clippy::unwrap_used,
        clippy::indexing_slicing,
        clippy::float_arithmetic,
        clippy::panic,
        reason = "tests panic, and take floats to compare with"
    )
)]

#[cfg(test)]
extern crate std;

pub mod display;
pub mod frame;
pub mod immediate;
mod include;
pub mod math;
pub mod palette;
#[cfg(feature = "ray")]
pub mod ray;
pub mod render;
pub mod scene;
pub mod view;

// Stages of the pipeline take what another one has prepared, not any number: they are public to
// tools that look inside alone.
#[cfg(not(feature = "stages"))]
mod clip;
#[cfg(feature = "stages")]
pub mod clip;
#[cfg(not(feature = "stages"))]
mod cull;
#[cfg(feature = "stages")]
pub mod cull;
#[cfg(not(feature = "stages"))]
mod fog;
#[cfg(feature = "stages")]
pub mod fog;
#[cfg(not(feature = "stages"))]
mod light;
#[cfg(feature = "stages")]
pub mod light;
#[cfg(not(feature = "stages"))]
mod line;
#[cfg(feature = "stages")]
pub mod line;
#[cfg(not(feature = "stages"))]
mod raster;
#[cfg(feature = "stages")]
pub mod raster;
#[cfg(not(feature = "stages"))]
mod shade;
#[cfg(feature = "stages")]
pub mod shade;
#[cfg(not(feature = "stages"))]
mod vertex;
#[cfg(feature = "stages")]
pub mod vertex;

pub use display::{Display, DrawTargetDisplay};
pub use frame::Band;
pub use include::Aligned;
pub use render::{FrameStats, Renderer, Scratch, render_frame};
pub use scene::{Camera, Place, Placement, Pose, Scene, SceneError};
