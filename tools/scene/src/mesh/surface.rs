//! What a mesh file says of its surface.

use crate::description::{Cull, Material, Rgb};
use crate::texture::{Texture, Texturing};

/// A colour, perhaps a texture and highlights.
#[derive(Clone, Debug)]
pub(crate) struct Surface {
    /// Display-encoded.
    pub colour: Rgb,
    /// Colour of highlights, display-encoded; black for none.
    pub specular: Rgb,
    /// How sharp they are, 1..=128.
    pub specular_power: f64,
    /// Light of its own, 0..=1 of its colour.
    pub emission: f64,
    /// How much of what is behind it it hides, 0..=1.
    pub opacity: f64,
    /// A texture, and how it lies on the surface; the index says nothing.
    pub texture: Option<(Texture, Texturing)>,
    /// Whether it is seen from behind too.
    pub both_sides: bool,
}

impl Default for Surface {
    fn default() -> Self {
        Self {
            colour: [1.0; 3],
            specular: [0.0; 3],
            specular_power: 1.0,
            emission: 0.0,
            opacity: 1.0,
            texture: None,
            both_sides: false,
        }
    }
}

impl Surface {
    /// As a material without a name that is the default in all else. Adds the texture
    /// to the scene's, if they do not have it.
    pub(crate) fn material(&self, textures: &mut Vec<Texture>) -> Material {
        let texture = self.texture.as_ref().map(|(texture, how)| {
            let known = textures.iter().position(|other| other == texture);
            Texturing {
                texture: known.unwrap_or_else(|| {
                    textures.push(texture.clone());
                    textures.len() - 1
                }),
                ..*how
            }
        });
        let shiny = self.specular != [0.0; 3];
        Material {
            ambient_colour: self.colour,
            diffuse_colour: self.colour,
            specular_colour: if shiny { self.specular } else { self.colour },
            specular: f64::from(u8::from(shiny)),
            specular_power: self.specular_power,
            emission: self.emission,
            opacity: self.opacity,
            cull: if self.both_sides {
                Cull::None
            } else {
                Cull::Back
            },
            texture,
            ..Material::default()
        }
    }
}
