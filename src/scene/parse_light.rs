//! Checks of lights and materials.

use super::range::{count, last, range};
use super::{
    Cull, Field, Light, LightKind, Material, Mesh, NO_TEXEL, Record, Scene, SceneError, Section,
    Shading, Texture, Transparency, layout,
};

impl Scene<'_> {
    pub(super) fn check_lights(&self) -> Result<(), SceneError> {
        let s = Section::Lights;
        count(s, self.lights.len(), 0, layout::LIGHTS)?;
        for (i, words) in self.lights.iter().enumerate() {
            let light = Light::from_words(words);
            let kind = words
                .first()
                .map_or(0, |w| i64::from(u32::from_le(*w) & 0xff));
            range(s, i, Field::Kind, kind, 0, last(LightKind::ALL.len(), 1))?;
            for c in light.colour {
                range(s, i, Field::Intensity, c.into(), 0, 32 << 16)?;
            }
            for c in light.towards {
                range(s, i, Field::Direction, c.into(), -(1 << 30), 1 << 30)?;
            }
            if light.kind != LightKind::Directional {
                let some = light.attenuation.iter().any(|c| c.mantissa() != 0);
                range(s, i, Field::Attenuation, some.into(), 1, 1)?;
            }
            range(s, i, Field::Cone, light.cone.into(), 0, 1 << 30)?;
            range(s, i, Field::Power, light.exponent.into(), 0, 128 << 8)?;
        }
        Ok(())
    }

    pub(super) fn check_textures(&self) -> Result<(), SceneError> {
        let s = Section::Textures;
        count(s, self.textures.len(), 0, 255)?;
        for (i, words) in self.textures.iter().enumerate() {
            let texture = Texture::from_words(words);
            for size in texture.size {
                range(
                    s,
                    i,
                    Field::Size,
                    size.into(),
                    0,
                    layout::TEXTURE_SIZE.into(),
                )?;
            }
            range(s, i, Field::Count, texture.copies.into(), 1, 11)?;
            let last = last(self.texels.len(), texture.texels().into());
            range(s, i, Field::Texel, texture.first.into(), 0, last)?;
        }
        let bases = self.bases.len();
        count(Section::Bases, bases, 0, layout::BASES)?;
        for (i, texel) in self.texels.iter().enumerate() {
            if *texel != NO_TEXEL {
                let last = last(bases, 1);
                range(Section::Texels, i, Field::Texel, (*texel).into(), 0, last)?;
            }
        }
        let last = last(self.palette.len(), 1);
        for (i, index) in self.texture_shades.as_flattened().iter().enumerate() {
            let index = (*index).into();
            range(
                Section::TextureShades,
                i,
                Field::PaletteIndex,
                index,
                0,
                last,
            )?;
        }
        for (i, words) in self.meshes.iter().enumerate() {
            if let Some(coordinates) = Mesh::from_words(words).coordinates {
                let exponent = coordinates.exponent.into();
                range(Section::Meshes, i, Field::Coordinates, exponent, 0, 24)?;
            }
        }
        Ok(())
    }

    pub(super) fn check_materials(&self) -> Result<(), SceneError> {
        let s = Section::Materials;
        for (i, words) in self.materials.iter().enumerate() {
            let material = Material::from_words(words);
            let [shading, cull, ..] = words.first().map_or([0; 4], |w| w.to_ne_bytes());
            let most = |all: usize| last(all, 1);
            range(
                s,
                i,
                Field::Shading,
                shading.into(),
                0,
                most(Shading::ALL.len()),
            )?;
            range(s, i, Field::Cull, cull.into(), 0, most(Cull::ALL.len()))?;
            if let Some(texture) = material.texture {
                let textures = self.textures.len();
                range(s, i, Field::Texture, texture.into(), 0, most(textures))?;
            }
            if !material.coloured {
                let shades = if material.texture.is_some() {
                    self.texture_shades.len()
                } else {
                    self.shades.len()
                };
                range(s, i, Field::Shade, material.shade.into(), 0, most(shades))?;
            }
            let channels = material.channels;
            let levels = [channels.constant, channels.diffuse, channels.specular];
            for level in levels.as_flattened().iter().chain([&material.ambient]) {
                range(s, i, Field::Intensity, i64::from(*level), 0, 255 * 64)?;
            }
            range(s, i, Field::Intensity, material.diffuse.into(), 0, 1 << 16)?;
            range(s, i, Field::Power, material.power.into(), 1 << 8, 128 << 8)?;
            self.check_transparency(i, &material)?;
            if material.coloured {
                let (full, colours) = (material.full.into(), self.colours.len() as i64);
                range(s, i, Field::Coloured, full, 1, 1)?;
                let needed = i64::from(!self.is_direct());
                range(s, i, Field::Coloured, colours, needed, 1)?;
            } else if self.is_direct() {
                range(s, i, Field::Coloured, 0, 1, 1)?;
            }
        }
        Ok(())
    }

    fn check_transparency(&self, i: usize, material: &Material) -> Result<(), SceneError> {
        let s = Section::Materials;
        match material.transparency {
            Transparency::Opaque => Ok(()),
            Transparency::ScreenDoor { first, pixels } => {
                range(s, i, Field::Opacity, first.into(), 0, 63)?;
                range(s, i, Field::Opacity, pixels.into(), 0, 64)?;
                range(s, i, Field::Opacity, material.full.into(), 1, 1)
            }
            Transparency::Blend { opacity } => {
                range(s, i, Field::Opacity, opacity.into(), 0, 256)?;
                range(s, i, Field::Coloured, material.coloured.into(), 1, 1)
            }
        }
    }
}
