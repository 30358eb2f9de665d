//! What a scene needs of the program that draws it: Cargo features of this crate.

use super::{Field, Material, Record, Scene, SceneError, Shading, Transparency, layout};

/// A feature in each line, with what of a scene uses it, in the order of the bits of
/// [`Header::features`](super::Header::features): a macro, so that firmware links the names
/// without the uses.
macro_rules! features {
    ($($name:literal: $used:expr,)*) => {
        /// Their names, and whether this program has them.
        const FEATURES: [(&str, bool); layout::FEATURES] =
            [$(($name, cfg!(feature = $name))),*];

        /// Which of them a scene uses.
        fn used(scene: &Scene<'_>) -> [bool; layout::FEATURES] {
            let uses: [fn(&Scene<'_>) -> bool; layout::FEATURES] = [$($used),*];
            uses.map(|uses| uses(scene))
        }
    };
}

features! {
    "lod": |scene| scene.header.level_error != 0,
    "texture": |scene| !scene.textures.is_empty(),
    "lines": |scene| !scene.looks.is_empty(),
    "viewports": |scene| !(scene.viewports.is_empty() && scene.output.is_empty()),
    "animation": |scene| !scene.tracks.is_empty(),
    "fog": |scene| !scene.fog.is_empty(),
    "light": |scene| any_material(scene, |m| m.full || m.coloured),
    "gouraud": |scene| any_material(scene, |m| m.shading != Shading::Flat),
    "transparency": |scene| any_material(scene, |m| m.transparency != Transparency::Opaque),
}

fn any_material(scene: &Scene<'_>, is: fn(&Material) -> bool) -> bool {
    let mut materials = scene.materials.iter().map(Material::from_words);
    materials.any(|material| is(&material))
}

impl Scene<'_> {
    /// The features that the scene uses, as far as this program reads it: what only a feature
    /// reads is not looked for without it. See [`Header::features`](super::Header::features).
    pub fn features_used(&self) -> u16 {
        let bits = used(self).into_iter().rev();
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
