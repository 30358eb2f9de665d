//! The colour of a surface under a scene's lights, to know which colours a palette
//! needs. [`Material`] has the formula.

use fixel_scene::{Light, LightKind, Material, Scene};
use glam::{DVec2, DVec3};

/// A point of a surface.
#[derive(Clone, Copy, Debug)]
pub(super) struct Point {
    /// In the world.
    pub place: DVec3,
    /// Unit length.
    pub normal: DVec3,
    /// The vertex colour.
    pub tint: DVec3,
    /// In the texture, if there is one.
    pub coordinates: DVec2,
}

/// What light makes of a surface.
#[derive(Clone, Copy, Debug)]
pub(super) struct Lit {
    /// The part that is of the surface's own colour.
    pub own: DVec3,
    /// Highlights.
    pub gloss: DVec3,
}

impl Lit {
    /// Between three others.
    pub(super) fn mix([a, b, c]: [Self; 3], [u, v, w]: [f64; 3]) -> Self {
        Self {
            own: a.own * u + b.own * v + c.own * w,
            gloss: a.gloss * u + b.gloss * v + c.gloss * w,
        }
    }

    /// Each part, or the sum, as bright as it can be shown.
    pub(super) fn clamped(self, textured: bool) -> Self {
        let clamp = |colour: DVec3| colour.clamp(DVec3::ZERO, DVec3::ONE);
        if textured {
            Self {
                own: clamp(self.own),
                gloss: clamp(self.gloss),
            }
        } else {
            Self {
                own: clamp(self.own + self.gloss),
                gloss: DVec3::ZERO,
            }
        }
    }
}

impl Point {
    /// Between three others.
    pub(super) fn mix([a, b, c]: &[Self; 3], [u, v, w]: [f64; 3]) -> Self {
        let mix = |get: fn(&Self) -> DVec3| get(a) * u + get(b) * v + get(c) * w;
        let coordinates = a.coordinates * u + b.coordinates * v + c.coordinates * w;
        Self {
            place: mix(|p| p.place),
            normal: mix(|p| p.normal).normalize_or_zero(),
            tint: mix(|p| p.tint),
            coordinates,
        }
    }
}

/// Red, green, blue. `eye` is the unit vector towards it.
pub(super) fn lit(scene: &Scene, material: &Material, point: &Point, eye: DVec3) -> Lit {
    let diffuse = DVec3::from(material.diffuse_colour) * point.tint;
    let ambient = DVec3::from(material.ambient_colour) * point.tint;
    let mut gloss = DVec3::ZERO;
    let mut own =
        diffuse * material.emission + ambient * DVec3::from(scene.ambient) * material.ambient;
    for light in &scene.lights {
        let Some((towards, strength)) = reach(light, point.place) else {
            continue;
        };
        let cosine = point.normal.dot(towards);
        if cosine > 0.0 {
            let mirrored = point.normal * (2.0 * cosine) - towards;
            let gleam = libm::pow(mirrored.dot(eye).max(0.0), material.specular_power);
            own += strength * diffuse * (material.diffuse * cosine);
            gloss += strength * DVec3::from(material.specular_colour) * (material.specular * gleam);
        }
    }
    Lit { own, gloss }
}

/// The unit vector towards a light, and what of its light gets to a place.
fn reach(light: &Light, place: DVec3) -> Option<(DVec3, DVec3)> {
    let full = DVec3::from(light.colour) * light.intensity;
    let unit = |direction: [f64; 3]| DVec3::from(direction).normalize_or_zero();
    let from = |position: [f64; 3], [c, l, q]: [f64; 3]| {
        let way = DVec3::from(position) - place;
        let distance = way.length();
        let strength = full / (c + distance * (l + distance * q));
        (distance > 0.0).then(|| (way / distance, strength))
    };
    match light.kind {
        LightKind::Directional { direction } => Some((-unit(direction), full)),
        LightKind::Point {
            position,
            attenuation,
        } => from(position, attenuation),
        LightKind::Spot {
            position,
            direction,
            attenuation,
            cone_angle,
            exponent,
        } => {
            let (towards, strength) = from(position, attenuation)?;
            let cosine = -towards.dot(unit(direction));
            let inside = cosine >= libm::cos(cone_angle.to_radians());
            inside.then(|| (towards, strength * libm::pow(cosine, exponent)))
        }
    }
}
