//! A texture over a triangle of few columns, without runs. What is linear on the screen is a
//! place times nearness; there is no division at a pixel, since nearness differs by little.

use super::cut::PLACE_BITS;
use super::texture::{Picture, Sampler, coordinates};
use crate::math::{keep_rolled, reciprocal};
use crate::raster::{Change, RUN_FRACTION};
use crate::scene::{NO_TEXEL, Texture, Wrap};

/// Places are less than so many texels from the first corner's.
const MOST_TEXELS: u32 = 32;
/// Fractional bits of a place's difference from that.
const FINE_BITS: u32 = 10;
/// From those to a place's 16.
const FINE_DOWN: u32 = 16 - FINE_BITS;
/// From an attribute with [`RUN_FRACTION`] fractional bits of those to a place.
const TO_PLACE: u32 = RUN_FRACTION - FINE_DOWN;

/// Fractional bits of how much less near than the middle something is.
const LESS_BITS: u32 = 19;
/// Corners' depths differ by less than an eighth: pixels are nearer or less near than the middle
/// by a 16th, whose fourth power is what is left out.
const MOST_LESS: u32 = 3;
/// From pixel to pixel, less than a quarter less near.
const MOST_TURN: u32 = 1 << (LESS_BITS - 2);

/// The first corner's place, with how to get from there to others.
#[derive(Clone, Copy, Debug)]
pub struct SmallTexture {
    places: Places,
    corners: [Corner; 3],
}

/// How to get from depths and attributes to places.
#[derive(Clone, Copy, Debug)]
struct Places {
    /// The first corner's.
    from: [i32; 2],
    middle: Middle,
    /// Along each axis.
    held: [Held; 2],
}

/// A corner's place from the first one's, and how much less near it is than the middle.
#[derive(Clone, Copy, Debug, Default)]
struct Corner {
    off: [i32; 2],
    less: i32,
}

/// Where places are along an axis of a picture that does not repeat there by itself.
#[derive(Clone, Copy, Debug, Default)]
struct Held {
    /// The corners'.
    least: i32,
    most: i32,
    /// All bits of places that are counted backwards, of others none.
    mirrored: i32,
}

/// A texture on such a triangle where all pixels show one copy of it.
#[derive(Clone, Copy, Debug)]
pub struct SmallPicture<'a> {
    places: Places,
    picture: Picture<'a>,
    /// Whether the picture ends or turns at its edges.
    edges: bool,
}

/// A depth, with 4 fractional bits; another one is less near by `(middle - depth) * over >> down`.
#[derive(Clone, Copy, Debug, Default)]
struct Middle {
    depth: i32,
    over: i32,
    down: u32,
}

impl Middle {
    /// Of corners' depths; `None` if they differ too much.
    fn new(depths: [u32; 3]) -> Option<Self> {
        let [a, b, c] = depths;
        let (nearest, farthest) = (a.max(b).max(c), a.min(b).min(c));
        if (nearest - farthest) << MOST_LESS > nearest {
            return None;
        }
        let middle = (nearest + farthest) >> 1;
        let over = reciprocal(middle);
        // difference / middle = difference * mantissa * 2^(shift - 62); of the mantissa 15 bits.
        Some(Self {
            depth: middle as i32,
            over: over.mantissa >> 16,
            down: (62 - 16 - LESS_BITS).checked_sub(over.shift)?,
        })
    }

    #[inline(always)]
    fn less(&self, depth: u32) -> i32 {
        self.part(self.depth - depth as i32)
    }

    #[inline(always)]
    fn part(&self, difference: i32) -> i32 {
        (difference * self.over) >> (self.down & 31)
    }
}

impl Held {
    /// Of corners' places, along an axis of `2^size` texels; `None` if they lie on both sides of
    /// an edge.
    #[inline(never)]
    fn new([a, b, c]: [i32; 3], wrap: Wrap, size: u8) -> Option<Self> {
        let least = a.min(b).min(c);
        // At an edge as if before it.
        let most = a.max(b).max(c).wrapping_sub(1).max(least);
        let period = |c: i32| c >> (PLACE_BITS + i32::from(size)).min(31);
        let same = period(least) == period(most) && (wrap == Wrap::Mirror || period(least) == 0);
        same.then_some(Self {
            least,
            most,
            mirrored: -(period(least) & 1),
        })
    }
}

