//! Lights as one meshlet meets them, and what they give at a point.
//!
//! The model is the classic one (Phong, "Illumination for computer generated
//! pictures", 1975), on display-encoded values as OpenGL and VTK compute it:
//! `constant + sum of factor * L * (diffuse * N.l + specular * (R.v)^power)`.

use super::Patch;
use crate::math::{
    Scaled, ShortUnit, Vec3, direction, power, scaled_reciprocal, short_dot, square_root,
};
use crate::scene::layout::LIGHTS;
use crate::scene::{Channels, Light, LightKind, Material, Scene};
use crate::view::{ActorView, EyeInGrid};

/// Red, green and blue in 1/64 of a level, at most 255 levels. Of a material that
/// goes by level the first is the level.
pub type Lit = [u16; 3];

/// Light that a surface gives back.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Parts {
    /// In its own colour.
    pub body: Lit,
    /// Highlights.
    pub gloss: Lit,
}

/// The sum of two lights, each channel held to what it holds.
pub fn sum(a: Lit, b: Lit) -> Lit {
    let mut sum = [0; 3];
    for (sum, (a, b)) in sum.iter_mut().zip(a.into_iter().zip(b)) {
        *sum = (a + b).min(FULL as u16);
    }
    sum
}

/// The most that a channel holds.
const FULL: u32 = 255 << 6;
/// 1 as light sums have it; they are held to 64.
const ONE_BITS: u32 = 14;
const MOST: u32 = 64 << ONE_BITS;

/// What reaches a meshlet's surface.
#[derive(Clone, Copy, Debug)]
pub struct SurfaceLights {
    channels: Channels,
    shiny: bool,
    power: u16,
    sources: [Source; LIGHTS],
    count: usize,
    eye: Seen,
}

/// Towards the eye.
#[derive(Clone, Copy, Debug)]
enum Seen {
    Along(ShortUnit),
    From([i32; 3]),
}

/// One light.
#[derive(Clone, Copy, Debug)]
pub(super) struct Source {
    pub(super) kind: LightKind,
    /// To a directional light, or against a spot's axis.
    pub(super) towards: ShortUnit,
    /// In units of the patch, from its base.
    pub(super) place: [i32; 3],
    /// Colour times intensity, 12 fractional bits.
    pub(super) colour: [u32; 3],
    /// By distance in units of the patch.
    attenuation: [Scaled; 3],
    /// Of a light that is the same at all distances, its factor, 14 fractional bits;
    /// 0 of others.
    even: u32,
    cone: i32,
    exponent: u16,
}

impl Source {
    pub(super) const NONE: Self = Self {
        kind: LightKind::Directional,
        towards: [0; 3],
        place: [0; 3],
        colour: [0; 3],
        attenuation: [Scaled::ZERO; 3],
        even: 0,
        cone: 0,
        exponent: 0,
    };

    fn new(light: &Light, view: &ActorView, patch: &Patch) -> Self {
        let place = view.model.place(Vec3::from_bits(light.position));
        let step = view.model.step();
        let unit = Scaled::new(step.mantissa(), step.exponent() + patch.shift as i32);
        let towards = shorten(view.model.direction(light.towards));
        Self::at(light, towards, in_patch(place, patch), unit)
    }

    /// A light whose place is in units of so many world units.
    pub(super) fn at(light: &Light, towards: ShortUnit, place: [i32; 3], unit: Scaled) -> Self {
        let [constant, linear, quadratic] = light.attenuation;
        let even = linear == Scaled::ZERO && quadratic == Scaled::ZERO;
        Self {
            kind: light.kind,
            towards,
            place,
            colour: light.colour.map(|c| c >> 4),
            attenuation: [
                constant,
                linear.times(unit),
                quadratic.times(unit).times(unit),
            ],
            even: if even { factor(constant) } else { 0 },
            // 28 fractional bits.
            cone: light.cone >> 2,
            exponent: light.exponent,
        }
    }

    /// The direction to the light at a place, and the factor of its light there, 14
    /// fractional bits; `None` where none gets to.
    #[inline(always)]
    fn reaches(&self, place: [i32; 3]) -> Option<(ShortUnit, u32)> {
        self.reaches_from(self.place, place)
    }

