//! Pixels of a surface's triangle in runs: from attributes to indices.

use core::cell::Cell;

use super::corner_source::CornerSource;
use super::paint::{Ids, Paint};
use super::triangles::Triangle;
use crate::frame::Stored;
use crate::light::{Parts, sum};
use crate::math::Depth;
use crate::raster::{Corner, Cubic, Footprint, Fours, MOST_ATTRIBUTES, Run, Shade};
use crate::scene::layout::{COLOURS, TEXTURE_SHADES};
use crate::shade::{Blend, Lookup, Pixel, Sampler, ScreenDoor, Surface, on_texel};

/// The way from light to an index.
#[derive(Clone, Copy)]
pub(super) enum Way<'a> {
    Levels(&'a [u8; 256]),
    Colours(&'a [u8; COLOURS]),
    Texels(&'a [u8; TEXTURE_SHADES]),
}

/// How what is behind a surface shows through.
#[derive(Clone, Copy)]
pub(super) enum Through<'a> {
    Nothing,
    Door(ScreenDoor),
    Blend(Blend<'a>),
}

/// What a triangle's runs, or pixels, have in common.
pub(super) struct Runs<'a, P> {
    pub paint: &'a P,
    pub ids: Ids,
    pub surface: &'a Surface<'a>,
    pub source: &'a CornerSource<'a>,
    pub triangle: &'a Triangle<'a>,
    /// Light of the face, once corners are known.
    face: Cell<Parts>,
}

impl<'a, P: Paint> Runs<'a, P> {
    pub fn new(paint: &'a P, corners: &'a CornerSource<'a>, triangle: &'a Triangle<'a>) -> Self {
        Self {
            paint,
            ids: corners.part.ids(triangle.number),
            surface: corners.surface,
            source: corners,
            triangle,
            face: Cell::default(),
        }
    }

    /// The corners of a triangle that is drawn.
    pub fn corners<const A: usize>(&self) -> [Corner<A>; 3] {
        self.face.set(self.source.face(self.triangle));
        self.source.of(self.triangle)
    }

    /// Draws a run of texels by level, each wrapped by itself.
    #[cold]
    #[inline(never)]
    fn wrapped<const A: usize, C: Stored>(
        &self,
        shades: &[u8; TEXTURE_SHADES],
        sampler: &Sampler<'_>,
        run: Run<'_, A, C>,
        store: impl Fn(P::Stored) -> Option<C>,
    ) -> usize {
        let ([left, row], face) = (run.place, self.face.get());
        let (places, picture, count) = sampler.path(&run);
        run.cut(count)
            .unplaced()
            .draw::<A>(true, |number, values, _| {
                let at = places.at(number);
                let pixel = Pixel {
                    lookup: Lookup::Texel(shades, sampler.nearest(&picture, at)?),
                    lit: self.surface.light(values, face).body,
                    place: [left + number, row],
                    texel: at,
                };
                store(self.paint.surface(&pixel, self.ids))
            });
        count
    }
}

/// Texels by level: one of the face, or the third attribute.
pub(super) struct Texels<'a, P> {
    pub runs: Runs<'a, P>,
    pub shades: &'a [u8; TEXTURE_SHADES],
    pub sampler: &'a Sampler<'a>,
}

impl<'a, P: Paint> Texels<'a, P> {
    /// From a pixel's number in a run, its light level and texel to an index.
    #[inline(always)]
    fn pixel<const A: usize>(
        &self,
        [left, row]: [i32; 2],
        places: Fours<2>,
    ) -> impl Fn(i32, i32, u8) -> u8 + use<'a, A, P> {
        let (Runs { paint, ids, .. }, shades) = (&self.runs, self.shades);
        let (paint, ids, face) = (*paint, *ids, self.runs.face.get());
        let outlined = self.sampler.texture.cut_out;
        move |number, level, base| {
            let pixel = Pixel {
                lookup: Lookup::Texel(shades, base),
                lit: if A > 2 { [level as u16; 3] } else { face.body },
                place: [left + number, row],
                texel: places.at(number, outlined),
            };
            paint.surface(&pixel, ids).index().unwrap_or_default()
        }
    }
}

impl<const A: usize, P: Paint> Shade<A> for Texels<'_, P> {
    #[inline(always)]
    fn run(&self, run: Run<'_, A>) -> usize {
        let Some((strip, count)) = self.sampler.strip(&run) else {
            return self
                .runs
                .wrapped(self.shades, self.sampler, run, Stored::index);
        };
        let shade = self.pixel::<A>(run.place, strip.places);
        strip.draw(run.cut(count), shade);
        count
    }

    #[inline(always)]
    fn alike(&self, footprint: &Footprint, step: &Footprint, pixels: usize) -> (usize, usize) {
        self.sampler.alike(footprint, step, pixels)
    }

    #[inline(always)]
    fn cubics(&self) -> bool {
        self.sampler.has_cubics()
    }

    #[inline(always)]
    fn cubic(&self, pixels: Cubic<'_, A>) -> bool {
        let Some(strip) = self.sampler.strip_of(&pixels) else {
            return false;
        };
        let shade = self.pixel::<A>(pixels.place, strip.places);
        match pixels.depths {
            Some(depths) => strip.draw_nearer(pixels.indices, depths, shade),
            None => strip.draw_all(pixels.indices, shade),
        }
        true
    }

    #[inline(always)]
    fn solid(&self) -> bool {
        !self.sampler.texture.cut_out
    }
}

