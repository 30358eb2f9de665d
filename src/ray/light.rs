//! Light at a surface: the scene's lights, as far as nothing is in their way.

use super::actors::RayActors;
use super::ray::{FAR, Ray, between, moved};
use super::sequence::on_light;
use super::surface::Surface;
use super::windows::Windows;
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
        }; LIGHTS],
    };

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
    /// See [`Ray::on`].
    pub on: u16,
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

/// What a surface gives back of the scene's lights, and which of them reach it.
#[inline(never)]
pub(super) fn shine(
    (lights, settings): (&RayLights, &RaySettings),
    scene: &Scene<'_>,
    (actors, windows): (&mut RayActors<'_>, &mut Windows),
    lit: &Lit<'_>,
    seed: Seed,
) -> (Parts, u8) {
    let surface = lit.surface;
    let normal = shorten(surface.normal);
    let face = shorten(surface.face);
    let mut sums = WorldSums::default();
    let mut mask = 0;
    let all = lights.model.all().zip(&lights.lamps).enumerate();
    for (number, (light, lamp)) in all {
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
                let side = short_dot(face, towards);
                if side <= -GRAZING {
                    continue;
                }
                let start = moved(surface.place, surface.face, lit.lift);
                let ray = if light.is_directional() {
                    Some((lamp.towards, FAR))
                } else {
                    unit(between(from, start)).map(|(direction, per_length)| {
                        let length = crate::math::scaled_reciprocal(per_length);
                        // Up to the light, but not what it may be off.
                        let length = length.fixed(0);
                        (
                            direction,
                            length.saturating_sub(2 + (length >> 26)).min(FAR),
                        )
                    })
                };
                let Some((direction, far)) = ray else {
                    continue;
                };
                if side < GRAZING && side_of(surface.face, direction) <= 0 {
                    continue;
                }
                let ray = Ray {
                    origin: start,
                    direction,
                    near: 0,
                    far,
                    on: lit.on,
                };
                let through = {
                    let window = light
                        .is_directional()
                        .then_some((&mut *windows, number as u8));
                    passes(scene, actors, &ray, window)
                };
                if through == 0 {
                    continue;
                }
                if through < 1 << 16 {
                    factor = Scaled::new(factor, -16)
                        .times(Scaled::new(through, 0))
                        .fixed(0);
                }
            }
            mask |= 1u8 << (number & 7);
            sums.add(&light, lit.material, normal, (towards, factor), lit.eye);
        }
    }
    (sums.parts(lit.material, surface.tint), mask)
}

/// How much light passes along a ray, 2^16 is all; `parallel` to a light at infinity, whose
/// number is given.
#[inline(never)]
fn passes(
    scene: &Scene<'_>,
    actors: &mut RayActors<'_>,
    ray: &Ray,
    mut parallel: Option<(&mut Windows, u8)>,
) -> u32 {
    let mut through = 1u32 << 16;
    let mut candidates = actors.candidates(ray);
    while let Some(next) = candidates.next() {
        let Some(actor) = actors.candidate(next, ray, ray.far) else {
            continue;
        };
        let left = (1u32 << 16).saturating_sub(actor.optics.opacity);
        let window = parallel
            .as_mut()
            .map(|(windows, light)| (&mut **windows, *light));
        for _ in 0..actor.in_the_way(scene, ray, window) {
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
