//! Texels.

use crate::raster::{RUN_FRACTION, Run};
use crate::scene::layout::BASES;
use crate::scene::{Coordinates, NO_TEXEL, Scene, Texture, Wrap};

/// Fractional bits of a place in a texture.
const PLACE_BITS: i32 = 16;

/// A texture on a mesh: from attributes to texels.
#[derive(Clone, Copy, Debug)]
pub struct Sampler<'a> {
    /// The texture.
    pub texture: Texture,
    texels: &'a [u8],
    bases: &'a [[u8; 3]],
    /// From an attribute of a run to a place: a left shift, negative: right.
    shifts: [i32; 2],
    /// The mesh's origin as a place.
    origin: [i64; 2],
}

/// A run's way through one copy of a texture, in places of that copy.
#[derive(Clone, Copy, Debug)]
pub struct Path<'a> {
    texels: &'a [u8],
    /// `log2` of the copy's size.
    size: [u32; 2],
    /// The first pixel's place, [`PLACE_BITS`] fractional bits.
    from: [i32; 2],
    /// The change a pixel.
    step: [i32; 2],
    /// From the picture's places to the copy's.
    down: [u32; 2],
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
                c >> up.wrapping_neg()
            }
        };
        let [u, v] = coordinates.origin;
        let first = texture.first as usize;
        let end = first.saturating_add(texture.texels() as usize);
        Self {
            texture,
            texels: scene.texels().get(first..end).unwrap_or_default(),
            bases: scene.bases(),
            shifts: [width, height].map(|size| to_place(size) - RUN_FRACTION as i32),
            origin: [origin(u, width), origin(v, height)],
        }
    }

    /// The way of a run, whose first two attributes are texture coordinates.
    #[inline(always)]
    pub fn path(&self, run: &Run<'_>) -> Path<'a> {
        let ([u, v, ..], [du, dv, ..]) = (run.from, run.step);
        let step = self.each([du, dv], moved);
        let mut from = [0; 2];
        for (which, (from, c)) in from.iter_mut().zip([u, v]).enumerate() {
            let shift = self.shifts.get(which).copied().unwrap_or(0);
            let origin = self.origin.get(which).copied().unwrap_or(0);
            let place = wide(c, shift) + origin;
            // What repeats may wrap: its period divides 2^32.
            *from = match self.texture.wrap {
                Wrap::Clamp => place.clamp(-(1 << 30), 1 << 30) as i32,
                Wrap::Repeat | Wrap::Mirror => place as i32,
            };
        }
        let copy = self.copy(step, run);
        let size = self.texture.copy_size(copy);
        let [w, h] = self.texture.size.map(u32::from);
        let [cw, ch] = size;
        let down = [w - cw.min(w), h - ch.min(h)];
        let [[fx, fy], [sx, sy], [dx, dy]] = [from, step, down.map(|d| d as i32)];
        let mut first = 0usize;
        for before in 0..copy {
            let [w, h] = self.texture.copy_size(before);
            first += 1 << (w + h).min(24);
        }
        Path {
            texels: self.texels.get(first..).unwrap_or_default(),
            size,
            from: [fx >> dx.min(31), fy >> dy.min(31)],
            step: [sx >> dx.min(31), sy >> dy.min(31)],
            down,
        }
    }

    /// The path and the place in it of one point, whose texture coordinates are
    /// attributes with 8 fractional bits: in the largest copy.
    pub fn point(&self, coordinates: [i32; 2]) -> (Path<'a>, [i32; 2]) {
        let mut from = [0; 2];
        for (which, (from, c)) in from.iter_mut().zip(coordinates).enumerate() {
            let shift = self.shifts.get(which).copied().unwrap_or(0);
            let origin = self.origin.get(which).copied().unwrap_or(0);
            let place = wide(c, shift + RUN_FRACTION as i32 - 8) + origin;
            *from = match self.texture.wrap {
                Wrap::Clamp => place.clamp(-(1 << 30), 1 << 30) as i32,
                Wrap::Repeat | Wrap::Mirror => place as i32,
            };
        }
        let path = Path {
            texels: self.texels,
            size: self.texture.copy_size(0),
            from,
            step: [0; 2],
            down: [0; 2],
        };
        (path, from)
    }

    fn each(&self, values: [i32; 2], f: impl Fn(i32, i32) -> i32) -> [i32; 2] {
        let mut out = [0; 2];
        for (out, (c, shift)) in out.iter_mut().zip(values.into_iter().zip(self.shifts)) {
            *out = f(c, shift);
        }
        out
    }

    /// The copy whose texels are nearest to a pixel's size: number
    /// `floor(log2(r) + 1/2)`, with r the most texels that a pixel goes along one
    /// axis of picture and screen.
    #[inline(always)]
    fn copy(&self, step: [i32; 2], run: &Run<'_>) -> u32 {
        // sqrt(2) texels.
        const LEAST: u32 = 92682;
        let last = u32::from(self.texture.copies).saturating_sub(1);
        if last == 0 {
            return 0;
        }
        let down = self.each(run.down, moved);
        let [a, b] = step.map(i32::unsigned_abs);
        let [c, d] = down.map(i32::unsigned_abs);
        let most = a.max(b).max(c).max(d);
        let mut copy = 0;
        while copy < last && (most >> copy.min(31)) >= LEAST {
            copy += 1;
        }
        copy
    }

    /// The base colour at a place, [`NO_TEXEL`] where nothing is seen.
    #[inline(always)]
    pub fn nearest(&self, path: &Path<'_>, [x, y]: [i32; 2]) -> u8 {
        self.texel(path, [x >> PLACE_BITS, y >> PLACE_BITS])
    }

    /// The colour at a place, 0..=255 each; `None` where nothing is seen.
    pub fn colour(&self, path: &Path<'_>, place: [i32; 2]) -> Option<[u32; 3]> {
        let nearest = self.nearest(path, place);
        if nearest == NO_TEXEL {
            return None;
        }
        if !self.texture.bilinear {
            return Some(self.base(nearest));
        }
        // From the centres of the texels around it, in 16ths: the small blend.
        let [x, y] = place.map(|c| c.wrapping_sub(1 << (PLACE_BITS - 1)));
        let (i, j) = (x >> PLACE_BITS, y >> PLACE_BITS);
        let [wx, wy] = [x, y].map(|c| ((c >> (PLACE_BITS - BLEND_BITS)) & BLEND_MASK) as u32);
        let mut blend = [0; 3];
        let mut whole = 0;
        for (di, dj) in [(0, 0), (1, 0), (0, 1), (1, 1)] {
            let along = |d: i32, w: u32| if d == 0 { (1 << BLEND_BITS) - w } else { w };
            let weight = along(di, wx) * along(dj, wy);
            let texel = self.texel(path, [i.wrapping_add(di), j.wrapping_add(dj)]);
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
    fn texel(&self, path: &Path<'_>, [i, j]: [i32; 2]) -> u8 {
        let [w, h] = path.size;
        let (x, y) = (self.wrapped(i, w), self.wrapped(j, h));
        let at = (y << w | x) as usize;
        path.texels.get(at).copied().unwrap_or(NO_TEXEL)
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
const BLEND_BITS: i32 = 4;
const BLEND_MASK: i32 = (1 << BLEND_BITS) - 1;

impl Path<'_> {
    /// The place of the `number`th pixel, in the copy.
    #[inline(always)]
    pub fn at(&self, number: i32) -> [i32; 2] {
        let ([x, y], [dx, dy]) = (self.from, self.step);
        [
            x.wrapping_add(dx.wrapping_mul(number)),
            y.wrapping_add(dy.wrapping_mul(number)),
        ]
    }

    /// The first pixel's place and the change a pixel.
    pub fn start(&self) -> ([i32; 2], [i32; 2]) {
        (self.from, self.step)
    }

    /// A place of the copy as one of the picture.
    pub fn in_picture(&self, [x, y]: [i32; 2]) -> [i32; 2] {
        let [dx, dy] = self.down;
        [x.wrapping_shl(dx), y.wrapping_shl(dy)]
    }
}

/// An attribute or its change as a place, modulo 2^32.
#[inline(always)]
fn moved(c: i32, shift: i32) -> i32 {
    wide(c, shift) as i32
}

#[inline(always)]
fn wide(c: i32, shift: i32) -> i64 {
    if shift >= 0 {
        i64::from(c) << shift.min(31)
    } else {
        i64::from(c >> shift.wrapping_neg().min(31))
    }
}
