//! From a ray to a colour, by an explicit stack of the rays that go on from it
//! (Whitted, "An improved illumination model for shaded display", 1980).

use super::actors::RayActors;
use super::bounce::Facing;
use super::camera::RayCamera;
use super::gather::Candidates;
use super::light::{Lit as LitPoint, RayLights, Seed, shine, shorten};
use super::nearest::Met;
use super::ray::{FAR, Ray, moved};
use super::surface::Need;
use super::windows::Windows;
use crate::light::{Lit, Parts, sum};
use crate::math::{Unit3, dot};
use crate::palette::Palette;
use crate::scene::NO_TEXEL;
use crate::scene::layout::BASES;
use crate::scene::{Gradient, Material, Optics, RaySettings, Scene, Shading};
use crate::shade::{Lookup, Sampler, on_texel};

/// Rays that wait: every one of a chain of 8 leaves one behind, and the last two.
const WAITING: usize = 10;
/// 1 as weights have it.
const ONE: u32 = 1 << 16;
/// Rays of less weight show nothing: an eighth of a level.
const LEAST: u32 = 1 << 5;

/// What a ray from the camera shows.
#[derive(Clone, Copy, Debug)]
pub(super) struct Shown {
    /// The nearest surface: actor, and distance along the ray.
    pub actor: u16,
    pub distance: u32,
    /// Its triangle's place in the scene's list; `None` of a ball.
    pub triangle: Option<u32>,
    /// Lights that reach it: a bit each.
    pub lights: u8,
    pub light: Light,
}

/// A pixel's light and its way to a palette index.
#[derive(Clone, Copy, Debug)]
pub(super) enum Light {
    /// As the material has it, of a surface by itself.
    Own(u16, Lit, Option<u8>),
    /// Of several surfaces.
    Mixed(Lit),
}

/// A frame's scene, ready to be traced.
pub(super) struct Tracer<'a> {
    pub scene: &'a Scene<'a>,
    pub actors: RayActors<'a>,
    pub lights: &'a RayLights,
    pub windows: &'a mut Windows,
    pub settings: RaySettings,
    pub palette: Palette<'a>,
    pub background: Gradient<'a>,
}

/// A ray that waits for its turn.
#[derive(Clone, Copy)]
struct Waiting {
    ray: Ray,
    weight: u32,
    /// Rays that may still follow one after the other, itself counted.
    left: u8,
}

/// A surface by itself.
struct Local {
    material: Material,
    /// Where its colour goes through a texture by level: the base colour.
    base: Option<u8>,
    lit: Lit,
    lights: u8,
    /// If light goes on from it: the sides that face the ray.
    facing: Option<(Facing, [i32; 3], bool)>,
}

