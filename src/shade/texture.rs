//! Texels.

use super::cut::{Cut, PLACE_BITS};
use crate::raster::{FINE, Footprint, Fours, Path, RUN_FRACTION, Run};
use crate::scene::layout::BASES;
use crate::scene::{Coordinates, NO_TEXEL, Scene, Texture, Wrap};

/// A coordinate has 16 bits, an attribute so many more.
const FRACTION: i32 = RUN_FRACTION as i32;

/// A texture has at most so many copies.
const COPIES: usize = 11;

/// The second copy is for pixels of no less than sqrt(2) texels, 16 fractional bits; the others for
/// twice as many each.
const LEAST_OF_SECOND: u32 = 92682;

/// A texture on a mesh: from attributes to texels.
#[derive(Clone, Copy, Debug)]
pub struct Sampler<'a> {
    /// The texture.
    pub texture: Texture,
    /// The picture and its smaller copies.
    copies: [Copied<'a>; COPIES],
    bases: &'a [[u8; 3]],
    /// From a mesh's coordinate to an attribute: a left shift, negative: right.
    coordinates: [i32; 2],
    /// From an attribute of a run to a place: a left shift, mostly 0.
    shifts: [u32; 2],
    /// The mesh's origin as a place.
    origin: [i64; 2],
}

/// One copy of a picture.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Copied<'a> {
    pub texels: &'a [u8],
    /// `log2` of its size.
    pub size: [u32; 2],
    /// From places in the picture to a texel's number, see [`Cut`].
    pub cut: Cut,
}

/// Numbers that go along a parabola from pixel to pixel: two are places in the picture,
/// in texels with 16 fractional bits, modulo 2^32.
#[derive(Clone, Copy, Debug)]
pub struct Places<const N: usize = 2> {
    /// The first pixel's.
    pub(super) from: [i32; N],
    /// The change to the second.
    pub(super) step: [i32; N],
    /// How that changes.
    pub(super) bend: [i32; N],
}

impl<const N: usize> Places<N> {
    /// That of the `number`th pixel.
    #[inline(always)]
    pub fn at(&self, number: i32) -> [i32; N] {
        let before = (number * (number - 1)) >> 1;
        let mut at = self.from;
        for (at, (step, bend)) in at.iter_mut().zip(self.step.iter().zip(self.bend)) {
            *at = at
                .wrapping_add(step.wrapping_mul(number))
                .wrapping_add(bend.wrapping_mul(before));
        }
        at
    }

    /// The parabola as straight lines of four pixels each, which lie as much above it as
    /// below; of outlines as parabolas.
    #[inline(always)]
    pub(super) fn in_fours(self, outlined: bool) -> Fours<N> {
        let mut fours = Fours {
            from: self.from,
            step: self.step,
            bend: self.bend,
            twist: [0; N],
        };
        let all = fours
            .from
            .iter_mut()
            .zip(&mut fours.step)
            .zip(&mut fours.bend);
        for ((from, step), bend) in all {
            if !outlined {
                *from = from.wrapping_sub(*bend).wrapping_sub(*bend >> 2);
            }
            *step = step.wrapping_add(*bend).wrapping_add(*bend >> 1) << FINE;
            *bend <<= 2 + FINE;
        }
        fours
    }
}

/// One copy of a texture.
#[derive(Clone, Copy, Debug)]
pub struct Picture<'a> {
    pub(super) copy: Copied<'a>,
    /// From the largest copy's places to its own: right shifts.
    down: [i32; 2],
}

