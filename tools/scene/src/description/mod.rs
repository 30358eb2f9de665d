//! The scene as plain data: what the baker, the f64 reference and the
//! commands read. It holds no arithmetic: how a matrix is composed, how a
//! light level comes about, is for each reader to work out by itself, or the
//! reference would prove nothing.
//!
//! Units: lengths in scene units, angles in degrees, colours display-encoded
//! red, green, blue in 0..=1. Meanings of camera and actor fields are VTK's.

mod actor;
mod animation;
mod camera;
mod display;
mod fog;
mod light;
mod lod;
mod material;
mod palette;
mod ray;
mod source;

pub use actor::*;
pub use animation::*;
pub use camera::*;
pub use display::*;
pub use fog::*;
pub use light::*;
pub use lod::*;
pub use material::*;
pub use palette::*;
pub use ray::*;
pub use source::*;

use crate::texture::Texture;

/// A colour: display-encoded red, green and blue, each in 0..=1.
pub type Rgb = [f64; 3];

/// A whole scene with every default filled in.
#[derive(Clone, Debug, PartialEq)]
pub struct Scene {
    /// The screen that the scene is drawn for.
    pub display: Display,
    /// The eye.
    pub camera: Camera,
    /// Parts of the picture, later ones over earlier ones; none: the whole
    /// picture shows what `camera` sees.
    pub viewports: Vec<Viewport>,
    /// The ambient light `A`: the sum over all ambient lights of colour times
    /// intensity; white if the file names none.
    pub ambient: Rgb,
    /// Lights other than ambient. A file without any `[[light]]` gets one
    /// white headlight along the camera's line of sight.
    pub lights: Vec<Light>,
    /// Textures, each file once.
    pub textures: Vec<Texture>,
    /// Materials, in the file's order.
    pub materials: Vec<Material>,
    /// Meshes, each file once.
    pub meshes: Vec<Mesh>,
    /// Actors, in the file's order.
    pub actors: Vec<Actor>,
    /// What veils the distance.
    pub fog: Option<Fog>,
    /// What moves.
    pub animation: Animation,
    /// How the palette is made.
    pub palette: Palette,
    /// Level of detail; none: all triangles are drawn from any distance.
    pub lod: Option<Lod>,
    /// How rays are cast.
    pub ray: Ray,
    /// Where it comes from.
    pub source: Source,
}

impl Scene {
    /// What of the scene only rays show, if it says anything of them.
    pub fn asks_for_rays(&self) -> Option<&'static str> {
        let any = |of: fn(&Material) -> bool| self.materials.iter().any(of);
        if self.ray != Ray::default() {
            Some("[ray]")
        } else if any(|material| material.reflectivity > 0.0) {
            Some("reflectivity")
        } else if any(|material| material.refractive_index != 1.0) {
            Some("refractive_index")
        } else {
            None
        }
    }

    /// What an actor is a part of: its parent if it is a further part of that, else
    /// itself.
    pub fn whole(&self, actor: usize) -> usize {
        let found = &self.actors[actor];
        found.parent.filter(|_| found.part).unwrap_or(actor)
    }
}