/// All other surfaces.
pub(super) struct Others<'a, P> {
    pub runs: Runs<'a, P>,
    pub way: Way<'a>,
    pub sampler: Option<&'a Sampler<'a>>,
    pub through: Through<'a>,
    /// Of the fog's table, the last pixel's row.
    pub fog_row: Cell<usize>,
}

impl<P: Paint> Shade<MOST_ATTRIBUTES, P::Stored> for Others<'_, P> {
    #[inline(never)]
    fn run(&self, mut run: Run<'_, MOST_ATTRIBUTES, P::Stored>) -> usize {
        match self.through {
            Through::Nothing => self.whole(run),
            Through::Door(door) => door.shade(&mut run, |run| self.whole(run)),
            Through::Blend(blend) => self.blend(&blend, run),
        }
    }
}

impl<P: Paint> Others<'_, P> {
    /// Draws a run of pixels.
    #[inline(never)]
    fn whole(&self, run: Run<'_, MOST_ATTRIBUTES, P::Stored>) -> usize {
        let ([left, row], face) = (run.place, self.runs.face.get());
        let pixels = run.indices.len();
        let Runs {
            paint,
            ids,
            surface,
            ..
        } = self.runs;
        let index = |lookup, number, lit, texel| {
            let place = [left + number, row];
            let pixel = Pixel {
                lookup,
                lit,
                place,
                texel,
            };
            Some(paint.surface(&pixel, ids))
        };
        match (self.sampler, self.way) {
            (Some(sampler), Way::Texels(shades)) => self.runs.wrapped(shades, sampler, run, Some),
            (Some(sampler), Way::Colours(colours)) => {
                let (places, picture, count) = sampler.path(&run);
                run.cut(count)
                    .draw::<MOST_ATTRIBUTES>(true, |number, values, _| {
                        let at = places.at(number);
                        let texel = sampler.colour(&picture, at)?;
                        let lit = on_texel(surface.light(values, face), texel);
                        index(Lookup::Colours(colours), number, lit, at)
                    });
                count
            }
            (_, Way::Colours(colours)) => {
                run.draw::<9>(true, |number, values, _| {
                    let Parts { body, gloss } = surface.light(values, face);
                    index(Lookup::Colours(colours), number, sum(body, gloss), [0; 2])
                });
                pixels
            }
            (_, Way::Levels(shades)) => {
                run.draw::<9>(true, |number, values, _| {
                    let Parts { body, gloss } = surface.light(values, face);
                    index(Lookup::Levels(shades), number, sum(body, gloss), [0; 2])
                });
                pixels
            }
            (None, Way::Texels(_)) => pixels,
        }
    }

    /// Mixes a run of pixels with what is behind them, which stays as near as it is.
    #[inline(never)]
    fn blend(&self, blend: &Blend<'_>, run: Run<'_, MOST_ATTRIBUTES, P::Stored>) -> usize {
        let pixels = run.indices.len();
        // Blended materials go by colour.
        let Way::Colours(colours) = self.way else {
            return pixels;
        };
        let ([left, row], face) = (run.place, self.runs.face.get());
        let textured = self.sampler.map(|sampler| (sampler, sampler.path(&run)));
        let count = textured.as_ref().map_or(pixels, |(_, (.., count))| *count);
        let (z, dz) = run.depth;
        run.cut(count)
            .draw::<MOST_ATTRIBUTES>(false, |number, values, behind| {
                let light = self.runs.surface.light(values, face);
                let (lit, texel) = match &textured {
                    None => (sum(light.body, light.gloss), [0; 2]),
                    Some((sampler, (places, picture, _))) => {
                        let at = places.at(number);
                        (on_texel(light, sampler.colour(picture, at)?), at)
                    }
                };
                let pixel = Pixel {
                    lookup: Lookup::Colours(colours),
                    lit,
                    place: [left + number, row],
                    texel,
                };
                let depth = z.wrapping_add_signed(dz.wrapping_mul(number)) >> 16;
                Some(self.over(blend, pixel, depth as Depth, behind))
            });
        count
    }

    /// A pixel, in the fog, over what is behind it.
    #[inline(always)]
    pub fn over(
        &self,
        blend: &Blend<'_>,
        mut pixel: Pixel<'_>,
        depth: Depth,
        behind: P::Stored,
    ) -> P::Stored {
        if let Some(haze) = self.runs.source.part.haze {
            let mut fog_row = self.fog_row.get();
            pixel.lit = haze.over(pixel.lit, depth, &mut fog_row);
            self.fog_row.set(fog_row);
        }
        self.runs.paint.blend(&pixel, behind, blend)
    }
}
