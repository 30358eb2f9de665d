//! Light at a surface: the scene's lights, as far as nothing is in their way.

use super::actors::RayActors;
use super::coarse::Candidates;
use super::ray::{FAR, Ray, between, moved};
use super::sequence::on_light;
use super::shades::{Shades, Towards};
use super::surface::Surface;
use super::windows::{Parallel, Windows};
use crate::light::{Parts, ShortUnit, WorldLights, WorldSums};
use crate::math::{Scaled, Unit3, mul_high, mul_q30, short_dot, unit};
use crate::scene::layout::LIGHTS;
use crate::scene::{LightArea, LightKind, Material, RaySettings, Scene};

/// Where a light is.
#[derive(Clone, Copy, Debug)]
struct Lamp {
    /// Raw world bits.
    position: [i32; 3],
    /// To a directional light.
    towards: Unit3,
    area: Option<LightArea>,
    /// All of it is within this of its position.
    size: u32,
}

/// The lights of a frame.
#[derive(Clone, Copy, Debug)]
pub(super) struct RayLights {
    model: WorldLights,
    lamps: [Lamp; LIGHTS],
}

impl RayLights {
    pub(super) const NONE: Self = Self {
        model: WorldLights::NONE,
        lamps: [Lamp {
            position: [0; 3],
            towards: [0; 3],
            area: None,
            size: 0,
        }; LIGHTS],
    };

    /// Whether there is one that is infinitely far away.
    pub(super) fn any_directional(&self) -> bool {
        let mut all = self.model.all();
        all.any(|light| light.is_directional())
    }

    /// Whether there is one that has a place.
    pub(super) fn any_placed(&self) -> bool {
        let mut all = self.model.all();
        all.any(|light| !light.is_directional())
    }

    /// Those of a scene.
    #[inline(never)]
    pub(super) fn set(&mut self, scene: &Scene<'_>) {
        self.model.set(scene);
        let found = scene.lights().enumerate();
        for (lamp, (number, light)) in self.lamps.iter_mut().zip(found) {
            let area = scene.light_area(number);
            let large = area != LightArea::POINT && light.kind != LightKind::Directional;
            *lamp = Lamp {
                position: light.position,
                towards: light.towards,
                area: large.then_some(area),
                // Half the edges, and a rounding each.
                size: area
                    .edges
                    .as_flattened()
                    .iter()
                    .fold(8, |all: u32, c| all.saturating_add(c.unsigned_abs() / 2)),
            };
        }
    }
}

/// Which sample of which pixel.
#[derive(Clone, Copy, Debug)]
pub(super) struct Seed {
    pub pixel: [u32; 2],
    pub sample: u32,
}

/// What is lit.
pub(super) struct Lit<'a> {
    pub surface: &'a Surface,
    pub material: &'a Material,
    /// Against the ray.
    pub eye: ShortUnit,
    /// How far off the surface shadow rays start, raw world bits.
    pub lift: i32,
    /// How far away it was seen from, and to which part of that, as a power of two, what is
    /// between it and lights may be kept for what is beside it.
    pub distance: u32,
    pub spread: u32,
    /// See [`Ray::on`].
    pub on: u16,
    /// See [`Parallel::source`].
    pub source: Option<u16>,
}

/// 28 fractional bits: where short directions do not say on which side of a face a light
/// is.
const GRAZING: i32 = 1 << 16;

/// The cosine between a face's normal and a direction, 30 fractional bits.
fn side_of([x, y, z]: Unit3, [dx, dy, dz]: Unit3) -> i32 {
    mul_q30(x, dx)
        .saturating_add(mul_q30(y, dy))
        .saturating_add(mul_q30(z, dz))
}

/// What rays to lights meet.
pub(super) struct Shadows<'t, 'a> {
    pub scene: &'t Scene<'a>,
    pub actors: &'t mut RayActors<'a>,
    pub windows: &'t mut Windows,
    pub shades: &'t mut Shades,
}

/// What a surface gives back of the scene's lights, and which of them reach it.
#[inline(never)]
pub(super) fn shine(
    (lights, settings): (&RayLights, &RaySettings),
    shadows: &mut Shadows<'_, '_>,
    lit: &Lit<'_>,
    seed: Seed,
) -> (Parts, u8) {
    let surface = lit.surface;
    let normal = shorten(surface.normal);
    let mut sums = WorldSums::default();
    let mut mask = 0;
    for (number, lamp) in lights.lamps.iter().enumerate() {
        let Some(light) = lights.model.get(number) else {
            break;
        };
        let samples = match lamp.area {
            Some(_) => u32::from(settings.light_samples),
            None => 1,
        };
        for which in 0..samples {
            let from = match &lamp.area {
                Some(area) => sampled(lamp.position, area, (which, samples), seed),
                None => lamp.position,
            };
            let Some((towards, factor)) = light.reaches(from, surface.place) else {
                continue;
            };
            if short_dot(normal, towards) <= 0 {
                continue;
            }
            let mut factor = share(factor, samples);
            if settings.shadows {
                let directional = light.is_directional();
                let through = shadows.through(lit, (number, lamp, directional), from, towards);
                if through == 0 {
                    continue;
                }
                if through < 1 << 16 {
                    factor = part(factor, through);
                }
            }
            mask |= 1u8 << (number & 7);
            sums.add(&light, lit.material, normal, (towards, factor), lit.eye);
        }
    }
    (sums.parts(lit.material, surface.tint), mask)
}