    /// The same for a light that shines from elsewhere.
    #[inline(always)]
    pub(super) fn reaches_from(&self, from: [i32; 3], place: [i32; 3]) -> Option<(ShortUnit, u32)> {
        if self.kind == LightKind::Directional {
            return Some((self.towards, 1 << ONE_BITS));
        }
        let ([ax, ay, az], [bx, by, bz]) = (from, place);
        let (towards, distance) = direction([ax - bx, ay - by, az - bz])?;
        let factor = if self.even != 0 {
            self.even
        } else {
            let [constant, linear, quadratic] = self.attenuation;
            let sum = linear.plus(quadratic.times(distance)).times(distance);
            factor(constant.plus(sum))
        };
        if self.kind == LightKind::Point {
            return Some((towards, factor));
        }
        let cosine = short_dot(towards, self.towards);
        if cosine < self.cone {
            return None;
        }
        let beam = power(cosine.unsigned_abs(), self.exponent);
        Some((towards, scale(factor, beam)))
    }
}

/// The factor of an attenuation, 14 fractional bits.
fn factor(attenuation: Scaled) -> u32 {
    scaled_reciprocal(attenuation).fixed(ONE_BITS).min(MOST)
}

/// What several lights give.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Sums {
    diffuse: [u32; 3],
    specular: [u32; 3],
}

impl Sums {
    /// Adds a light that comes from `towards` by a factor; with an `eye`, its highlight.
    #[inline(always)]
    pub(super) fn add(
        &mut self,
        source: &Source,
        normal: ShortUnit,
        (towards, factor): (ShortUnit, u32),
        eye: Option<ShortUnit>,
        sharpness: u16,
    ) {
        let cosine = short_dot(normal, towards);
        if cosine <= 0 {
            return;
        }
        let weight = scale(factor, cosine.unsigned_abs() >> ONE_BITS);
        for (sum, colour) in self.diffuse.iter_mut().zip(source.colour) {
            *sum += scale(colour << 2, weight);
        }
        if let Some(eye) = eye {
            // R.v = 2 (N.l) (N.v) - l.v
            let facing = short_dot(normal, eye) >> ONE_BITS;
            let mirrored = 2 * (cosine >> ONE_BITS) * facing - short_dot(towards, eye);
            let weight = scale(factor, power(mirrored.max(0).unsigned_abs(), sharpness));
            for (sum, colour) in self.specular.iter_mut().zip(source.colour) {
                *sum += scale(colour << 2, weight);
            }
        }
    }

    /// What a material gives back of it.
    #[inline(always)]
    pub(super) fn parts(&self, channels: &Channels, shiny: bool, tint: Option<[u8; 3]>) -> Parts {
        let Channels {
            constant,
            diffuse: kd,
            specular: ks,
        } = *channels;
        let (mut body, mut gloss) = ([0; 3], [0; 3]);
        for (which, (body, gloss)) in body.iter_mut().zip(&mut gloss).enumerate() {
            let of = |all: [u16; 3]| u32::from(all.get(which).copied().unwrap_or(0));
            let sum = |all: [u32; 3]| all.get(which).copied().unwrap_or(0).min(MOST);
            let mut level = of(constant) + part(of(kd), sum(self.diffuse));
            if let Some(tint) = tint {
                let tint = u32::from(tint.get(which).copied().unwrap_or(255));
                // 255 is 1.
                level = (level.min(FULL << 6) * (tint + (tint >> 7)) + (1 << 7)) >> 8;
            }
            *body = level.min(FULL) as u16;
            if shiny {
                *gloss = part(of(ks), sum(self.specular)).min(FULL) as u16;
            }
        }
        Parts { body, gloss }
    }
}

/// To 14 fractional bits.
pub(super) fn shorten(v: [i32; 3]) -> ShortUnit {
    v.map(|c| (c + (1 << 15)) >> 16)
}

/// Grid steps from the grid's centre in units of a patch from its base; held to
/// 2^29, so that differences fit.
fn in_patch(place: [i64; 3], patch: &Patch) -> [i32; 3] {
    let mut out = [0; 3];
    for (out, (c, base)) in out.iter_mut().zip(place.into_iter().zip(patch.base)) {
        let units = (c - i64::from(base)) >> patch.shift.min(31);
        *out = units.clamp(-(1 << 29), 1 << 29) as i32;
    }
    out
}

