//! What a pixel's index means: the scene's colours, or for picking, measuring
//! and debugging something else, through the same kernels.

use crate::fog::{self, Haze};
use crate::frame::{Stored, Target};
use crate::math::Level;
use crate::raster::{Fill, How};
use crate::scene::{Dither, Scene};
use crate::shade::{Blend, Pixel, blended, dithered};
use crate::vertex::ScreenVertex;

/// Whose pixel it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Ids {
    /// The actor.
    pub actor: u16,
    /// The triangle's place in the scene's list, an edge's with [`Ids::EDGE`] added,
    /// or a vertex's with [`Ids::POINT`].
    pub triangle: u32,
}

impl Ids {
    /// An edge; see [`Ids::triangle`].
    pub const EDGE: u32 = 1 << 30;
    /// A vertex; see [`Ids::triangle`].
    pub const POINT: u32 = 1 << 31;
}

/// Chooses a triangle's fill.
pub trait Paint: Copy {
    /// What a pixel of the band holds.
    type Stored: Stored;

    /// Whether the scene's fog lies over it.
    const FOGGED: bool = false;

    /// Of a triangle of palette indices: `shades` is the material's row of the shade table;
    /// `flat` the face's level if it has one.
    fn fill<'a>(&self, shades: &'a [u8; 256], flat: Option<Level>, ids: Ids) -> Fill<'a>;

    /// Of a face that shows the background and hides what is behind it.
    fn hidden<'a>(&self, ids: Ids) -> Fill<'a>;

    /// What is where nothing is drawn, given the scene's index.
    fn background(&self, index: u8) -> Self::Stored;

    /// A surface's pixel.
    fn surface(&self, pixel: &Pixel<'_>, ids: Ids) -> Self::Stored;

    /// A pixel of a surface through which `behind` shows. Who asks for what
    /// is there gets what hides the rest: such a surface hides nothing.
    fn blend(&self, _: &Pixel<'_>, behind: Self::Stored, _: &Blend<'_>) -> Self::Stored {
        behind
    }

    /// Fogs what was drawn, if [`Paint::FOGGED`].
    fn fog(&self, _: &mut Target<'_, Self::Stored>, _: &Scene<'_>, _: &Haze) {}

    /// Told, by those who count what a frame takes, of a meshlet's vertices when they are
    /// transformed.
    #[inline(always)]
    fn transformed(&self, _actor: u16, _vertices: u8) {}

    /// The same of a triangle, or a part of one, after its pixels in a target.
    #[inline(always)]
    fn drawn<C>(&self, _: &Target<'_, C>, _: [&ScreenVertex; 3], _: How, _: Ids) {}

    /// The same of a line before it is drawn.
    #[inline(always)]
    fn line<C>(&self, _: &Target<'_, C>, _: [&ScreenVertex; 2], _: Ids) {}
}

/// The scene as it looks.
#[derive(Clone, Copy, Debug)]
pub struct Shaded {
    /// How colours between palette entries are shown; see [`Scene::dither`](crate::Scene::dither).
    pub dither: Dither,
}

impl Paint for Shaded {
    type Stored = u8;

    const FOGGED: bool = true;

    #[inline(always)]
    fn fill<'a>(&self, shades: &'a [u8; 256], flat: Option<Level>, _: Ids) -> Fill<'a> {
        match flat {
            #[expect(clippy::indexing_slicing, reason = "a byte indexes 256 entries")]
            Some(level) => Fill::Flat(shades[usize::from(level)]),
            None => Fill::Gouraud(shades),
        }
    }

    #[inline(always)]
    fn hidden<'a>(&self, _: Ids) -> Fill<'a> {
        Fill::Depth
    }

    #[inline(always)]
    fn background(&self, index: u8) -> u8 {
        index
    }

    #[inline(always)]
    fn surface(&self, pixel: &Pixel<'_>, _: Ids) -> u8 {
        dithered(pixel, self.dither)
    }

    #[inline(always)]
    fn blend(&self, pixel: &Pixel<'_>, behind: u8, blend: &Blend<'_>) -> u8 {
        blended(pixel, behind, blend, self.dither)
    }

    #[inline(always)]
    fn fog(&self, target: &mut Target<'_>, scene: &Scene<'_>, haze: &Haze) {
        if let Some(table) = scene.fog_table() {
            fog::apply(target, table, &haze.depths);
        }
    }
}

