//! The light model, on display-encoded values as VTK and OpenGL compute it.
//! [`fixel_scene::Material`] has the formula.

use fixel_scene::{Attenuation, LightKind, Material, Rgb, Scene};
use glam::DVec3;

/// Light at one point of a surface.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Lit {
    /// Red, green, blue, each clamped to 0..=1.
    pub colour: DVec3,
    /// The part of it that is of the surface's own colour, clamped by itself.
    pub own: DVec3,
    /// The part that is not: highlights, clamped by themselves.
    pub gloss: DVec3,
    /// The same for a white material without vertex colours under lights made
    /// grey, 0..=255.
    pub level: f64,
}

impl Lit {
    /// The mean of three corners with the given weights.
    pub fn weighted(corners: [Self; 3], weights: [f64; 3]) -> Self {
        // The weights' sum is 1 but for rounding.
        Self {
            colour: mix(corners.map(|c| c.colour), weights).min(DVec3::ONE),
            own: mix(corners.map(|c| c.own), weights),
            gloss: mix(corners.map(|c| c.gloss), weights),
            level: mix(corners.map(|c| c.level), weights).min(255.0),
        }
    }

    /// The colour under a texture's.
    pub fn textured(&self, texel: DVec3) -> DVec3 {
        (texel * self.own + self.gloss).clamp(DVec3::ZERO, DVec3::ONE)
    }
}

/// A point of a surface, as the light model sees it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct SurfacePoint {
    /// Where, in the world.
    pub place: DVec3,
    /// The normal, unit length, used as it stands, whichever side is seen.
    pub normal: DVec3,
    /// Towards the eye, unit length.
    pub eye: DVec3,
    /// The vertex colour; white if the mesh has none.
    pub tint: DVec3,
}

/// A scene's lights, directions turned to point at the light.
#[derive(Clone, Debug)]
pub(crate) struct Lights {
    ambient: DVec3,
    sources: Vec<Source>,
}

/// A light with its colour times intensity.
#[derive(Clone, Debug)]
struct Source {
    light: DVec3,
    from: From,
    /// Of a light that has an extent.
    edges: Option<[DVec3; 2]>,
}

/// A place from which a light gets to a surface that is turned to it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Sample {
    /// The light's index in the scene.
    pub light: usize,
    /// Towards the place, unit length.
    pub towards: DVec3,
    /// How far it is; infinite for a light that has none.
    pub distance: f64,
    /// Of the angle between it and the normal, above 0.
    pub cosine: f64,
    /// Its share of the light.
    pub weight: f64,
}

#[derive(Clone, Debug)]
enum From {
    /// Towards the light.
    Far(DVec3),
    Place {
        place: DVec3,
        attenuation: Attenuation,
        cone: Option<Cone>,
    },
}

#[derive(Clone, Debug)]
struct Cone {
    /// Against the way the light travels.
    axis: DVec3,
    /// Of the angle between axis and edge.
    cosine: f64,
    exponent: f64,
}

impl Lights {
    /// The lights of a scene.
    pub fn new(scene: &Scene) -> Self {
        let from = |kind: &LightKind| match *kind {
            LightKind::Directional { direction } => From::Far(against(direction)),
            LightKind::Point {
                position,
                attenuation,
            } => From::Place {
                place: position.into(),
                attenuation,
                cone: None,
            },
            LightKind::Spot {
                position,
                direction,
                attenuation,
                cone_angle,
                exponent,
            } => From::Place {
                place: position.into(),
                attenuation,
                cone: Some(Cone {
                    axis: against(direction),
                    cosine: cone_angle.to_radians().cos(),
                    exponent,
                }),
            },
        };
        let source = |light: &fixel_scene::Light| Source {
            light: DVec3::from(light.colour) * light.intensity,
            from: from(&light.kind),
            edges: light.edges.map(|edges| edges.map(DVec3::from)),
        };
        Self {
            ambient: scene.ambient.into(),
            sources: scene.lights.iter().map(source).collect(),
        }
    }

    /// How many there are, ambient ones aside.
    pub fn count(&self) -> usize {
        self.sources.len()
    }

    /// The whole light model at one point, without shadows: a light that has an extent
    /// shines from its middle.
    pub fn shine(&self, material: &Material, at: &SurfacePoint) -> Lit {
        self.gather(material, at, &[], |_| 1.0)
    }

