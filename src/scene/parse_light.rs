//! Checks of lights and materials.

use super::parse::{count, range};
use super::{
    Cull, Field, Light, LightKind, Material, Record, Scene, SceneError, Section, Shading, layout,
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
            range(s, i, Field::Kind, kind, 0, LightKind::ALL.len() as i64 - 1)?;
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

    pub(super) fn check_materials(&self) -> Result<(), SceneError> {
        let s = Section::Materials;
        for (i, words) in self.materials.iter().enumerate() {
            let material = Material::from_words(words);
            if !cfg!(feature = "light") && (material.full || material.coloured) {
                return Err(SceneError::Feature { name: "light" });
            }
            let [shading, cull, ..] = words.first().map_or([0; 4], |w| w.to_ne_bytes());
            let most = |all: usize| all as i64 - 1;
            range(
                s,
                i,
                Field::Shading,
                shading.into(),
                0,
                most(Shading::ALL.len()),
            )?;
            range(s, i, Field::Cull, cull.into(), 0, most(Cull::ALL.len()))?;
            if !material.coloured {
                let shades = self.shades.len();
                range(s, i, Field::Shade, material.shade.into(), 0, most(shades))?;
            }
            let channels = material.channels;
            let levels = [channels.constant, channels.diffuse, channels.specular];
            for level in levels.as_flattened().iter().chain([&material.ambient]) {
                range(s, i, Field::Intensity, i64::from(*level), 0, 255 * 64)?;
            }
            range(s, i, Field::Intensity, material.diffuse.into(), 0, 1 << 16)?;
            range(s, i, Field::Power, material.power.into(), 1 << 8, 128 << 8)?;
            if material.coloured {
                let (full, colours) = (material.full.into(), self.colours.len() as i64);
                range(s, i, Field::Coloured, full, 1, 1)?;
                range(s, i, Field::Coloured, colours, 1, 1)?;
            }
        }
        Ok(())
    }
}
