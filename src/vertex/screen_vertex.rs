//! A vertex on the screen.

use super::outside;
use crate::math::{FineDepth, FineLevel, SubPx};

/// A vertex on the screen, in 12 bytes, so that more meshlets are kept from band to
/// band. Not meaningful in x, y and z if [`outside`](Self::outside) says that the vertex
/// has to be clipped first.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ScreenVertex {
    /// 25 bits of x, above 3 outcode bits and 4 of the rest.
    x: u32,
    /// The same of y.
    y: u32,
    /// 20 bits of depth, above 12 of level.
    depth_and_level: u32,
}

const PLACE_SHIFT: u32 = 7;
const OUTSIDE_SHIFT: u32 = Rest::BITS;
const OUTSIDE: u32 = 7 << OUTSIDE_SHIFT;
const LEVEL_BITS: u32 = 12;
/// Of a level's fractional bits, those that are not kept.
const LEVEL_DOWN: u32 = 2;

impl ScreenVertex {
    /// At the screen's corner.
    pub const ZERO: Self = Self {
        x: 0,
        y: 0,
        depth_and_level: 0,
    };

    /// A vertex within all planes, at x and y from the screen's top left corner, within
    /// 4096 pixels, of some depth, not lit.
    #[inline(always)]
    pub fn new(place: [SubPx; 2], rest: Rest, depth: FineDepth) -> Self {
        let [x, y] = place.map(|c| (c.to_bits() as u32) << PLACE_SHIFT);
        let [rest_x, rest_y] = rest.bits();
        Self {
            x: x | rest_x,
            y: y | rest_y,
            depth_and_level: depth.to_bits() << LEVEL_BITS,
        }
    }

    /// A vertex beyond some planes, bits of [`outside`].
    #[inline(always)]
    pub(crate) fn beyond(planes: u8) -> Self {
        let planes = u32::from(planes);
        Self {
            x: (planes << OUTSIDE_SHIFT) & OUTSIDE,
            y: (planes >> 3 << OUTSIDE_SHIFT) & OUTSIDE,
            depth_and_level: 0,
        }
    }

    /// Room for a vertex's clip coordinates until it is projected.
    #[inline(always)]
    pub(super) fn to_be_projected([x, y, distance]: [i32; 3]) -> Self {
        Self {
            x: x as u32,
            y: y as u32,
            depth_and_level: distance as u32,
        }
    }

    /// The clip coordinates of one that is to be projected.
    #[inline(always)]
    pub(super) fn in_clip(&self) -> [i32; 3] {
        [self.x, self.y, self.depth_and_level].map(|c| c as i32)
    }

    /// What else is kept in the room of a vertex: three words.
    pub(super) fn words(&self) -> [u32; 3] {
        [self.x, self.y, self.depth_and_level]
    }

    /// Puts one of the words into its place.
    pub(super) fn set_word(&mut self, which: usize, word: u32) {
        match which {
            0 => self.x = word,
            1 => self.y = word,
            _ => self.depth_and_level = word,
        }
    }

    /// With a light level, which is rounded to 1/16.
    #[must_use]
    #[inline(always)]
    pub fn lit(self, level: FineLevel) -> Self {
        const HALF: u32 = 1 << (LEVEL_DOWN - 1);
        const MOST: u32 = (1 << LEVEL_BITS) - 1;
        let level = (u32::from(level.to_bits()) + HALF) >> LEVEL_DOWN;
        Self {
            depth_and_level: self.depth_and_level & !MOST | level.min(MOST),
            ..self
        }
    }

    /// At another depth.
    #[must_use]
    pub fn with_depth(self, depth: FineDepth) -> Self {
        let level = self.depth_and_level & ((1 << LEVEL_BITS) - 1);
        Self {
            depth_and_level: depth.to_bits() << LEVEL_BITS | level,
            ..self
        }
    }