impl Tracer<'_> {
    /// What a ray from a viewport's camera shows; `None`: the background. Only `listed`
    /// actors are looked at, and of their triangles `only` some.
    pub(super) fn camera(
        &mut self,
        ray: &Ray,
        (viewport, camera): (u16, &RayCamera),
        listed: impl Iterator<Item = u16>,
        only: Option<Candidates<'_>>,
        seed: Seed,
    ) -> Option<Shown> {
        let mut best: Option<(u16, Met)> = None;
        let mut far = ray.far;
        for number in listed {
            let seen = self.actors.seen(number, viewport, camera, ray.origin);
            let Some((which, from)) = seen else { break };
            if let Some(met) = which.meet(self.scene, ray, from, far, only) {
                far = met.distance;
                best = Some((number, met));
            }
        }
        let (actor, met) = best?;
        let optics = self.actors.get(actor)?.optics;
        let triangle = self.actors.get(actor)?.triangle(self.scene, &met);
        let local = self.local(ray, actor, &met, seed)?;
        let light = if optics.reflectivity == 0 && optics.opacity >= ONE {
            let material = self.actors.get(actor)?.material;
            Light::Own(material, local.lit, local.base)
        } else {
            let mut sums = [0; 3];
            self.go_on(ray, actor, &local, &optics, &met, seed, &mut sums);
            Light::Mixed(sums.map(|c| ((c + (1 << 15)) >> 16).min(255 << 6) as u16))
        };
        Some(Shown {
            actor,
            distance: met.distance,
            triangle,
            lights: local.lights,
            light,
        })
    }

    /// The nearest of all actors.
    fn nearest(&mut self, ray: &Ray) -> Option<(u16, Met)> {
        let mut best: Option<(u16, Met)> = None;
        let mut far = ray.far;
        let mut candidates = self.actors.candidates(ray);
        while let Some(next) = candidates.next() {
            let Some(actor) = self.actors.candidate(next, ray, far) else {
                continue;
            };
            let from = if actor.is_exact() {
                None
            } else {
                actor.place(ray.origin)
            };
            if let Some(met) = actor.meet(self.scene, ray, from, far, None) {
                far = met.distance;
                best = Some((next.0, met));
            }
        }
        best
    }

    #[inline(never)]
    fn local(&mut self, ray: &Ray, number: u16, met: &Met, seed: Seed) -> Option<Local> {
        let actor = self.actors.get(number)?;
        let material = self.scene.material(actor.material);
        let goes_on = actor.optics != Optics::PLAIN;
        let need = Need {
            face: self.settings.shadows || goes_on,
            flat: material.shading == Shading::Flat,
        };
        let surface = actor.surface_at(self.scene, ray, met, need)?;
        let lift = actor.lift(met.distance);
        let (mesh, exact) = (actor.mesh, actor.is_exact());
        let lit = LitPoint {
            surface: &surface,
            material: &material,
            eye: shorten(ray.direction.map(|c| -c)),
            lift,
            on: if exact { number + 1 } else { 0 },
        };
        let (parts, lights) = shine(
            self.lights,
            self.scene,
            (&mut self.actors, self.windows),
            &lit,
            seed,
        );
        let (lit, base) = self.textured(&material, mesh, surface.coordinates, parts);
        let facing = goes_on.then(|| {
            let facing = Facing::new(&surface, ray.direction);
            (facing, surface.place, surface.back)
        });
        Some(Local {
            material,
            base,
            lit,
            lights,
            facing,
        })
    }

    /// Light on the material's texture; of one that goes by level its base colour.
    fn textured(
        &self,
        material: &Material,
        mesh: u16,
        coordinates: Option<[i32; 2]>,
        parts: Parts,
    ) -> (Lit, Option<u8>) {
        let plain = (sum(parts.body, parts.gloss), None);
        let texture = material.texture.and_then(|t| self.scene.texture(t));
        let own = self.scene.mesh(mesh).coordinates;
        let (Some(texture), Some(own), Some(place)) = (texture, own, coordinates) else {
            return plain;
        };
        let sampler = Sampler::new(self.scene, texture, own);
        let (path, place) = sampler.point(place);
        if material.coloured {
            match sampler.colour(&path, place) {
                Some(texel) => (on_texel(parts, texel), None),
                None => plain,
            }
        } else {
            let base = sampler.nearest(&path, place).unwrap_or(NO_TEXEL);
            (sum(parts.body, parts.gloss), Some(base % BASES as u8))
        }
    }

    /// Adds the colour of a surface and of all rays that go on from it.
    #[expect(clippy::too_many_arguments, reason = "one call")]
    fn go_on(
        &mut self,
        ray: &Ray,
        actor: u16,
        local: &Local,
        optics: &Optics,
        met: &Met,
        seed: Seed,
        sums: &mut [u32; 3],
    ) {
        let mut waiting = [None::<Waiting>; WAITING];
        let mut count = 0;
        let first = Waiting {
            ray: *ray,
            weight: ONE,
            left: self.settings.depth,
        };
        self.add(
            &first,
            actor,
            local,
            optics,
            met,
            &mut waiting,
            &mut count,
            sums,
        );
        while let Some(next) = count.checked_sub(1) {
            count = next;
            let Some(now) = waiting.get(next).copied().flatten() else {
                continue;
            };
            if now.left == 0 {
                self.add_background(now.ray.direction, now.weight, sums);
                continue;
            }
            let Some((actor, met)) = self.nearest(&now.ray) else {
                self.add_background(now.ray.direction, now.weight, sums);
                continue;
            };
            let optics = self.actors.get(actor).map_or(Optics::PLAIN, |a| a.optics);
            if let Some(local) = self.local(&now.ray, actor, &met, seed) {
                self.add(
                    &now,
                    actor,
                    &local,
                    &optics,
                    &met,
                    &mut waiting,
                    &mut count,
                    sums,
                );
            }
        }
    }

    #[expect(clippy::too_many_arguments, reason = "two calls")]
    fn add(
        &mut self,
        now: &Waiting,
        actor: u16,
        local: &Local,
        optics: &Optics,
        met: &Met,
        waiting: &mut [Option<Waiting>; WAITING],
        count: &mut usize,
        sums: &mut [u32; 3],
    ) {
        let part = |weight: u32, of: u32| (weight * (of >> 1)) >> 15;
        let mut mirror = part(now.weight, optics.reflectivity);
        let rest = now.weight - mirror.min(now.weight);
        let own = part(rest, optics.opacity);
        let mut through = rest - own.min(rest);
        add(sums, self.colour(local), own);
        let Some((facing, place, back)) = local.facing else {
            return;
        };
        let Some(which) = self.actors.get(actor) else {
            return;
        };
        let (lift, ball) = (which.lift(met.distance), which.is_exact());
        let mut push = |direction: Unit3, weight: u32, out: bool| {
            if weight < LEAST {
                return;
            }
            let outward = facing.outward();
            let ray = Ray {
                origin: moved(place, outward, if out { lift } else { -lift }),
                direction,
                near: 0,
                far: FAR,
                on: if ball { actor + 1 } else { 0 },
            };
            if let Some(slot) = waiting.get_mut(*count) {
                *slot = Some(Waiting {
                    ray,
                    weight,
                    left: now.left - 1,
                });
                *count += 1;
            }
        };
        if through > 0 {
            if optics.index == ONE {
                push(now.ray.direction, through, false);
            } else {
                // Q28 of the index on this side over that beyond.
                let ratio = if back {
                    (optics.index << 12) as i32
                } else {
                    inverse(optics.index)
                };
                match facing.refracted(now.ray.direction, ratio) {
                    Some((way, mirrored)) => {
                        let mirrored = part(through, mirrored.min(ONE));
                        through -= mirrored.min(through);
                        mirror += mirrored;
                        push(way, through, false);
                    }
                    None => mirror += through,
                }
            }
        }
        if mirror > 0 {
            push(facing.mirrored(now.ray.direction), mirror, true);
        }
    }

    /// The colour of a surface by itself.
    fn colour(&self, local: &Local) -> Lit {
        self.rgb(&local.material, local.lit, local.base)
    }

    /// Light as red, green and blue, of a material that goes by level too.
    pub(super) fn rgb(&self, material: &Material, lit: Lit, base: Option<u8>) -> Lit {
        if material.coloured {
            return lit;
        }
        let pixel = crate::shade::Pixel {
            lookup: lookup(self.scene, material, base),
            lit,
            place: [0; 2],
            texel: [0; 2],
        };
        let index = crate::shade::dithered(&pixel, crate::scene::Dither::NONE);
        self.entry(index)
    }

    /// The colour of a palette entry.
    pub(super) fn entry(&self, index: u8) -> Lit {
        self.palette.rgb888(index).map(|c| u16::from(c) << 6)
    }

    /// What a ray shows that meets nothing.
    fn add_background(&self, direction: Unit3, weight: u32, sums: &mut [u32; 3]) {
        let up = dot(direction, self.settings.up).clamp(-(1 << 30), 1 << 30);
        // From top to bottom.
        let down = (1u32 << 30).wrapping_sub(up as u32) >> 15;
        // Its ends are entries as they are, what is between them need not be.
        let [top, bottom] = self.background.ends().map(|index| self.entry(index));
        let mut colour = top;
        for (c, bottom) in colour.iter_mut().zip(bottom) {
            *c = (((0x1_0000 - down) * u32::from(*c) + down * u32::from(bottom)) >> 16) as u16;
        }
        add(sums, colour, weight);
    }
}

/// A material's way to an index.
pub(super) fn lookup<'a>(scene: &Scene<'a>, material: &Material, base: Option<u8>) -> Lookup<'a> {
    match base {
        _ if material.coloured => Lookup::Colours(scene.colours()),
        Some(base) => Lookup::Texel(scene.texture_shades(material), base),
        None => Lookup::Levels(scene.shade(material)),
    }
}

fn add(sums: &mut [u32; 3], colour: Lit, weight: u32) {
    for (sum, c) in sums.iter_mut().zip(colour) {
        // 14 bits and 17; weights are 1 in all.
        *sum = sum.saturating_add(u32::from(c) * weight);
    }
}

/// Q28 of one over a refractive index.
fn inverse(index: u32) -> i32 {
    let recip = crate::math::reciprocal(index);
    // 62 - shift fractional bits, 16 of the index.
    recip.mantissa >> (18 - recip.shift.min(18))
}
