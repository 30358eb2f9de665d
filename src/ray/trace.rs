//! From a ray to a colour.

use super::actors::RayActors;
use super::bounce::Facing;
use super::camera::RayCamera;
use super::candidates::Candidates;
use super::facet::{Facet, Need};
use super::light::{Lit as LitPoint, RayLights, Seed, Shadows, shine, shorten};
use super::nearest::{Met, Parts};
use super::ray::Ray;
use super::shades::Shades;
use super::waiting::WaitingRays;
use super::windows::Windows;
use crate::light::{self, Lit, sum};
use crate::palette::Palette;
use crate::scene::NO_TEXEL;
use crate::scene::layout::BASES;
use crate::scene::{Gradient, Material, Optics, RaySettings, Scene, Shading};
use crate::shade::{Lookup, Sampler, on_texel};

/// What is beside a place that the camera sees is, in parts of its distance, some four
/// pixels away; what is beside one that a mirror shows is farther.
const OF_CAMERA: u32 = 5;
pub(super) const OF_OTHERS: u32 = 3;

/// 1 as weights have it.
pub(super) const ONE: u32 = 1 << 16;

/// What a ray from the camera shows.
#[derive(Clone, Copy, Debug)]
pub(super) struct Shown {
    /// The nearest surface: actor, and distance along the ray.
    pub actor: u16,
    pub distance: u32,
    /// The mesh's number, the meshlet's in it, and the triangle's in that; `None` of a ball or
    /// a rectangle.
    pub triangle: Option<(u16, u32, u8)>,
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
    pub waiting: &'a mut WaitingRays,
    pub shades: &'a mut Shades,
    pub facet: &'a mut Facet,
    pub materials: Materials,
    pub settings: RaySettings,
    /// Light depends on where a surface is, not on how it lies alone.
    pub needs_places: bool,
    pub palette: Palette<'a>,
    pub background: Gradient<'a>,
}

/// A surface by itself.
pub(super) struct Local {
    /// The material's number.
    number: u16,
    /// Where its colour goes through a texture by level: the base colour.
    base: Option<u8>,
    lit: Lit,
    lights: u8,
    /// If light goes on from it: the sides that face the ray, the place, and whether it is
    /// seen from behind.
    pub facing: Option<(Facing, [i32; 3], bool)>,
}

/// The material that was asked for last, with its number: neighbours mostly have the same.
pub(super) struct Materials(u16, Material);

impl Materials {
    /// None asked for yet: the number is no material's.
    pub(super) const NONE: Self = Self(u16::MAX, Material::PLAIN);

    /// A material of the scene.
    #[inline(always)]
    pub(super) fn get(&mut self, scene: &Scene<'_>, number: u16) -> &Material {
        let Self(known, material) = self;
        if *known != number {
            (*known, *material) = (number, scene.material(number));
        }
        material
    }
}