impl SmallTexture {
    /// From the corners' attributes, of which the first two become those that are linear on the
    /// screen, and, in perspective, their depths, which are proportional to nearness; `None` if
    /// they do not say places to a 400th of a texel, lie on both sides of a picture's edge, or if
    /// the texture has holes.
    #[inline(never)]
    pub fn new(
        sampler: &Sampler<'_>,
        corners: [&mut [i32]; 3],
        depths: Option<[u32; 3]>,
    ) -> Option<Self> {
        let attributes = corners.each_ref().map(|corner| coordinates(corner));
        // An outline is held to more than can be had here.
        if sampler.texture.cut_out || !sampler.are_near(&attributes, MOST_TEXELS) {
            return None;
        }
        let middle = depths.map_or(Some(Middle::default()), Middle::new)?;
        let places = attributes.map(|corner| sampler.place(corner));
        let [from, ..] = places;
        let mut size = 0;
        let mut known = [Corner::default(); 3];
        let each = corners.into_iter().zip(places).zip(&mut known);
        for (((corner, place), known), depth) in each.zip(depths.unwrap_or_default()) {
            let less = middle.less(depth);
            known.less = less;
            let offs = known.off.iter_mut();
            for (((own, c), first), off) in corner.iter_mut().zip(place).zip(from).zip(offs) {
                *off = c.wrapping_sub(first);
                let off = *off;
                size = size.max(off.unsigned_abs());
                // Rounded.
                let off = (off >> (FINE_DOWN - 1)).wrapping_add(1) >> 1;
                *own = (off - (off.wrapping_mul(less) >> LESS_BITS)) << RUN_FRACTION;
            }
            keep_rolled();
        }
        // A 16th of a unit of depth, as which it is held, is a 512th of a texel.
        if depths.is_some() && size >> 7 > middle.depth as u32 {
            return None;
        }
        let mut held = [Held::default(); 2];
        let Texture {
            wrap, size: sizes, ..
        } = sampler.texture;
        if wrap != Wrap::Repeat {
            let [[ax, ay], [bx, by], [cx, cy]] = places;
            for ((held, all), size) in held.iter_mut().zip([[ax, bx, cx], [ay, by, cy]]).zip(sizes)
            {
                *held = Held::new(all, wrap, size)?;
            }
        }
        Some(Self {
            places: Places { from, middle, held },
            corners: known,
        })
    }

    /// With the copy of the picture that pixels show, if all show the same; from how depth (16
    /// fractional bits) and the attributes change.
    #[inline(never)]
    pub fn begin<'a>(
        &self,
        sampler: &Sampler<'a>,
        depth: Change,
        places: [Change; 2],
    ) -> Option<SmallPicture<'a>> {
        let mut number = 0;
        if sampler.texture.copies > 1 {
            let turns = [depth.x, depth.y].map(|change| change >> 12);
            if turns.iter().any(|turn| turn.unsigned_abs() >= 1 << 16) {
                return None;
            }
            // Farther means less near.
            let turns = turns.map(|turn| -self.places.middle.part(turn));
            if turns.iter().any(|turn| turn.unsigned_abs() >= MOST_TURN) {
                return None;
            }
            let (mut least, mut most) = (u32::MAX, 0);
            for corner in &self.corners {
                let steps = corner.steps(places, turns);
                (least, most) = (least.min(steps), most.max(steps));
                keep_rolled();
            }
            number = sampler.number(most);
            if number != sampler.number(least) {
                return None;
            }
        }
        Some(SmallPicture {
            places: self.places,
            picture: sampler.numbered(number),
            edges: sampler.texture.wrap != Wrap::Repeat,
        })
    }
}

impl Corner {
    /// How far it is at a corner to the next column's or row's place, along the axis where that
    /// is most: `(p q)' = q (p' + p q t')` where `q = 1 / (1 - t)`.
    #[inline(always)]
    fn steps(&self, places: [Change; 2], turns: [i32; 2]) -> u32 {
        const COARSE: u32 = 8;
        let mut most = 0;
        for (off, change) in self.off.into_iter().zip(places) {
            for (own, turn) in [change.x, change.y].into_iter().zip(turns) {
                let lens = ((off >> COARSE) * turn) >> (LESS_BITS - COARSE);
                most = most.max(((own >> TO_PLACE) + lens).unsigned_abs());
            }
        }
        let less = self.less;
        let times = (1 << LESS_BITS) + less + ((less * less) >> LESS_BITS);
        ((most >> 4) * (times as u32 >> 8)) >> (LESS_BITS - 12)
    }
}

impl Places {
    /// The place of a pixel from its depth, 16.16 and half a unit more, and its attributes.
    #[inline(always)]
    fn at(&self, depth: u32, attributes: [i32; 2]) -> [i32; 2] {
        const HALVES: u32 = (1 << 15) - (1 << 11);
        let less = self.middle.less(depth.wrapping_sub(HALVES) >> 12);
        // 1 / (1 - t) - 1, by its first three terms.
        let square = (less * less) >> LESS_BITS;
        let more = less + square + ((square * less) >> LESS_BITS);
        let mut place = self.from;
        for (place, own) in place.iter_mut().zip(attributes) {
            let more = ((own >> RUN_FRACTION) * more) >> (LESS_BITS - FINE_DOWN);
            *place = place.wrapping_add(own >> TO_PLACE).wrapping_add(more);
        }
        place
    }
}

impl SmallPicture<'_> {
    /// The place of a pixel from its depth, 16.16 and half a unit more, and its attributes.
    #[inline(always)]
    pub fn place(&self, depth: u32, attributes: [i32; 2]) -> [i32; 2] {
        self.places.at(depth, attributes)
    }

    /// The base colour at a place; `None` where nothing is seen.
    #[inline(always)]
    pub fn nearest(&self, mut place: [i32; 2]) -> Option<u8> {
        if self.edges {
            for (at, held) in place.iter_mut().zip(self.places.held) {
                // Not clamped: nobody knows here that there is a least and a most.
                *at = (*at).max(held.least).min(held.most) ^ held.mirrored;
            }
        }
        let copy = &self.picture.copy;
        let texel = copy.texels.get(copy.cut.texel(place)).copied()?;
        (texel != NO_TEXEL).then_some(texel)
    }

    /// The colour at a place, 0..=255 each; `None` where nothing is seen.
    #[inline(always)]
    pub fn colour(&self, sampler: &Sampler<'_>, place: [i32; 2]) -> Option<[u32; 3]> {
        sampler.colour(&self.picture, place)
    }
}
