//! What a pixel's index means: the scene's colours, or for picking, measuring
//! and debugging something else, through the same kernels.

use crate::math::Level;
use crate::raster::Fill;

/// Whose pixel it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Ids {
    /// The actor.
    pub actor: u16,
    /// The triangle's place in the scene's list.
    pub triangle: u32,
}

/// Chooses a triangle's fill.
pub trait Paint {
    /// Whether the scene's fog lies over it.
    const FOGGED: bool = false;

    /// `shades` is the material's row of the shade table; `flat` the face's
    /// level if it has one.
    fn fill<'a>(&self, shades: &'a [u8; 256], flat: Option<Level>, ids: Ids) -> Fill<'a>;

    /// The index where nothing is drawn, given the scene's.
    fn background(&self, index: u8) -> u8;
}

/// The scene as it looks.
#[derive(Clone, Copy, Debug, Default)]
pub struct Shaded;

impl Paint for Shaded {
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
    fn background(&self, index: u8) -> u8 {
        index
    }
}

/// The light level itself, 0 where nothing is.
#[derive(Clone, Copy, Debug, Default)]
pub struct PaintLevel;

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

impl Paint for PaintLevel {
    fn fill<'a>(&self, _: &'a [u8; 256], flat: Option<Level>, _: Ids) -> Fill<'a> {
        flat.map_or(Fill::Gouraud(LEVELS), Fill::Flat)
    }

    fn background(&self, _: u8) -> u8 {
        0
    }
}

/// One byte of the actor's number, 0 where nothing is (see depth).
#[derive(Clone, Copy, Debug)]
pub struct PaintActor {
    /// 0: the lowest byte.
    pub byte: u8,
}

impl Paint for PaintActor {
    fn fill<'a>(&self, _: &'a [u8; 256], _: Option<Level>, ids: Ids) -> Fill<'a> {
        Fill::Flat(byte_of(u32::from(ids.actor), self.byte))
    }

    fn background(&self, _: u8) -> u8 {
        0
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
    fn fill<'a>(&self, _: &'a [u8; 256], _: Option<Level>, ids: Ids) -> Fill<'a> {
        Fill::Flat(byte_of(ids.triangle, self.byte))
    }

    fn background(&self, _: u8) -> u8 {
        0
    }
}

fn byte_of(v: u32, byte: u8) -> u8 {
    v.to_le_bytes().get(usize::from(byte)).copied().unwrap_or(0)
}