/// The light itself, 0 where nothing is: the level, or of a material that goes by
/// colour one channel.
#[derive(Clone, Copy, Debug)]
pub struct PaintLight {
    /// 0: red, 1: green, 2: blue.
    pub channel: u8,
}

/// Each level as it is.
const LEVELS: &[u8; 256] = &levels();

const fn levels() -> [u8; 256] {
    let mut table = [0; 256];
    let mut i = 0;
    while i < 256 {
        #[expect(clippy::indexing_slicing, reason = "evaluated by the compiler")]
        {
            table[i] = i as u8;
        }
        i += 1;
    }
    table
}

impl Paint for PaintLight {
    type Stored = u8;

    fn fill<'a>(&self, _: &'a [u8; 256], flat: Option<Level>, _: Ids) -> Fill<'a> {
        flat.map_or(Fill::Gouraud(LEVELS), Fill::Flat)
    }

    fn hidden<'a>(&self, _: Ids) -> Fill<'a> {
        Fill::Flat(0)
    }

    fn background(&self, _: u8) -> u8 {
        0
    }

    fn surface(&self, pixel: &Pixel<'_>, _: Ids) -> u8 {
        let channel = pixel.lit.get(usize::from(self.channel)).copied();
        ((channel.unwrap_or(0) + 32) >> 6) as u8
    }
}

/// One byte of where in a texture a pixel is, in 2^-16 texels of the picture; 0 where
/// there is no texture.
#[derive(Clone, Copy, Debug)]
pub struct PaintTexel {
    /// 0: across, 1: down.
    pub axis: u8,
    /// 0: the lowest byte.
    pub byte: u8,
}

impl Paint for PaintTexel {
    type Stored = u8;

    fn fill<'a>(&self, _: &'a [u8; 256], _: Option<Level>, _: Ids) -> Fill<'a> {
        Fill::Flat(0)
    }

    fn hidden<'a>(&self, _: Ids) -> Fill<'a> {
        Fill::Flat(0)
    }

    fn background(&self, _: u8) -> u8 {
        0
    }

    fn surface(&self, pixel: &Pixel<'_>, _: Ids) -> u8 {
        let place = pixel.texel.get(usize::from(self.axis)).copied();
        byte_of(place.unwrap_or(0) as u32, self.byte)
    }
}

/// One byte of the actor's number, 0 where nothing is (see depth).
#[derive(Clone, Copy, Debug)]
pub struct PaintActor {
    /// 0: the lowest byte.
    pub byte: u8,
}

impl Paint for PaintActor {
    type Stored = u8;

    fn fill<'a>(&self, _: &'a [u8; 256], _: Option<Level>, ids: Ids) -> Fill<'a> {
        Fill::Flat(byte_of(u32::from(ids.actor), self.byte))
    }

    fn hidden<'a>(&self, ids: Ids) -> Fill<'a> {
        Fill::Flat(byte_of(u32::from(ids.actor), self.byte))
    }

    fn background(&self, _: u8) -> u8 {
        0
    }

    fn surface(&self, _: &Pixel<'_>, ids: Ids) -> u8 {
        byte_of(u32::from(ids.actor), self.byte)
    }
}

/// One byte of the triangle's place in the scene's list, 0 where nothing is
/// (see depth).
#[derive(Clone, Copy, Debug)]
pub struct PaintTriangle {
    /// 0: the lowest byte.
    pub byte: u8,
}

impl Paint for PaintTriangle {
    type Stored = u8;

    fn fill<'a>(&self, _: &'a [u8; 256], _: Option<Level>, ids: Ids) -> Fill<'a> {
        Fill::Flat(byte_of(ids.triangle, self.byte))
    }

    fn hidden<'a>(&self, ids: Ids) -> Fill<'a> {
        Fill::Flat(byte_of(ids.triangle, self.byte))
    }

    fn background(&self, _: u8) -> u8 {
        0
    }

    fn surface(&self, _: &Pixel<'_>, ids: Ids) -> u8 {
        byte_of(ids.triangle, self.byte)
    }
}

fn byte_of(v: u32, byte: u8) -> u8 {
    v.to_le_bytes().get(usize::from(byte)).copied().unwrap_or(0)
}
