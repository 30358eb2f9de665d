//! What of the renderer a scene needs.

use fixel::Scene;
use fixel::scene::{Shading, Transparency};
use serde::{Deserialize, Serialize};

/// What is linked, from little to much.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Parts {
    /// Flat shading in grey light from infinitely far.
    Flat,
    /// Gouraud shading as well.
    Gouraud,
    /// Everything but rays.
    Triangles,
}

impl Parts {
    /// What a scene needs to be drawn by triangles.
    pub fn of(scene: &Scene<'_>) -> Self {
        let materials = || (0..scene.material_count()).map(|number| scene.material(number));
        let more = materials().any(|material| {
            material.full
                || material.coloured
                || material.texture.is_some()
                || material.transparency != Transparency::Opaque
        });
        let moves = scene.header().frames > 0;
        if moves || more || scene.fog().is_some() || scene.look_count() > 0 {
            Self::Triangles
        } else if materials().any(|material| material.shading != Shading::Flat) {
            Self::Gouraud
        } else {
            Self::Flat
        }
    }

    /// In a few words.
    pub fn what(self) -> &'static str {
        match self {
            Self::Flat => "flat shading alone",
            Self::Gouraud => "flat and Gouraud shading",
            Self::Triangles => "everything but rays",
        }
    }
}
