//! Fog as the blob holds it.

use super::layout::FOG_ROWS;
use super::range::{count, last, range};
use super::records::{i, w};
use super::{Field, Record, Scene, SceneError, Section};

/// How fog thickens with distance: for who wants to know; the distances say it all.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FogMode {
    /// Along a straight line.
    Linear,
    /// As `1 - e^-(density * distance)`.
    Exponential,
    /// As `1 - e^-(density * distance)^2`.
    ExponentialSquared,
}

/// Fog.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Fog {
    /// Its colour.
    pub colour: [u8; 3],
    /// How it thickens.
    pub mode: FogMode,
    /// Distance along the line of sight at which each row of the fog table but the
    /// first begins, raw [`World`](crate::math::World) bits, not falling.
    pub distances: [i32; FOG_ROWS - 1],
}

impl Record for Fog {
    type Words = [u32; FOG_ROWS];

    fn from_words(words: &Self::Words) -> Self {
        let [first, distances @ ..] = *words;
        let [r, g, b, mode] = first.to_ne_bytes();
        Self {
            colour: [r, g, b],
            mode: match mode {
                0 => FogMode::Linear,
                1 => FogMode::Exponential,
                _ => FogMode::ExponentialSquared,
            },
            distances: distances.map(i),
        }
    }

    fn to_words(&self) -> Self::Words {
        let [r, g, b] = self.colour;
        let mode = match self.mode {
            FogMode::Linear => 0,
            FogMode::Exponential => 1,
            FogMode::ExponentialSquared => 2,
        };
        let mut words = [u32::from_ne_bytes([r, g, b, mode]); FOG_ROWS];
        for (word, distance) in words.iter_mut().skip(1).zip(self.distances) {
            *word = w(distance);
        }
        words
    }
}

impl<'a> Scene<'a> {
    /// The fog, if there is any.
    pub fn fog(&self) -> Option<Fog> {
        self.fog.first().map(Fog::from_words)
    }

    /// What each palette index becomes, from no fog to nothing but fog; there if
    /// [`Scene::fog`] is and there is a palette ([`Scene::is_direct`]).
    pub fn fog_table(&self) -> Option<&'a [[u8; 256]; FOG_ROWS]> {
        self.fog_table.first_chunk()
    }
}

impl Scene<'_> {
    /// Whether all is in range.
    pub(super) fn check_fog(&self) -> Result<(), SceneError> {
        let fogs = self.fog.len();
        count(Section::Fog, fogs, 0, 1)?;
        let rows = if self.is_direct() {
            0
        } else {
            fogs.saturating_mul(FOG_ROWS)
        };
        count(Section::FogTable, self.fog_table.len(), rows, rows)?;
        let Some(fog) = self.fog() else {
            return Ok(());
        };
        let mut before = 0;
        for distance in fog.distances.map(i64::from) {
            let most = i32::MAX.into();
            range(Section::Fog, 0, Field::Distance, distance, before, most)?;
            before = distance;
        }
        let colours = last(self.palette.len(), 1);
        for (i, index) in self.fog_table.as_flattened().iter().enumerate() {
            let index = i64::from(*index);
            range(
                Section::FogTable,
                i / 256,
                Field::PaletteIndex,
                index,
                0,
                colours,
            )?;
        }
        Ok(())
    }
}