impl<'a> Sampler<'a> {
    /// A texture of the scene, on a mesh with these coordinates.
    pub fn new(scene: &Scene<'a>, texture: Texture, coordinates: Coordinates) -> Self {
        let exponent = i32::from(coordinates.exponent);
        let [width, height] = texture.size.map(i32::from);
        let to_place = |size: i32| PLACE_BITS + size - exponent;
        let origin = |c: i32, size: i32| {
            let up = to_place(size);
            let c = i64::from(c);
            if up >= 0 {
                c << up.min(30)
            } else {
                c >> up.wrapping_neg().min(63)
            }
        };
        let [u, v] = coordinates.origin;
        let mut copies = [Copied::default(); COPIES];
        let mut texels = scene.texels().get(texture.first as usize..);
        for (number, copy) in (0..).zip(&mut copies).take(texture.copies.into()) {
            copy.size = texture.copy_size(number);
            let [w, h] = copy.size;
            copy.cut = Cut::new(copy.size, texture.size.map(u32::from));
            let own = texels.and_then(|all| all.split_at_checked(1 << (w + h).min(24)));
            copy.texels = own.map_or(&[], |(own, _)| own);
            texels = own.map(|(_, rest)| rest);
        }
        Self {
            texture,
            copies,
            bases: scene.bases(),
            coordinates: [width, height].map(|size| to_place(size).min(FRACTION)),
            shifts: [width, height].map(|size| (to_place(size) - FRACTION).clamp(0, 31) as u32),
            origin: [origin(u, width), origin(v, height)],
        }
    }

    /// The way of a run, whose first two attributes are texture coordinates; and a copy of the
    /// texture, with how many of its pixels show it.
    pub fn path<const A: usize, C>(&self, run: &Run<'_, A, C>) -> (Places, Picture<'a>, usize) {
        let places = self.places(&run.path);
        let (copy, count) = self.copy(run);
        (places, self.picture(copy), count)
    }

    fn picture(&self, copy: &Copied<'a>) -> Picture<'a> {
        let ([w, h], [cw, ch]) = (self.texture.size, copy.size);
        Picture {
            copy: *copy,
            down: [i32::from(w) - cw as i32, i32::from(h) - ch as i32].map(|d| d & 31),
        }
    }

    /// Whether corners' attributes are places less than so many texels from the first one's.
    /// Attributes do not wrap, as places do.
    pub(super) fn are_near(&self, corners: &[[i32; 2]; 3], texels: u32) -> bool {
        let [first, others @ ..] = corners;
        others.iter().all(|corner| {
            let axes = corner.iter().zip(first).zip(self.shifts);
            axes.into_iter()
                .all(|((c, first), shift)| c.abs_diff(*first) < texels << PLACE_BITS >> shift)
        })
    }

    /// The copy of some number.
    pub(super) fn numbered(&self, number: usize) -> Picture<'a> {
        self.picture(self.copied(number))
    }

    /// The places of pixels whose first two attributes are texture coordinates.
    #[inline(always)]
    pub(super) fn places<const A: usize>(&self, path: &Path<A>) -> Places {
        let [from, step, bend] =
            [&path.from, &path.step, &path.bend].map(|values| coordinates(values));
        Places {
            from: self.place(from),
            step: self.scaled(step),
            bend: self.scaled(bend),
        }
    }

    /// The same of lines of four pixels.
    #[inline(always)]
    pub(super) fn places_in_fours<const A: usize>(&self, fours: &Fours<A>) -> Fours<2> {
        let Fours {
            from,
            step,
            bend,
            twist,
        } = fours;
        let [from, step, bend, twist] = [from, step, bend, twist].map(|values| coordinates(values));
        Fours {
            from: self.place(from),
            step: self.scaled(step),
            bend: self.scaled(bend),
            twist: self.scaled(twist),
        }
    }

    /// The place of attributes.
    #[inline(always)]
    pub(super) fn place(&self, from: [i32; 2]) -> [i32; 2] {
        let [x, y] = self.origin;
        match self.texture.wrap {
            // What repeats may wrap: its period divides 2^32.
            Wrap::Repeat | Wrap::Mirror => {
                let [u, v] = self.scaled(from);
                [u.wrapping_add(x as i32), v.wrapping_add(y as i32)]
            }
            Wrap::Clamp => {
                let ([u, v], [across, down]) = (from.map(i64::from), self.shifts);
                [(u << across) + x, (v << down) + y]
                    .map(|place| place.clamp(-(1 << 30), 1 << 30) as i32)
            }
        }
    }

