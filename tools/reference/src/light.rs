//! The light model, on display-encoded values as VTK and OpenGL compute it.

use fixel_scene::{LightKind, Material, Rgb, Scene};
use glam::DVec3;

/// Light at one point of a surface.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Lit {
    /// Red, green, blue, each clamped to 0..=1.
    pub colour: DVec3,
    /// The same for a white material under lights made grey, 0..=255.
    pub level: f64,
}

impl Lit {
    /// The mean of three corners with the given weights.
    pub fn weighted(corners: [Self; 3], weights: [f64; 3]) -> Self {
        let mut sum = Self::default();
        for (corner, weight) in corners.into_iter().zip(weights) {
            sum.colour += corner.colour * weight;
            sum.level += corner.level * weight;
        }
        // The weights' sum is 1 but for rounding.
        Self {
            colour: sum.colour.min(DVec3::ONE),
            level: sum.level.min(255.0),
        }
    }
}

/// A scene's lights, directions turned to point at the light.
#[derive(Clone, Debug)]
pub(crate) struct Lights {
    ambient: DVec3,
    directional: Vec<(DVec3, DVec3)>,
}

impl Lights {
    /// The lights of a scene.
    pub fn new(scene: &Scene) -> Self {
        let directional = scene
            .lights
            .iter()
            .map(|light| {
                let LightKind::Directional { direction } = light.kind;
                let towards = -DVec3::from(direction).normalize();
                (towards, DVec3::from(light.colour) * light.intensity)
            })
            .collect();
        Self {
            ambient: DVec3::from(scene.ambient),
            directional,
        }
    }

    /// `clamp(emission*Cd + Ca*ka*A + sum of L*Cd*kd*max(0, N.l))` for a unit
    /// world normal, which is used as it stands, whichever side is seen.
    pub fn shine(&self, material: &Material, normal: DVec3) -> Lit {
        let mut diffuse = DVec3::ZERO;
        for (towards, light) in &self.directional {
            diffuse += *light * normal.dot(*towards).max(0.0);
        }
        let ambient = self.ambient * material.ambient;
        diffuse *= material.diffuse;
        let colour = DVec3::from(material.diffuse_colour) * (diffuse + material.emission)
            + DVec3::from(material.ambient_colour) * ambient;
        let level = material.emission + mean(ambient.into()) + mean(diffuse.into());
        Lit {
            colour: colour.clamp(DVec3::ZERO, DVec3::ONE),
            level: 255.0 * level.clamp(0.0, 1.0),
        }
    }
}

/// Grey by the mean of the channels.
fn mean(colour: Rgb) -> f64 {
    (colour[0] + colour[1] + colour[2]) / 3.0
}
