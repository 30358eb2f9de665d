//! Light over a surface.

use core::ops::Range;

use crate::light::{Lit, Parts, SurfaceLights, sum};
use crate::math::direction;
use crate::raster::RUN_FRACTION;
use crate::scene::{Material, Shading};

/// Which attributes a surface interpolates, in this order.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Attributes {
    /// Texture coordinates: two attributes.
    pub textured: bool,
    /// How it is lit.
    pub lighting: Lighting,
    /// Highlights by themselves after a colour: three.
    pub glossy: bool,
    /// Vertex colours after a normal and a place: three.
    pub tinted: bool,
}

/// What is interpolated of light.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Lighting {
    /// Nothing: one light a face.
    Face,
    /// A level: one attribute.
    Level,
    /// A colour: three.
    Colour,
    /// The normal and the place, three each: light is worked out at each pixel.
    Pixel,
}

impl Attributes {
    /// Those of a material on a mesh that has vertex colours or not.
    pub fn new(material: &Material, tinted: bool) -> Self {
        let lighting = match material.shading {
            Shading::Flat => Lighting::Face,
            Shading::Gouraud if material.coloured => Lighting::Colour,
            Shading::Gouraud => Lighting::Level,
            Shading::Phong => Lighting::Pixel,
        };
        let textured = cfg!(feature = "texture") && material.texture.is_some();
        let shiny = material.channels.specular != [0; 3];
        Self {
            textured,
            lighting,
            glossy: textured && shiny && lighting == Lighting::Colour,
            tinted: tinted && lighting == Lighting::Pixel,
        }
    }

    /// How many there are.
    pub fn count(&self) -> usize {
        let light = match self.lighting {
            Lighting::Face => 0,
            Lighting::Level => 1,
            Lighting::Colour => 3,
            Lighting::Pixel => 6,
        };
        let more = if self.tinted || self.glossy { 3 } else { 0 };
        self.before_light() + light + more
    }

    /// How many come before those of light.
    pub fn before_light(&self) -> usize {
        if self.textured { 2 } else { 0 }
    }
}

/// A surface's light, pixel by pixel.
#[derive(Debug)]
pub struct Surface<'a> {
    /// What is interpolated.
    pub attributes: Attributes,
    /// What lights it, if its faces or pixels are lit.
    pub lights: Option<&'a SurfaceLights>,
}

impl Surface<'_> {
    /// Light where the attributes are `values`; `face` is the face's, if it has one.
    #[inline(always)]
    pub fn light<const N: usize>(&self, values: &[i32; N], face: Parts) -> Parts {
        let first = self.attributes.before_light();
        // One by one: a copy of them would be made in memory.
        let own = |which| values.get(first + which).copied().unwrap_or(0);
        let three = |from| [own(from), own(from + 1), own(from + 2)];
        match self.attributes.lighting {
            Lighting::Face => face,
            Lighting::Level => body([channel(own(0)); 3]),
            Lighting::Colour => Parts {
                body: three(0).map(channel),
                gloss: if self.attributes.glossy {
                    three(3).map(channel)
                } else {
                    [0; 3]
                },
            },
            Lighting::Pixel => {
                let tint = if self.attributes.tinted {
                    three(6)
                } else {
                    [0; 3]
                };
                self.lit(three(0), three(3), tint)
            }
        }
    }

    /// The same of attributes that are there whether or not they differ: three of a colour, or
    /// nine of what is lit at each pixel; after texture coordinates six of a colour and its
    /// highlight, or the nine.
    #[inline(always)]
    pub fn light_of_all<const N: usize>(&self, values: &[i32; N]) -> Parts {
        match *values.as_slice() {
            [a, b, c] => body([a, b, c].map(channel)),
            [_, _, a, b, c, d, e, f] => Parts {
                body: [a, b, c].map(channel),
                gloss: [d, e, f].map(channel),
            },
            [a, b, c, d, e, f, r, g, u] | [_, _, a, b, c, d, e, f, r, g, u] => {
                self.lit([a, b, c], [d, e, f], [r, g, u])
            }
            _ => Parts::default(),
        }
    }

    /// By how much it may differ between corners with such attributes, in 1/64 of a level, at
    /// most 255 of them, but for what normals do.
    #[inline(always)]
    pub fn contrast<const N: usize>(&self, corners: &[[i32; N]; 3]) -> u32 {
        let first = self.attributes.before_light();
        let own = |from, to| most_difference(corners, first + from..first + to);
        let differ = match (self.attributes.lighting, self.lights) {
            (Lighting::Face, _) => 0,
            (Lighting::Pixel, Some(lights)) => {
                let [a, ..] = corners;
                let place =
                    |which: usize| a.get(first + which).map_or(0, |c: &i32| c >> RUN_FRACTION);
                lights.contrast([3, 4, 5].map(place), own(3, 6)) + own(6, 9)
            }
            // A colour, and its highlight if there is room for it.
            _ if N > 6 => own(0, 3) + own(3, 6),
            _ => own(0, 3),
        };
        differ.min(255 << 6)
    }

    /// Light of a pixel by itself.
    #[inline(always)]
    fn lit(&self, normal: [i32; 3], place: [i32; 3], tint: [i32; 3]) -> Parts {
        // Whatever length is left of the interpolated normal.
        let normal = direction(normal).map_or([0; 3], |(unit, _)| unit);
        let place = place.map(|c| c >> RUN_FRACTION);
        let byte = |c: i32| (c >> (RUN_FRACTION + 6)).clamp(0, 255) as u8;
        let tint = self.attributes.tinted.then(|| tint.map(byte));
        self.lights
            .map_or(Parts::default(), |lights| lights.parts(normal, place, tint))
    }
}

/// By how much one of some attributes differs from corner to corner, without fractional bits.
#[inline(never)]
fn most_difference<const N: usize>([a, b, c]: &[[i32; N]; 3], range: Range<usize>) -> u32 {
    let mut most = 0;
    let all = a.iter().zip(b).zip(c);
    for ((a, b), c) in all.take(range.end).skip(range.start) {
        most = most.max(a.max(b).max(c).abs_diff(*a.min(b).min(c)));
    }
    most >> RUN_FRACTION
}

/// Light without highlights of its own.
fn body(body: Lit) -> Parts {
    Parts {
        body,
        gloss: [0; 3],
    }
}

/// Light on a texel whose channels are 0..=255.
#[inline(always)]
pub fn on_texel(light: Parts, texel: [u32; 3]) -> Lit {
    let mut body = light.body;
    for (c, t) in body.iter_mut().zip(texel) {
        // 255 is 1.
        *c = ((u32::from(*c) * (t + (t >> 7)) + (1 << 7)) >> 8) as u16;
    }
    sum(body, light.gloss)
}

/// A channel, rounded; interpolation may leave its range by a rounding.
#[inline(always)]
pub fn channel(value: i32) -> u16 {
    const HALF: i32 = 1 << (RUN_FRACTION - 1);
    (value.saturating_add(HALF) >> RUN_FRACTION).clamp(0, 255 << 6) as u16
}