    /// The largest copy and the place in it of one point, whose texture coordinates are the
    /// mesh's with 8 fractional bits.
    #[cfg(feature = "ray")]
    pub fn point(&self, coordinates: [i32; 2]) -> (Picture<'a>, [i32; 2]) {
        let (down, up) = (self.coordinates, self.shifts);
        let place = |c: i32, down: i32, up: u32, origin: i64| {
            let shift = down + up as i32 - 8;
            let c = i64::from(c);
            let place = if shift >= 0 {
                c << shift.min(31)
            } else {
                c >> shift.wrapping_neg().min(31)
            };
            let place = place + origin;
            match self.texture.wrap {
                Wrap::Clamp => place.clamp(-(1 << 30), 1 << 30) as i32,
                Wrap::Repeat | Wrap::Mirror => place as i32,
            }
        };
        let ([u, v], [x, y]) = (coordinates, self.origin);
        let ([u_down, v_down], [u_up, v_up]) = (down, up);
        let from = [place(u, u_down, u_up, x), place(v, v_down, v_up, y)];
        let [copy, ..] = self.copies;
        let picture = Picture { copy, down: [0; 2] };
        (picture, from)
    }

    /// Attributes or their changes as places, modulo 2^32.
    #[inline(always)]
    fn scaled(&self, [u, v]: [i32; 2]) -> [i32; 2] {
        let [across, down] = self.shifts;
        [u << (across & 31), v << (down & 31)]
    }

    /// A vertex's coordinates as attributes: places as far as their range goes.
    pub fn attributes(&self, coordinates: [i16; 2]) -> [i32; 2] {
        let ([u, v], [across, down]) = (coordinates.map(i32::from), self.coordinates);
        let moved = |c: i32, shift: i32| {
            if shift >= 0 {
                c << shift
            } else {
                c >> shift.wrapping_neg().min(31)
            }
        };
        [moved(u, across), moved(v, down)]
    }

    /// The copy whose texels are nearest to the first pixel's size, and how many pixels
    /// of the run show it.
    #[inline(always)]
    pub(super) fn copy<const A: usize, C>(&self, run: &Run<'_, A, C>) -> (&Copied<'a>, usize) {
        let (number, count) = self.alike(&run.footprint, &run.footprint_step, run.indices.len());
        (self.copied(number), count)
    }

    /// The number of the copy whose texels are nearest to the first pixel's size, from its
    /// footprint and its change a pixel, and how many pixels show it: `floor(log2(r) + 1/2)`, with
    /// r the most texels that a pixel goes along one axis of picture and screen.
    #[inline(always)]
    pub fn alike(&self, footprint: &Footprint, step: &Footprint, pixels: usize) -> (usize, usize) {
        if self.texture.copies <= 1 {
            return (0, pixels);
        }
        self.nearest_copy(footprint, step, pixels)
    }

    #[inline(never)]
    fn nearest_copy(&self, from: &Footprint, step: &Footprint, pixels: usize) -> (usize, usize) {
        let all = |footprint: &Footprint| {
            let ([a, b], [c, d]) = (self.scaled(footprint.across), self.scaled(footprint.down));
            [a, b, c, d]
        };
        let (mut from, step) = (all(from), all(step));
        let here = self.number(from.iter().fold(0, |most, c| c.unsigned_abs().max(most)));
        let after = |copy: usize| LEAST_OF_SECOND << copy.min(COPIES);
        let least_here = if here == 0 { 0 } else { after(here - 1) };
        let most_here = if here + 1 < usize::from(self.texture.copies) {
            after(here) - 1
        } else {
            u32::MAX
        };
        // Some pixels on, if all before are alike: they are no more than the most at both ends, and
        // no less than the least of what has one sign.
        let on = |from: &[i32; 4], pixels: i32| {
            let (mut most, mut least, mut to) = (0, 0, *from);
            for (to, step) in to.iter_mut().zip(step) {
                let from = *to;
                *to = from.wrapping_add(step.wrapping_mul(pixels));
                let (one, other) = (from.unsigned_abs(), to.unsigned_abs());
                most = one.max(other).max(most);
                if from ^ *to >= 0 {
                    least = one.min(other).max(least);
                }
            }
            (least >= least_here && most <= most_here).then_some(to)
        };
        let mut more = pixels.saturating_sub(1) as i32;
        if on(&from, more).is_some() {
            return (here, pixels);
        }
        // What is left is less than the next power of two.
        let mut good = 1;
        while more > 1 {
            more = (more + 1) >> 1;
            if let Some(to) = on(&from, more) {
                from = to;
                good += more;
            }
        }
        (here, pixels.min(good as usize))
    }

