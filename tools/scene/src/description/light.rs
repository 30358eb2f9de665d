//! Lights.

use super::Rgb;

/// A light that has a direction or a place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Light {
    /// What kind.
    pub kind: LightKind,
    /// Its colour. Default white.
    pub colour: Rgb,
    /// Multiplies the colour; 0 or more, may exceed 1. Default 1.
    pub intensity: f64,
    /// Of a light that has a place, two edges, in world space: it then is a
    /// parallelogram about its position, and gives soft shadows. Only the ray
    /// caster shows them; anything else takes the position.
    pub edges: Option<[[f64; 3]; 2]>,
}

/// Kinds of light. At a surface point, `l` is the unit vector towards the
/// light and `d` the distance to it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum LightKind {
    /// From infinitely far: the same everywhere.
    Directional {
        /// The way the light travels, in world space; any length but 0.
        direction: [f64; 3],
    },
    /// From a place to all sides.
    Point {
        /// Where, in world space. A surface point just there gets no light.
        position: [f64; 3],
        /// Weaker with distance.
        attenuation: Attenuation,
    },
    /// From a place, within a cone with a sharp edge (VTK's, OpenGL's):
    /// multiplied by `max(0, -l . direction)^exponent` inside, 0 outside.
    Spot {
        /// Where, in world space. A surface point just there gets no light.
        position: [f64; 3],
        /// The cone's axis, the way the light travels, in world space; any
        /// length but 0.
        direction: [f64; 3],
        /// Weaker with distance.
        attenuation: Attenuation,
        /// From the axis to the cone's edge, in degrees, 1..=89; the edge
        /// itself is lit. Default 30.
        cone_angle: f64,
        /// How much the light is gathered around the axis, 0..=128; 0 is even
        /// light. Default 1.
        exponent: f64,
    },
}

/// `[c, l, q]`: light at distance `d`, in scene units, is multiplied by
/// `1 / (c + l*d + q*d^2)`. Each 0 or more, not all 0; default `[1, 0, 0]`,
/// no attenuation. With `c` below 1 the factor exceeds 1 near the light.
pub type Attenuation = [f64; 3];
