//! Fog by the exact distance.

use fixel_scene::{Fog, FogMode};
use glam::DVec3;

/// How much of what is seen at a distance along the line of sight is fog: 0..=1.
pub(crate) fn fog_part(fog: &Fog, w: f64) -> f64 {
    let clear = match fog.mode {
        FogMode::Linear { start, end } => (end - w) / (end - start),
        FogMode::Exponential { density } => (-density * w).exp(),
        FogMode::ExponentialSquared { density } => (-(density * w).powi(2)).exp(),
    };
    1.0 - clear.clamp(0.0, 1.0)
}

/// A colour behind so much fog.
pub(crate) fn fogged(fog: &Fog, colour: DVec3, part: f64) -> DVec3 {
    colour.lerp(DVec3::from(fog.colour), part)
}