impl Tracer<'_> {
    /// What a ray from a viewport's camera shows; `false`: the background. Only `listed`
    /// actors are looked at, if they are listed, or `only` what was gathered. `met` is
    /// filled with the nearest.
    pub(super) fn camera(
        &mut self,
        ray: &Ray,
        view: (u16, &RayCamera),
        listed: Option<&[u16]>,
        only: Option<Candidates<'_>>,
        met: &mut Met,
    ) -> bool {
        match only {
            Some(only) => self.seen_of(ray, view, only, met),
            None => self.seen(ray, view, listed, met),
        }
        met.is_something()
    }

    /// The light of what a ray from a viewport's camera has met.
    #[inline(always)]
    pub(super) fn shown(&mut self, ray: &Ray, met: &Met, seed: Seed) -> Option<Shown> {
        let which = self.actors.get(met.actor)?;
        let (optics, mesh) = (which.optics, which.mesh);
        let triangle = met.triangle();
        let triangle = triangle.map(|(meshlet, triangle)| (mesh, meshlet, triangle));
        let local = self.local(ray, met, seed, OF_CAMERA);
        let local = local.as_ref()?;
        let light = if optics.reflectivity == 0 && optics.opacity >= ONE {
            Light::Own(local.number, local.lit, local.base)
        } else {
            Light::Mixed(self.go_on(ray, local, met, seed))
        };
        Some(Shown {
            actor: met.actor,
            distance: met.distance,
            triangle,
            lights: local.lights,
            light,
        })
    }

    /// The nearest that a ray from a viewport's camera meets.
    #[inline(never)]
    fn seen(
        &mut self,
        ray: &Ray,
        (viewport, camera): (u16, &RayCamera),
        listed: Option<&[u16]>,
        best: &mut Met,
    ) {
        for which in 0..listed.map_or(self.actors.count(), |listed| listed.len() as u16) {
            let number = match listed {
                Some(listed) => listed.get(usize::from(which)).copied().unwrap_or(0),
                None if self.actors.passes_by(which, ray) => continue,
                None => which,
            };
            let Some((actor, from)) = self.actors.seen(number, viewport, camera) else {
                break;
            };
            let of_parallel = match camera.eye() {
                None if !actor.is_exact() => actor.place(ray.origin),
                _ => None,
            };
            let from = of_parallel.as_ref().or(from);
            let parts = Parts {
                of: Candidates::ALL,
                left: &mut self.windows.left,
                kept: self.facet,
            };
            actor.meet(self.scene, ray, from, parts, best);
        }
    }

    /// The nearest of what was gathered.
    #[inline(never)]
    fn seen_of(
        &mut self,
        ray: &Ray,
        (viewport, camera): (u16, &RayCamera),
        only: Candidates<'_>,
        best: &mut Met,
    ) {
        let mut left = only;
        while let Some((number, own)) = left.next_actor() {
            let Some((actor, from)) = self.actors.seen(number, viewport, camera) else {
                break;
            };
            let parts = Parts {
                of: own,
                left: &mut self.windows.left,
                kept: self.facet,
            };
            actor.meet(self.scene, ray, from, parts, best);
        }
    }

    /// The nearest of all actors.
    #[inline(never)]
    pub(super) fn nearest(&mut self, ray: &Ray, best: &mut Met) {
        let mut candidates = self.actors.candidates(ray, 0);
        while let Some(next) = candidates.next() {
            let Some(actor) = self.actors.candidate(next, ray, best.distance) else {
                continue;
            };
            let from = if actor.is_exact() {
                None
            } else {
                actor.place(ray.origin)
            };
            let parts = Parts {
                of: Candidates::ALL,
                left: &mut self.windows.left,
                kept: self.facet,
            };
            actor.meet(self.scene, ray, from.as_ref(), parts, best);
        }
    }

    /// The surface that a ray has met, by itself; see [`LitPoint`] for `spread`.
    #[inline(never)]
    pub(super) fn local(&mut self, ray: &Ray, met: &Met, seed: Seed, spread: u32) -> Option<Local> {
        let actor = self.actors.get(met.actor)?;
        let number = actor.material;
        let material = self.materials.get(self.scene, number);
        let goes_on = actor.optics != Optics::PLAIN;
        let need = || Need {
            place: self.needs_places || goes_on,
            face: self.settings.shadows || goes_on,
            flat: material.shading == Shading::Flat,
        };
        let surface = actor.surface_at(self.scene, ray, met, (need, self.facet));
        let surface = surface.as_ref()?;
        let (mesh, exact) = (actor.mesh, actor.is_exact());
        let lit = LitPoint {
            surface,
            material,
            eye: shorten(ray.direction.map(|c| -c)),
            lift: if self.settings.shadows {
                actor.lift(met.distance)
            } else {
                0
            },
            distance: met.distance,
            spread,
            on: if exact { met.actor + 1 } else { 0 },
            source: (spread == OF_CAMERA).then_some(met.actor),
        };
        let mut shadows = Shadows {
            scene: self.scene,
            actors: &mut self.actors,
            windows: self.windows,
            shades: self.shades,
        };
        let (parts, lights) = shine((self.lights, &self.settings), &mut shadows, &lit, seed);
        let (lit, base) = match (material.texture, surface.coordinates) {
            (Some(texture), Some(place)) => {
                textured(self.scene, (material, texture), (mesh, place), parts)
            }
            _ => (sum(parts.body, parts.gloss), None),
        };
        let facing = goes_on.then(|| {
            let facing = Facing::new(surface, ray.direction);
            (facing, surface.place, surface.back)
        });
        Some(Local {
            number,
            base,
            lit,
            lights,
            facing,
        })
    }

    /// The colour of a surface by itself.
    #[inline(always)]
    pub(super) fn colour(&mut self, local: &Local) -> Lit {
        self.rgb(local.number, local.lit, local.base)
    }

    /// Light of a material as red, green and blue, where it goes by level too.
    pub(super) fn rgb(&mut self, material: u16, lit: Lit, base: Option<u8>) -> Lit {
        let material = self.materials.get(self.scene, material);
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
}

/// Light on a material's texture; of one that goes by level its base colour.
#[inline(never)]
fn textured(
    scene: &Scene<'_>,
    (material, texture): (&Material, u8),
    (mesh, place): (u16, [i32; 2]),
    parts: light::Parts,
) -> (Lit, Option<u8>) {
    let plain = (sum(parts.body, parts.gloss), None);
    let (Some(texture), Some(own)) = (scene.texture(texture), scene.mesh(mesh).coordinates) else {
        return plain;
    };
    let sampler = Sampler::new(scene, texture, own);
    let (picture, place) = sampler.point(place);
    if material.coloured {
        match sampler.colour(&picture, place) {
            Some(texel) => (on_texel(parts, texel), None),
            None => plain,
        }
    } else {
        let base = sampler.nearest(&picture, place).unwrap_or(NO_TEXEL);
        (sum(parts.body, parts.gloss), Some(base % BASES as u8))
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