    /// From the screen's left edge.
    #[inline(always)]
    pub fn x(&self) -> SubPx {
        SubPx::from_bits(self.x as i32 >> PLACE_SHIFT)
    }

    /// From the screen's top edge.
    #[inline(always)]
    pub fn y(&self) -> SubPx {
        SubPx::from_bits(self.y as i32 >> PLACE_SHIFT)
    }

    /// Depth.
    #[inline(always)]
    pub fn z(&self) -> FineDepth {
        FineDepth::from_bits(self.depth_and_level >> LEVEL_BITS)
    }

    /// Light level.
    #[inline(always)]
    pub fn level(&self) -> FineLevel {
        let kept = self.depth_and_level & ((1 << LEVEL_BITS) - 1);
        FineLevel::from_bits((kept << LEVEL_DOWN) as u16)
    }

    /// What rounding took from x and y.
    pub(crate) fn rest(&self) -> Rest {
        Rest::from_bits([self.x, self.y])
    }

    /// Planes that it is beyond: bits of [`outside`].
    #[inline(always)]
    pub fn outside(&self) -> u8 {
        let [low, high] = [self.x, self.y].map(|c| (c & OUTSIDE) >> OUTSIDE_SHIFT);
        (low | high << 3) as u8
    }

    /// Whether it has to be clipped.
    #[inline(always)]
    pub fn is_outside(&self) -> bool {
        (self.x | self.y) & OUTSIDE != 0
    }

    /// Whether some are outside.
    #[inline(always)]
    pub fn any_outside<const N: usize>(all: [&Self; N]) -> bool {
        let any = all.iter().fold(0, |sum, v| sum | v.x | v.y);
        any & OUTSIDE != 0
    }

    /// Whether all are beyond one plane.
    #[inline(always)]
    pub fn all_outside<const N: usize>(all: [&Self; N]) -> bool {
        let x = all.iter().fold(OUTSIDE, |sum, v| sum & v.x);
        let y = all.iter().fold(OUTSIDE, |sum, v| sum & v.y);
        x | y != 0
    }
}

const _: () = assert!(outside::BELOW < 1 << 6);

/// Between which heights some vertices are.
pub(super) struct Heights {
    least: i32,
    most: i32,
    any: u32,
}

impl Heights {
    /// Of no vertex.
    pub(super) const NONE: Self = Self {
        least: i32::MAX,
        most: i32::MIN,
        any: 0,
    };

    /// One more vertex.
    #[inline(always)]
    pub(super) fn add(&mut self, vertex: &ScreenVertex) {
        // What is below y decides only between equals.
        let y = vertex.y as i32;
        self.least = self.least.min(y);
        self.most = self.most.max(y);
        self.any |= vertex.x | vertex.y;
    }

    /// The least and the most y; `None` if some have to be clipped.
    pub(super) fn ends(&self) -> Option<(SubPx, SubPx)> {
        let place = |y: i32| SubPx::from_bits(y >> PLACE_SHIFT);
        (self.any & OUTSIDE == 0).then_some((place(self.least), place(self.most)))
    }
}

/// What rounding took from a screen position, in 1/16 of a sub-pixel, -8..=7
/// each. Only the depth of steep faces needs it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Rest([i8; 2]);

impl Rest {
    /// Nothing.
    pub const NONE: Self = Self([0; 2]);
    /// Bits of each part.
    pub(crate) const BITS: u32 = 4;

    /// Of x and of y, each -8..=7.
    #[inline(always)]
    pub fn new(x: i32, y: i32) -> Self {
        Self([x as i8, y as i8])
    }

    /// Of x and of y.
    pub(crate) fn parts(self) -> [i32; 2] {
        self.0.map(i32::from)
    }

    #[inline(always)]
    fn bits(self) -> [u32; 2] {
        self.0.map(|c| (c as u32) & 15)
    }

    fn from_bits(bits: [u32; 2]) -> Self {
        Self(bits.map(|c| ((c as i32) << 28 >> 28) as i8))
    }
}
