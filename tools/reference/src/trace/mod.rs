//! Whitted's recursive ray tracing in double precision: the truth about the ray
//! caster's pictures.
//!
//! In: a scene. Out: a [`Truth`] with the colours that rays bring back, and how much of
//! each light gets to what each pixel shows. Spheres and rectangles are exact; all other
//! meshes are their triangles. Used by the comparison with the ray caster.
//!
//! Method: T. Whitted, "An Improved Illumination Model for Shaded Display", CACM 23(6),
//! 1980; [`fixel_scene::Material`] and `docs/scene-format.md` have the formulas.

mod bounce;
mod counts;
mod picture;
mod sequence;
mod shape;
mod tracer;
mod world;

pub use counts::RayCounts;
pub(crate) use picture::{Reach, Traced};
pub use picture::{render_rays, render_rays_watched};
