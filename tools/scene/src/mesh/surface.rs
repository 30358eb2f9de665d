//! What a mesh file says of its surface.

use crate::description::{Cull, Material, Rgb};
use crate::texture::{Texture, Texturing};

/// A colour, perhaps a texture.
#[derive(Clone, Debug)]
pub(crate) struct Surface {
    /// Display-encoded.
    pub colour: Rgb,
    /// A texture, and how it lies on the surface; the index says nothing.
    pub texture: Option<(Texture, Texturing)>,
    /// Whether it is seen from behind too.
    pub both_sides: bool,
}

impl Default for Surface {
    fn default() -> Self {
        Self {
            colour: [1.0; 3],
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
        Material {
            ambient_colour: self.colour,
            diffuse_colour: self.colour,
            specular_colour: self.colour,
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
