//! From a ray to a colour.

use super::actors::RayActors;
use super::bounce::Facing;
use super::camera::RayCamera;
use super::follow::WaitingRays;
use super::gather::Candidates;
use super::light::{Lit as LitPoint, RayLights, Seed, shine, shorten};
use super::nearest::Met;
use super::ray::Ray;
use super::surface::Need;
use super::windows::Windows;
use crate::light::{Lit, Parts, sum};
use crate::palette::Palette;
use crate::scene::NO_TEXEL;
use crate::scene::layout::BASES;
use crate::scene::{Gradient, Material, Optics, RaySettings, Scene, Shading};
use crate::shade::{Lookup, Sampler, on_texel};

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
    /// The last one that was asked for, with its number.
    pub material: Option<(u16, Material)>,
    pub settings: RaySettings,
    pub palette: Palette<'a>,
    pub background: Gradient<'a>,
}

/// A surface by itself.
pub(super) struct Local {
    /// The material's number.
    number: u16,
    material: Material,
    /// Where its colour goes through a texture by level: the base colour.
    base: Option<u8>,
    lit: Lit,
    lights: u8,
    /// If light goes on from it: the sides that face the ray, the place, and whether it is
    /// seen from behind.
    pub facing: Option<(Facing, [i32; 3], bool)>,
}

impl Tracer<'_> {
    /// What a ray from a viewport's camera shows; `None`: the background. Only `listed`
    /// actors are looked at, if they are listed, and of their triangles `only` some.
    pub(super) fn camera(
        &mut self,
        ray: &Ray,
        view: (u16, &RayCamera),
        listed: Option<&[u16]>,
        only: Option<Candidates<'_>>,
        seed: Seed,
    ) -> Option<Shown> {
        let (actor, met) = self.seen(ray, view, listed, only)?;
        let which = self.actors.get(actor)?;
        let (optics, mesh) = (which.optics, which.mesh);
        let triangle = met.triangle();
        let triangle = triangle.map(|(meshlet, triangle)| (mesh, meshlet, triangle));
        let local = self.local(ray, actor, &met, seed)?;
        let light = if optics.reflectivity == 0 && optics.opacity >= ONE {
            Light::Own(local.number, local.lit, local.base)
        } else {
            Light::Mixed(self.go_on(ray, actor, &local, &met, seed))
        };
        Some(Shown {
            actor,
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
        only: Option<Candidates<'_>>,
    ) -> Option<(u16, Met)> {
        let mut best: Option<(u16, Met)> = None;
        let mut far = ray.far;
        for which in 0..listed.map_or(self.actors.count(), |listed| listed.len() as u16) {
            let number = match listed {
                Some(listed) => *listed.get(usize::from(which))?,
                None => which,
            };
            let seen = self.actors.seen(number, viewport, camera, ray.origin);
            let Some((actor, from, beyond_near)) = seen else {
                break;
            };
            let near = if beyond_near { 0 } else { ray.near };
            if let Some(met) = actor.meet(self.scene, ray, from, (near, far), only) {
                far = met.distance;
                best = Some((number, met));
            }
        }
        best
    }

    /// The nearest of all actors.
    #[inline(never)]
    pub(super) fn nearest(&mut self, ray: &Ray) -> Option<(u16, Met)> {
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
            if let Some(met) = actor.meet(self.scene, ray, from, (ray.near, far), None) {
                far = met.distance;
                best = Some((next.0, met));
            }
        }
        best
    }

    #[inline(never)]
    pub(super) fn local(&mut self, ray: &Ray, number: u16, met: &Met, seed: Seed) -> Option<Local> {
        let number_of_material = self.actors.get(number)?.material;
        let material = self.material(number_of_material);
        let actor = self.actors.get(number)?;
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
            (self.lights, &self.settings),
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
            number: number_of_material,
            material,
            base,
            lit,
            lights,
            facing,
        })
    }

    /// A material: neighbours mostly have the same.
    #[inline(always)]
    pub(super) fn material(&mut self, number: u16) -> Material {
        if let Some((known, material)) = &self.material
            && *known == number
        {
            return *material;
        }
        let material = self.scene.material(number);
        self.material = Some((number, material));
        material
    }

    /// Light on the material's texture; of one that goes by level its base colour.
    #[inline(never)]
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

    /// The colour of a surface by itself.
    pub(super) fn colour(&self, local: &Local) -> Lit {
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
}

/// A material's way to an index.
pub(super) fn lookup<'a>(scene: &Scene<'a>, material: &Material, base: Option<u8>) -> Lookup<'a> {
    match base {
        _ if material.coloured => Lookup::Colours(scene.colours()),
        Some(base) => Lookup::Texel(scene.texture_shades(material), base),
        None => Lookup::Levels(scene.shade(material)),
    }
}
