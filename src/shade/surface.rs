//! Light over a surface.

use crate::light::{Lit, SurfaceLights};
use crate::math::direction;
use crate::raster::{RUN_FRACTION, Values};
use crate::scene::{Material, Shading};

/// Which attributes a surface interpolates, in this order.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Attributes {
    /// How it is lit.
    pub lighting: Lighting,
    /// Whether vertex colours come after a normal and a place.
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
        Self {
            lighting,
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
        if self.tinted { light + 3 } else { light }
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
    pub fn light(&self, values: &Values, face: Lit) -> Lit {
        let [a, b, c, d, e, f, r, g, u, ..] = *values;
        match self.attributes.lighting {
            Lighting::Face => face,
            Lighting::Level => [channel(a); 3],
            Lighting::Colour => [channel(a), channel(b), channel(c)],
            Lighting::Pixel => {
                // Whatever length is left of the interpolated normal.
                let normal = direction([a, b, c]).map_or([0; 3], |(unit, _)| unit);
                let place = [d, e, f].map(|c| c >> RUN_FRACTION);
                let byte = |c: i32| (c >> (RUN_FRACTION + 6)).clamp(0, 255) as u8;
                let tint = self.attributes.tinted.then(|| [r, g, u].map(byte));
                self.lights
                    .map_or([0; 3], |lights| lights.shine(normal, place, tint))
            }
        }
    }
}

/// A channel, rounded; interpolation may leave its range by a rounding.
#[inline(always)]
fn channel(value: i32) -> u16 {
    const HALF: i32 = 1 << (RUN_FRACTION - 1);
    (value.saturating_add(HALF) >> RUN_FRACTION).clamp(0, 255 << 6) as u16
}