    /// One of the copies.
    #[inline(always)]
    pub(super) fn copied(&self, number: usize) -> &Copied<'a> {
        let [first, ..] = &self.copies;
        self.copies.get(number).unwrap_or(first)
    }

    /// The number of the copy for a pixel of `most` texels, 16 fractional bits.
    #[inline(always)]
    pub(super) fn number(&self, most: u32) -> usize {
        let last = u32::from(self.texture.copies).saturating_sub(1);
        let mut copy = 0;
        while copy < last && (most >> copy.min(31)) >= LEAST_OF_SECOND {
            copy += 1;
        }
        copy as usize
    }

    /// The base colour at a place of the picture; `None` where nothing is seen.
    #[inline(always)]
    pub fn nearest(&self, picture: &Picture<'_>, [x, y]: [i32; 2]) -> Option<u8> {
        let [across, down] = picture.down;
        let texel = self.texel(
            picture,
            [x >> across >> PLACE_BITS, y >> down >> PLACE_BITS],
        );
        (texel != NO_TEXEL).then_some(texel)
    }

    /// The colour at a place of the picture, 0..=255 each; `None` where nothing is seen.
    pub fn colour(&self, picture: &Picture<'_>, place: [i32; 2]) -> Option<[u32; 3]> {
        let nearest = self.nearest(picture, place)?;
        if !self.texture.bilinear {
            return Some(self.base(nearest));
        }
        // From the centres of the texels around it.
        let ([x, y], [across, down]) = (place, picture.down);
        let [x, y] = [x >> across, y >> down].map(|c| c.wrapping_sub(1 << (PLACE_BITS - 1)));
        let (i, j) = (x >> PLACE_BITS, y >> PLACE_BITS);
        let [wx, wy] = [x, y].map(|c| ((c >> (PLACE_BITS - BLEND_BITS)) & BLEND_MASK) as u32);
        let mut blend = [0; 3];
        let mut whole = 0;
        for (di, dj) in [(0, 0), (1, 0), (0, 1), (1, 1)] {
            let along = |d: i32, w: u32| if d == 0 { (1 << BLEND_BITS) - w } else { w };
            let weight = along(di, wx) * along(dj, wy);
            let texel = self.texel(picture, [i.wrapping_add(di), j.wrapping_add(dj)]);
            if texel != NO_TEXEL {
                whole += weight;
                for (sum, c) in blend.iter_mut().zip(self.base(texel)) {
                    *sum += c * weight;
                }
            }
        }
        const FULL: u32 = 1 << (2 * BLEND_BITS);
        Some(blend.map(|c| {
            if whole == FULL {
                (c + FULL / 2) >> (2 * BLEND_BITS)
            } else {
                (c + whole / 2).checked_div(whole).unwrap_or(0)
            }
        }))
    }

    fn base(&self, texel: u8) -> [u32; 3] {
        self.bases
            .get(usize::from(texel) % BASES)
            .map_or([0; 3], |base| base.map(u32::from))
    }

    /// The texel of a column and a row, wrapped.
    #[inline(always)]
    fn texel(&self, picture: &Picture<'_>, [i, j]: [i32; 2]) -> u8 {
        let [w, h] = picture.copy.size;
        let (x, y) = (self.wrapped(i, w), self.wrapped(j, h));
        let at = (y << w | x) as usize;
        picture.copy.texels.get(at).copied().unwrap_or(NO_TEXEL)
    }

    #[inline(always)]
    fn wrapped(&self, i: i32, bits: u32) -> u32 {
        let last = (1i32 << bits.min(15)) - 1;
        let wrapped = match self.texture.wrap {
            Wrap::Repeat => i & last,
            Wrap::Clamp => i.clamp(0, last),
            Wrap::Mirror => {
                let twice = i & (2 * last + 1);
                if twice > last {
                    2 * last + 1 - twice
                } else {
                    twice
                }
            }
        };
        wrapped as u32
    }
}

/// Bits of a weight of the blend of four texels.
const BLEND_BITS: i32 = 8;
const BLEND_MASK: i32 = (1 << BLEND_BITS) - 1;

/// The first two of some values.
#[inline(always)]
pub(super) fn coordinates(values: &[i32]) -> [i32; 2] {
    [0, 1].map(|which| values.get(which).copied().unwrap_or(0))
}