/// A part of a factor, of 2^16.
#[cold]
#[inline(never)]
fn part(factor: u32, through: u32) -> u32 {
    let product = Scaled::new(factor, -16).times(Scaled::new(through, 0));
    product.fixed(0)
}

impl Shadows<'_, '_> {
    /// How much light gets from a place on a lamp to a surface, 2^16 is all; the lamp with its
    /// number, and whether it is infinitely far away.
    #[inline(never)]
    fn through(
        &mut self,
        lit: &Lit<'_>,
        (number, lamp, directional): (usize, &Lamp, bool),
        from: [i32; 3],
        towards: ShortUnit,
    ) -> u32 {
        let surface = lit.surface;
        let side = short_dot(shorten(surface.face), towards);
        if side <= -GRAZING {
            return 0;
        }
        let far = if directional {
            Towards::Direction(lamp.towards)
        } else {
            Towards::Place(lamp.position, lamp.size)
        };
        let near = (lit.distance >> lit.spread, lit.lift as u32);
        let between = self
            .shades
            .find(self.actors, surface.place, (number, &far), near);
        let between = between.without(lit.on.wrapping_sub(1));
        if side >= GRAZING && between.is_empty() {
            return 1 << 16;
        }
        let Some(ray) = ray_to(lit, (directional, lamp, from)) else {
            return 0;
        };
        if side < GRAZING && side_of(surface.face, ray.direction) <= 0 {
            return 0;
        }
        let parallel = Parallel {
            light: number as u8,
            source: lit.source,
        };
        let windows = (&mut *self.windows, directional.then_some(parallel));
        passes(self.scene, self.actors, &ray, between, windows)
    }
}

/// The ray to a lamp, or to a place on it.
#[inline(always)]
fn ray_to(lit: &Lit<'_>, (directional, lamp, from): (bool, &Lamp, [i32; 3])) -> Option<Ray> {
    let start = moved(lit.surface.place, lit.surface.face, lit.lift);
    let (direction, far) = if directional {
        (lamp.towards, FAR)
    } else {
        let (direction, per_length) = unit(between(from, start))?;
        // Up to the light, but not what it may be off.
        let length = crate::math::scaled_reciprocal(per_length).fixed(0);
        (
            direction,
            length.saturating_sub(2 + (length >> 26)).min(FAR),
        )
    };
    Some(Ray {
        on: lit.on,
        ..Ray::from_to(start, direction, far)
    })
}

/// How much light passes by what may be in a ray's way, 2^16 is all; windows are for those
/// to a light at infinity.
#[inline(never)]
fn passes(
    scene: &Scene<'_>,
    actors: &mut RayActors<'_>,
    ray: &Ray,
    mut between: Candidates,
    (windows, parallel): (&mut Windows, Option<Parallel>),
) -> u32 {
    let mut through = 1u32 << 16;
    while let Some((number, untried)) = between.next() {
        if untried && actors.passes_by(number, ray) {
            continue;
        }
        let Some(actor) = actors.get(number) else {
            continue;
        };
        // Rays to a light leave what they start on.
        if actor.radius == 0 || ray.on == number.wrapping_add(1) {
            continue;
        }
        // A ball's test begins with the same, and windows are asked before.
        let asks = actor.is_exact() || (parallel.is_some() && actor.is_opaque());
        if !asks && actor.missed(ray, ray.far) {
            continue;
        }
        let left = (1u32 << 16).saturating_sub(actor.optics.opacity);
        for _ in 0..actor.in_the_way(scene, ray, (windows, parallel)) {
            through = ((through >> 1) * (left >> 1)) >> 14;
            if through == 0 {
                return 0;
            }
        }
    }
    through
}

/// One of several equal shares, rounded.
fn share(factor: u32, samples: u32) -> u32 {
    if samples == 1 {
        return factor;
    }
    (factor + samples / 2)
        .checked_div(samples)
        .unwrap_or(factor)
}

/// The place of a sample of a light. By itself, so that lights that are points do not
/// pay for it.
#[inline(never)]
fn sampled(middle: [i32; 3], area: &LightArea, (which, of): (u32, u32), seed: Seed) -> [i32; 3] {
    let place = on_light(which, of, seed.sample, seed.pixel);
    // From the middle, 2^-32.
    let parts = place.map(|c| c.wrapping_sub(1 << 31) as i32);
    let mut place = middle;
    for (edge, part) in area.edges.iter().zip(parts) {
        for (c, e) in place.iter_mut().zip(edge) {
            *c = c.saturating_add(mul_high(*e, part));
        }
    }
    place
}

/// To 14 fractional bits.
#[inline(always)]
pub(super) fn shorten(v: Unit3) -> ShortUnit {
    v.map(|c| (c + (1 << 15)) >> 16)
}

// A light has one bit of a byte.
const _: () = assert!(LIGHTS <= 8);
