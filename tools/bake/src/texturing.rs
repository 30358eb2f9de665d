//! Textures in the blob's records.

use fixel::scene::layout::{BASES, TEXTURE_SHADES};
use fixel::scene::{self as core_scene, NO_TEXEL};
use fixel_scene::{Filter, Wrap};

use crate::BakeError;
use crate::palette::TEXTURE_LEVELS;
use crate::texture::{NOTHING, Texture};

const _: () = assert!(NOTHING == NO_TEXEL && TEXTURE_LEVELS * BASES == TEXTURE_SHADES);

/// Records of textures, and the texels of all.
#[derive(Debug, Default)]
pub(crate) struct Texturing {
    pub textures: Vec<core_scene::Texture>,
    pub texels: Vec<Vec<u8>>,
}

impl Texturing {
    pub(crate) fn new(textures: &[Texture]) -> Result<Self, BakeError> {
        crate::error::at_most("textures", textures.len(), 255)?;
        let mut all = Self::default();
        let mut first = 0;
        for texture in textures {
            all.textures.push(core_scene::Texture {
                size: [texture.width, texture.height].map(|side| side.ilog2() as u8),
                copies: texture.copies.len() as u8,
                first,
                wrap: match texture.wrap {
                    Wrap::Clamp => core_scene::Wrap::Clamp,
                    Wrap::Repeat => core_scene::Wrap::Repeat,
                    Wrap::Mirror => core_scene::Wrap::Mirror,
                },
                bilinear: texture.filter == Filter::Bilinear,
                perspective: texture.perspective,
                cut_out: texture.copies.concat().contains(&NO_TEXEL),
            });
            let texels = texture.copies.concat();
            first += texels.len() as u32;
            all.texels.push(texels);
        }
        Ok(all)
    }
}

/// A table of texture shades with rows as long as the core has them.
pub(crate) fn padded(shades: &[u8], bases: usize) -> Vec<u8> {
    let row = |row: &[u8]| {
        let mut row = row.to_vec();
        row.resize(BASES, 0);
        row
    };
    shades.chunks(bases.max(1)).flat_map(row).collect()
}
