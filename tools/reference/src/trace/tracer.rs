//! The colour that a ray brings back.

use super::bounce::{Bent, mirror, refract};
use super::counts::Counters;
use super::sequence::on_light;
use super::world::{Met, Spot, World};
use crate::bvh::Line;
use crate::light::{Lights, Lit, Sample, SurfacePoint};
use fixel_scene::{Background, Material, Ray, Rgb, Shading};
use glam::DVec3;

/// Shadow rays end short of the light by this part of their length.
const BEFORE_LIGHT: f64 = 1e-9;

/// Everything that the rays of one window share.
#[derive(Debug)]
pub(crate) struct Tracer<'a> {
    pub world: &'a World,
    pub lights: &'a Lights,
    pub how: &'a Ray,
    /// What is seen where nothing is.
    pub background: Background,
    /// The camera's view-up vector, unit length.
    pub up: DVec3,
    pub counters: &'a Counters,
}

/// Which of the picture's samples a chain of rays is for.
#[derive(Clone, Copy, Debug)]
pub(crate) struct For {
    /// Column and row.
    pub pixel: [u32; 2],
    /// Number of the sample in the pixel.
    pub sample: u32,
}

/// How much of a light gets to a point.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Reach {
    /// The mean over its samples, 0..=1.
    pub part: f64,
    /// The greatest cosine of the angle between the normal and the light.
    pub cosine: f64,
}

/// What a surface shows.
#[derive(Clone, Debug)]
pub(crate) struct Shown {
    /// Its light by itself, without texture.
    pub lit: Lit,
    /// With texture, mirrors and what shines through.
    pub colour: DVec3,
    pub spot: Spot,
    /// Of each light.
    pub reaches: Vec<Reach>,
}

impl Tracer<'_> {
    /// What a surface shows along a line; `depth`: how many rays the chain has so far.
    pub fn show(&self, line: &Line, met: &Met<'_>, depth: u32, aim: For) -> Shown {
        let material = self.world.material(met.surface);
        let spot = self.world.spot(line, met);
        let direction = line.direction.normalize();
        let mut reaches = vec![Reach::default(); self.lights.count()];
        let lit = self.local(material, &spot, met, direction, aim, &mut reaches);
        let local = match spot.texel {
            Some((_, texel)) => lit.textured(texel.colour),
            None => lit.colour,
        };
        let colour = self.with_bounces(material, &spot, met, direction, local, depth, aim);
        Shown {
            lit,
            colour: colour.clamp(DVec3::ZERO, DVec3::ONE),
            spot,
            reaches,
        }
    }

    /// The light model with shadows.
    fn local(
        &self,
        material: &Material,
        spot: &Spot,
        met: &Met<'_>,
        direction: DVec3,
        aim: For,
        reaches: &mut [Reach],
    ) -> Lit {
        let normal = if material.shading == Shading::Flat {
            spot.face_normal
        } else {
            spot.normal
        };
        let point = SurfacePoint {
            place: spot.place,
            normal,
            eye: -direction,
            tint: spot.tint,
        };
        let count = self.how.light_samples;
        let places: Vec<[f64; 2]> = (0..count)
            .map(|j| on_light(j, count, aim.sample, aim.pixel))
            .collect();
        self.lights.gather(material, &point, &places, |sample| {
            let part = self.unshaded(spot, met.number, sample);
            let reach = &mut reaches[sample.light];
            reach.part += part * sample.weight;
            reach.cosine = reach.cosine.max(sample.cosine);
            part
        })
    }

    /// The part of a light's sample that gets to a point whose normal is turned to it.
    fn unshaded(&self, spot: &Spot, from: usize, sample: &Sample) -> f64 {
        if !self.how.shadows {
            return 1.0;
        }
        if spot.face_normal.dot(sample.towards) <= 0.0 {
            return 0.0;
        }
        self.counters.shadow();
        let line = Line {
            origin: spot.place,
            direction: sample.towards,
        };
        let until = sample.distance * (1.0 - BEFORE_LIGHT);
        let mut part = 1.0;
        self.world.between(&line, [0.0, until], Some(from), |met| {
            part *= 1.0 - self.world.material(met.surface).opacity;
            part > 0.0
        });
        part
    }

    #[expect(
        clippy::too_many_arguments,
        reason = "what a surface is, and where in the chain"
    )]
    fn with_bounces(
        &self,
        material: &Material,
        spot: &Spot,
        met: &Met<'_>,
        direction: DVec3,
        local: DVec3,
        depth: u32,
        aim: For,
    ) -> DVec3 {
        let (reflectivity, opacity) = (material.reflectivity, material.opacity);
        let clear = opacity < 1.0;
        if reflectivity == 0.0 && !clear {
            return local;
        }
        // Each turned against the ray by itself: at an outline they can disagree.
        let against = |normal: DVec3| {
            if normal.dot(direction) > 0.0 {
                -normal
            } else {
                normal
            }
        };
        let face = against(spot.face_normal);
        let normal = if material.shading == Shading::Flat {
            face
        } else {
            against(spot.normal)
        };
        let go = |direction: DVec3| {
            let line = Line {
                origin: spot.place,
                direction,
            };
            self.radiance(&line, met.number, depth + 1, aim)
        };
        let bends = clear && material.refractive_index != 1.0;
        let mirrored = (reflectivity > 0.0 || bends).then(|| {
            let image = mirror(direction, normal);
            let out = image.dot(face) > 0.0;
            go(if out { image } else { mirror(direction, face) })
        });
        let mirrored = mirrored.unwrap_or_default();
        let through = if bends {
            let inward = material.refractive_index;
            let index = if met.front { inward } else { 1.0 / inward };
            let mut bent = refract(direction, normal, index);
            if bent.direction.is_some_and(|bent| bent.dot(face) >= 0.0) {
                bent = refract(direction, face, index);
            }
            let Bent {
                mirrored: part,
                direction,
            } = bent;
            direction.map_or(mirrored, |direction| {
                mirrored.lerp(go(direction), 1.0 - part)
            })
        } else if clear {
            go(direction)
        } else {
            DVec3::ZERO
        };
        let own = local * opacity + through * (1.0 - opacity);
        own * (1.0 - reflectivity) + mirrored * reflectivity
    }

    /// What a ray sees that is not the eye's and begins on a surface.
    fn radiance(&self, line: &Line, from: usize, depth: u32, aim: For) -> DVec3 {
        if depth > self.how.depth {
            return self.sky(line.direction);
        }
        self.counters.bounced();
        match self.world.nearest(line, [0.0, f64::INFINITY], Some(from)) {
            Some(met) => self.show(line, &met, depth, aim).colour,
            None => self.sky(line.direction),
        }
    }

    /// The background in a direction of unit length.
    fn sky(&self, direction: DVec3) -> DVec3 {
        match self.background {
            Background::Solid(colour) => colour.into(),
            Background::Gradient { top, bottom } => {
                let [top, bottom]: [DVec3; 2] = [top, bottom].map(|c: Rgb| c.into());
                top.lerp(bottom, (1.0 - direction.dot(self.up)) / 2.0)
            }
        }
    }
}