    /// The same with only that part of each sample that `reaching` says. A light that
    /// has an extent shines from `places` on it, in parts of its edges.
    pub fn gather(
        &self,
        material: &Material,
        at: &SurfacePoint,
        places: &[[f64; 2]],
        mut reaching: impl FnMut(&Sample) -> f64,
    ) -> Lit {
        let (mut diffuse, mut specular) = (DVec3::ZERO, DVec3::ZERO);
        for (light, source) in self.sources.iter().enumerate() {
            let moves = source.moves(places);
            let weight = 1.0 / moves.len() as f64;
            for moved in moves {
                let Some((towards, distance, factor)) = source.from.reaches(at.place, moved) else {
                    continue;
                };
                let cosine = at.normal.dot(towards);
                if cosine <= 0.0 {
                    continue;
                }
                let part = reaching(&Sample {
                    light,
                    towards,
                    distance,
                    cosine,
                    weight,
                });
                let mirrored = 2.0 * cosine * at.normal - towards;
                let highlight = mirrored.dot(at.eye).max(0.0).powf(material.specular_power);
                let arriving = source.light * (factor * part * weight);
                diffuse += arriving * cosine;
                specular += arriving * highlight;
            }
        }
        let ambient = self.ambient * material.ambient;
        diffuse *= material.diffuse;
        specular *= material.specular;
        let diffuse_colour = DVec3::from(material.diffuse_colour) * at.tint;
        let ambient_colour = DVec3::from(material.ambient_colour) * at.tint;
        let own = diffuse_colour * (diffuse + material.emission) + ambient_colour * ambient;
        let gloss = DVec3::from(material.specular_colour) * specular;
        let clamped = |colour: DVec3| colour.clamp(DVec3::ZERO, DVec3::ONE);
        let grey = mean((ambient + diffuse + specular).into());
        Lit {
            colour: clamped(own + gloss),
            own: clamped(own),
            gloss: clamped(gloss),
            level: 255.0 * (material.emission + grey).clamp(0.0, 1.0),
        }
    }
}

impl Source {
    /// How far from its middle it shines.
    fn moves(&self, places: &[[f64; 2]]) -> Vec<DVec3> {
        match self.edges {
            Some([first, second]) if !places.is_empty() => places
                .iter()
                .map(|[u, v]| first * (u - 0.5) + second * (v - 0.5))
                .collect(),
            _ => vec![DVec3::ZERO],
        }
    }
}

impl From {
    /// Towards the light, moved aside, the distance, and attenuation times spot; `None`
    /// where no light gets to.
    fn reaches(&self, point: DVec3, moved: DVec3) -> Option<(DVec3, f64, f64)> {
        match self {
            From::Far(towards) => Some((*towards, f64::INFINITY, 1.0)),
            From::Place {
                place,
                attenuation: [constant, linear, quadratic],
                cone,
            } => {
                let way = *place + moved - point;
                let distance = way.length();
                let towards = way.try_normalize()?;
                let fade = 1.0 / (constant + linear * distance + quadratic * distance * distance);
                let beam = match cone {
                    None => 1.0,
                    Some(cone) => cone.beam(towards)?,
                };
                Some((towards, distance, fade * beam))
            }
        }
    }
}

impl Cone {
    /// The factor in the direction that is seen from the surface; `None`
    /// outside.
    fn beam(&self, towards: DVec3) -> Option<f64> {
        let cosine = towards.dot(self.axis);
        (cosine >= self.cosine).then(|| cosine.powf(self.exponent))
    }
}

/// The unit vector against a direction.
fn against(direction: [f64; 3]) -> DVec3 {
    -DVec3::from(direction).normalize()
}

/// The sum of three values with the given weights.
pub(crate) fn mix<T>([a, b, c]: [T; 3], weights: [f64; 3]) -> T
where
    T: std::ops::Mul<f64, Output = T> + std::ops::Add<Output = T>,
{
    a * weights[0] + b * weights[1] + c * weights[2]
}

/// Grey by the mean of the channels.
fn mean(colour: Rgb) -> f64 {
    (colour[0] + colour[1] + colour[2]) / 3.0
}