/// `a * b` with 14 fractional bits each.
#[inline(always)]
fn scale(a: u32, b: u32) -> u32 {
    if a <= 1 << 17 && b <= 1 << 14 {
        return (a * b) >> ONE_BITS;
    }
    ((u64::from(a) * u64::from(b)) >> ONE_BITS).min(u64::from(MOST)) as u32
}

impl SurfaceLights {
    /// None.
    pub const NONE: Self = Self {
        channels: Material::PLAIN.channels,
        shiny: false,
        power: 0,
        sources: [Source::NONE; LIGHTS],
        count: 0,
        eye: Seen::Along([0; 3]),
    };

    /// Becomes the scene's lights as the surface of a meshlet meets them: in place,
    /// because they are half a kilobyte.
    #[inline(never)]
    pub fn set(&mut self, scene: &Scene<'_>, view: &ActorView, patch: &Patch) {
        let found = scene.lights();
        self.channels = view.material.channels;
        self.shiny = self.channels.specular != [0; 3];
        self.power = view.material.power;
        self.count = found.len().min(LIGHTS);
        self.eye = match view.eye {
            EyeInGrid::Direction(sight) => Seen::Along(shorten(sight.map(i32::wrapping_neg))),
            EyeInGrid::Point(place) => Seen::From(in_patch(place, patch)),
        };
        for (source, light) in self.sources.iter_mut().zip(found) {
            *source = Source::new(&light, view, patch);
        }
    }

    /// Light at `place` on a surface with `normal`, whose ambient and diffuse colours
    /// are multiplied by `tint` if there is one.
    pub fn shine(&self, normal: ShortUnit, place: [i32; 3], tint: Option<[u8; 3]>) -> Lit {
        let Parts { body, gloss } = self.parts(normal, place, tint);
        sum(body, gloss)
    }

    /// The same, highlights by themselves: a texture leaves them as they are.
    #[inline(never)]
    pub fn parts(&self, normal: ShortUnit, place: [i32; 3], tint: Option<[u8; 3]>) -> Parts {
        let mut sums = Sums::default();
        for source in self.sources.iter().take(self.count) {
            let Some((towards, factor)) = source.reaches(place) else {
                continue;
            };
            let eye = self.shiny.then(|| self.towards_eye(place));
            sums.add(source, normal, (towards, factor), eye, self.power);
        }
        sums.parts(&self.channels, self.shiny, tint)
    }

    /// By how much light may differ between places that have the same normal and are so far
    /// apart, in 1/64 of a level.
    pub fn contrast(&self, place: [i32; 3], apart: u32) -> u32 {
        // 12 fractional bits. Largest differences are up to the root of 3 off lengths.
        let angle = |to: [i32; 3]| {
            let far = to.iter().zip(place).map(|(to, c)| to.abs_diff(c));
            let angle = (apart << 12).checked_div(far.fold(0, u32::max));
            angle.unwrap_or(FULL).min(FULL)
        };
        // A cosine's power changes with the angle by 0.61 of the power's root at most: with
        // the root of 3, by the power's root. Of its 8 fractional bits, 4 are left.
        let highlight = if self.shiny {
            square_root(self.power.into())
        } else {
            0
        };
        let mut sum = match self.eye {
            Seen::From(eye) if self.shiny => angle(eye) * highlight * self.count as u32,
            _ => 0,
        };
        for source in self.sources.iter().take(self.count) {
            match source.kind {
                LightKind::Directional => {}
                // A cosine changes by 1, what falls off with distance by 2.
                LightKind::Point => sum += angle(source.place) * ((6 << 4) + highlight),
                // Its cone may end between them.
                LightKind::Spot => return FULL,
            }
        }
        (sum >> 2).min(FULL)
    }

    fn towards_eye(&self, place: [i32; 3]) -> ShortUnit {
        match self.eye {
            Seen::Along(direction) => direction,
            Seen::From([ex, ey, ez]) => {
                let [x, y, z] = place;
                direction([ex - x, ey - y, ez - z]).map_or([0; 3], |(unit, _)| unit)
            }
        }
    }
}

/// A coefficient of up to 14 bits times a sum of light; rounded to nearest.
fn part(coefficient: u32, sum: u32) -> u32 {
    // 14 bits and 18.
    let product = coefficient.wrapping_mul(sum >> 2);
    product.wrapping_add(1 << 11) >> (ONE_BITS - 2)
}
