//! Which of the two ways to a pixel a material goes.

use fixel_scene::{Filter, Light, Material, Rgb, Scene};

use super::surface::brightest;
use crate::transparency::blended;

/// As much light is taken for full: 4 of 255 more.
const FULL: f64 = 1.0 + 4.0 / 255.0;

/// From light to a palette index.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Way {
    /// One light level, looked up in a shade table.
    Level,
    /// Red, green and blue, looked up in the table of colours.
    Colour,
}

impl Way {
    /// A material goes by level if all colours that it can have lie on one line,
    /// from what ambient light and emission give, which is the same everywhere, in
    /// the direction of its diffuse colour:
    /// - every light but ambient ones is grey, or gives nothing;
    /// - it has no highlights, or is grey with grey ones: a highlight on any other
    ///   colour goes on to white where a channel is full and the line ends;
    /// - no actor wears it on a mesh with vertex colours;
    /// - it gets no more light than a level can say, where a camera may see it, or
    ///   each channel of its diffuse colour is full or nothing: more than full light
    ///   goes on to brighten the channels that are not full, and the line bends.
    ///
    /// With a texture, of which each texel is a line of its own, it goes by level if
    /// moreover these lines start at black:
    /// - ambient light is grey, or the material takes none;
    /// - its ambient and diffuse colours are the same;
    /// - it has no highlights;
    /// - its texels are not blended.
    ///
    /// All others go by colour, and so do blended ones, whose mixtures lie on no line.
    pub(crate) fn of(scene: &Scene, material: usize) -> Self {
        let surface = &scene.materials[material];
        let tinted = |actor: &&fixel_scene::Actor| {
            actor.material == material && !scene.meshes[actor.mesh].colours.is_empty()
        };
        let lines_from_black = || {
            let [red, green, blue] = scene.ambient;
            let ambient = surface.ambient == 0.0
                || (red == green
                    && green == blue
                    && surface.ambient_colour == surface.diffuse_colour);
            ambient && surface.specular == 0.0
        };
        let on_a_line = !blended(surface)
            && scene.lights.iter().all(is_grey)
            && has_no_highlight_of_its_own(surface)
            && !scene.actors.iter().any(|actor| tinted(&actor))
            && surface
                .texture
                .is_none_or(|t| t.filter == Filter::Nearest && lines_from_black())
            && (surface
                .diffuse_colour
                .iter()
                .all(|c| *c == 0.0 || *c == 1.0)
                || brightest(scene, material) <= FULL);
        if on_a_line { Self::Level } else { Self::Colour }
    }
}

fn is_grey(light: &Light) -> bool {
    light.intensity == 0.0 || grey(light.colour)
}

fn grey([red, green, blue]: Rgb) -> bool {
    red == green && green == blue
}

fn has_no_highlight_of_its_own(material: &Material) -> bool {
    material.specular == 0.0
        || (grey(material.diffuse_colour) && material.specular_colour == material.diffuse_colour)
}
