//! Fog.

use super::Rgb;

/// Fog: the farther away something is along the line of sight (not along the ray),
/// the more its colour is mixed with the fog's. Where nothing is seen, the background
/// stays as it is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fog {
    /// Its colour.
    pub colour: Rgb,
    /// How it thickens.
    pub mode: FogMode,
}

/// How fog thickens with the distance `w`: its part of a colour, held to 0..=1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum FogMode {
    /// `(w - start) / (end - start)`.
    Linear {
        /// Where it begins, in scene units.
        start: f64,
        /// Where nothing else is seen.
        end: f64,
    },
    /// `1 - e^-(density * w)`.
    Exponential {
        /// Above 0; a scene unit is the unit of distance.
        density: f64,
    },
    /// `1 - e^-(density * w)^2`.
    ExponentialSquared {
        /// Above 0.
        density: f64,
    },
}
