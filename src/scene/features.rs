//! What a scene needs of the program that draws it: Cargo features of this crate.

// Bytes from anywhere come in: whatever they say, nothing overflows.
#![deny(clippy::arithmetic_side_effects)]

use super::{Field, Material, Record, Scene, SceneError, Shading, Transparency, layout};

/// Their names, in the order of the bits of [`Header::features`](super::Header::features), and
/// whether this program has them.
const FEATURES: [(&str, bool); layout::FEATURES] = [
    ("lod", cfg!(feature = "lod")),
    ("texture", cfg!(feature = "texture")),
    ("lines", cfg!(feature = "lines")),
    ("viewports", cfg!(feature = "viewports")),
    ("animation", cfg!(feature = "animation")),
    ("fog", cfg!(feature = "fog")),
    ("light", cfg!(feature = "light")),
    ("gouraud", cfg!(feature = "gouraud")),
    ("transparency", cfg!(feature = "transparency")),
];

impl Scene<'_> {
    /// The features that the scene uses, as far as this program reads it: what only a feature
    /// reads is not looked for without it. See [`Header::features`](super::Header::features).
    pub fn features_used(&self) -> u16 {
        let any = |used: fn(&Material) -> bool| {
            let mut materials = self.materials.iter().map(Material::from_words);
            materials.any(|material| used(&material))
        };
        let used: [bool; layout::FEATURES] = [
            self.header.level_error != 0,
            !self.textures.is_empty(),
            !self.looks.is_empty(),
            !(self.viewports.is_empty() && self.output.is_empty()),
            !self.tracks.is_empty(),
            !self.fog.is_empty(),
            any(|m| m.full || m.coloured),
            any(|m| m.shading != Shading::Flat),
            any(|m| m.transparency != Transparency::Opaque),
        ];
        let bits = used.into_iter().rev();
        bits.fold(0, |bits, used| bits << 1 | u16::from(used))
    }

    /// Whether the program was built with what the scene says that it needs.
    pub(super) fn check_program(&self) -> Result<(), SceneError> {
        match lacking(self.header.features, &FEATURES) {
            Some(name) => Err(SceneError::Feature { name }),
            None => Ok(()),
        }
    }

    /// Whether it says all that it needs.
    pub(super) fn check_features(&self) -> Result<(), SceneError> {
        let stated = self.header.features;
        let unsaid = self.features_used() & !stated;
        if unsaid == 0 && stated >> layout::FEATURES == 0 {
            return Ok(());
        }
        Err(SceneError::Header {
            field: Field::Features,
            value: stated.into(),
        })
    }
}

/// The first feature that is asked for and is not there.
fn lacking(stated: u16, features: &[(&'static str, bool)]) -> Option<&'static str> {
    let mut all = features.iter().enumerate();
    let (_, (name, _)) = all.find(|(bit, (_, there))| stated >> bit & 1 != 0 && !there)?;
    Some(name)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_asked_for_and_not_there_is_named() {
        let features = [("a", true), ("b", false), ("c", false)];
        assert_eq!(lacking(0b001, &features), None);
        assert_eq!(lacking(0b101, &features), Some("c"));
        assert_eq!(lacking(0b111, &features), Some("b"));
    }
}
