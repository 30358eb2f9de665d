//! Lights in the world, for rays: what each gives at a place, so that the caller may
//! ask in between whether anything is in its way.

use super::model::{Source, Sums, shorten};
use super::{Parts, ShortUnit};
use crate::math::Scaled;
use crate::scene::layout::LIGHTS;
use crate::scene::{Material, Scene};

/// Places are in units of 4 raw world bits, so that differences fit.
const SHIFT: u32 = 2;

/// The scene's lights.
#[derive(Clone, Copy, Debug)]
pub struct WorldLights {
    sources: [Source; LIGHTS],
    count: usize,
}

impl WorldLights {
    /// None.
    pub const NONE: Self = Self {
        sources: [Source::NONE; LIGHTS],
        count: 0,
    };

    /// Becomes those of a scene.
    pub fn set(&mut self, scene: &Scene<'_>) {
        let found = scene.lights();
        self.count = found.len().min(LIGHTS);
        // World units a unit: 2^-14.
        let unit = Scaled::new(1, SHIFT as i32 - 16);
        for (source, light) in self.sources.iter_mut().zip(found) {
            let place = light.position.map(|c| c >> SHIFT);
            *source = Source::at(&light, shorten(light.towards), place, unit);
        }
    }

    /// All of them.
    pub fn all(&self) -> impl ExactSizeIterator<Item = WorldLight<'_>> {
        let sources = self.sources.get(..self.count).unwrap_or_default();
        sources.iter().map(|source| WorldLight { source })
    }

    /// One of them.
    #[cfg(feature = "ray")]
    #[inline(always)]
    pub fn get(&self, number: usize) -> Option<WorldLight<'_>> {
        let source = self.sources.get(number)?;
        (number < self.count).then_some(WorldLight { source })
    }
}

/// One of them.
#[derive(Clone, Copy, Debug)]
pub struct WorldLight<'a> {
    source: &'a Source,
}

impl WorldLight<'_> {
    /// Whether it shines from infinitely far.
    #[cfg(feature = "ray")]
    pub fn is_directional(&self) -> bool {
        self.source.kind == crate::scene::LightKind::Directional
    }

    /// The direction to the light, which is at `from`, at a place (both raw world bits),
    /// and the factor of its light there, 14 fractional bits; `None` where none gets to.
    #[inline(never)]
    pub fn reaches(&self, from: [i32; 3], place: [i32; 3]) -> Option<(ShortUnit, u32)> {
        let [from, place] = [from, place].map(|p| p.map(|c| c >> SHIFT));
        self.source.reaches_from(from, place)
    }
}

/// What several of them give at a place.
#[derive(Clone, Copy, Debug, Default)]
pub struct WorldSums(Sums);

impl WorldSums {
    /// Adds what a light gives that reaches a surface of this material; `eye` is the
    /// direction against the ray.
    #[inline(never)]
    pub fn add(
        &mut self,
        light: &WorldLight<'_>,
        material: &Material,
        normal: ShortUnit,
        reach: (ShortUnit, u32),
        eye: ShortUnit,
    ) {
        let shiny = material.channels.specular != [0; 3];
        self.0.add(
            light.source,
            normal,
            reach,
            shiny.then_some(eye),
            material.power,
        );
    }

    /// What the material gives back.
    #[inline(never)]
    pub fn parts(&self, material: &Material, tint: Option<[u8; 3]>) -> Parts {
        let shiny = material.channels.specular != [0; 3];
        self.0.parts(&material.channels, shiny, tint)
    }
}
