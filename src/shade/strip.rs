//! Runs of texels that need no wrapping pixel by pixel: their ways through one copy of a texture,
//! from attributes to what the kernels step.

use super::cut::{Cut, LARGEST, PLACE_BITS};
use super::texels::{Cursor, LIGHT_FRACTION, draw};
use super::texture::{Copied, Places, Sampler, coordinates};
use crate::math::Depth;
use crate::raster::{Cubic, FINE, Fours, Run, Values};
use crate::scene::Wrap;

/// A run's way through one copy of a texture, in the same period at both ends.
#[derive(Clone, Copy, Debug)]
pub struct Strip<'a> {
    copy: Copied<'a>,
    /// Of its pixels, mirrored where the texture is.
    way: Fours<2>,
    /// Of its pixels.
    pub places: Fours<2>,
    /// The third attribute, if there is one.
    light: Fours<1>,
    /// Whether texels are cut out: places go along parabolas then.
    outlined: bool,
}

impl<'a> Sampler<'a> {
    /// The way of a run whose first two attributes are texture coordinates; `None` if
    /// it goes over an edge at which the texture does not go on by itself. And how many of its
    /// pixels show one copy of the picture.
    #[inline(always)]
    pub fn strip<const A: usize>(&self, run: &Run<'_, A>) -> Option<(Strip<'a>, usize)> {
        let places = self.places(&run.path);
        let (copy, count) = self.copy(run);
        let outlined = self.texture.cut_out;
        let fours = places.in_fours(outlined);
        let last = count.saturating_sub(1) as i32;
        let light = Places {
            from: third(run.path.from),
            step: third(run.path.step),
            bend: third(run.path.bend),
        };
        let strip = Strip {
            copy: *copy,
            way: self.within(fours, || [places.from, places.at(last)])?,
            places: fours,
            light: light.in_fours(false),
            outlined,
        };
        Some((strip, count))
    }

    /// Whether the kernel has room for all bits of cubics.
    #[inline(always)]
    pub fn has_cubics(&self) -> bool {
        let [width, height] = self.texture.size;
        width + height <= LARGEST
    }

    /// The same of pixels that go along cubics and show a copy of the picture.
    #[inline(always)]
    pub fn strip_of<const A: usize, C>(&self, pixels: &Cubic<'_, A, C>) -> Option<Strip<'a>> {
        let fours = self.places_in_fours(&pixels.fours);
        let ends = || {
            pixels
                .ends
                .each_ref()
                .map(|values| self.place(coordinates(values)))
        };
        let Fours {
            from,
            step,
            bend,
            twist,
        } = pixels.fours;
        Some(Strip {
            copy: *self.copied(pixels.alike),
            way: self.within(fours, ends)?,
            places: fours,
            light: Fours {
                from: third(from),
                step: third(step),
                bend: third(bend),
                twist: third(twist),
            },
            outlined: self.texture.cut_out,
        })
    }

    /// Places as in the first period, if the ends are in one, and in the first if what is
    /// beyond it looks otherwise.
    #[inline(always)]
    fn within(&self, fours: Fours<2>, ends: impl Fn() -> [[i32; 2]; 2]) -> Option<Fours<2>> {
        if self.texture.wrap == Wrap::Repeat {
            return Some(fours);
        }
        let [first, last] = ends();
        let mut way = fours;
        let each = way
            .from
            .iter_mut()
            .zip(&mut way.step)
            .zip(&mut way.bend)
            .zip(&mut way.twist);
        let each = each.zip(first).zip(last).zip(self.texture.size);
        for ((((((from, step), bend), twist), first), last), size) in each {
            let period = |c: i32| c >> (PLACE_BITS + i32::from(size)).min(31);
            let first = period(first);
            if first != period(last) || self.texture.wrap == Wrap::Clamp && first != 0 {
                return None;
            }
            if first & 1 != 0 {
                // Mirrored: downwards from the last texel.
                *from = !*from;
                for change in [step, bend, twist] {
                    *change = change.wrapping_neg();
                }
            }
        }
        Some(way)
    }
}

/// The third of some values, 0 if there is none.
#[inline(always)]
fn third<const A: usize>(values: Values<A>) -> [i32; 1] {
    [values.get(2).copied().unwrap_or(0)]
}

impl Strip<'_> {
    /// Goes through the pixels of a run that are nearer than what stands there and show
    /// a texel. `shade` gets the pixel's number in the run, the third attribute (if
    /// there is one), rounded, and the base colour, and gives the index.
    #[inline(always)]
    pub fn draw<const A: usize>(&self, run: Run<'_, A>, shade: impl Fn(i32, i32, u8) -> u8) {
        let (indices, depths, seen) = (run.indices, run.depths, run.seen);
        if seen == 0 {
            return self.draw_nearer(indices, (depths, run.depth), shade);
        }
        let cursor = self.cursor();
        let more = seen < indices.len();
        cursor.draw_all(indices.get_mut(..seen).unwrap_or_default(), &shade);
        // From the four on in which the last of those is: they are not nearer than themselves.
        let seen = seen & !3;
        if more
            && let Some(indices) = indices.get_mut(seen..)
            && let Some(depths) = depths.get_mut(seen..)
        {
            let (z, dz) = run.depth;
            let depth = (z.wrapping_add_signed(dz.wrapping_mul(seen as i32)), dz);
            let cursor = cursor.after(seen);
            draw::<false>(indices, depths, depth, (&cursor, seen as i32), &shade);
        }
    }

    /// Goes through pixels that are nearer than what stands there and show a texel.
    #[inline(always)]
    pub fn draw_nearer(
        &self,
        indices: &mut [u8],
        (depths, depth): (&mut [Depth], (u32, i32)),
        shade: impl Fn(i32, i32, u8) -> u8,
    ) {
        let cursor = self.cursor();
        if self.outlined {
            draw::<true>(indices, depths, depth, (&cursor, 0), &shade);
        } else {
            draw::<false>(indices, depths, depth, (&cursor, 0), &shade);
        }
    }

    /// Goes through pixels that are all seen and have their depths in place.
    #[inline(always)]
    pub fn draw_all(&self, indices: &mut [u8], shade: impl Fn(i32, i32, u8) -> u8) {
        self.cursor().draw_all(indices, &shade);
    }

    #[inline(always)]
    fn cursor(&self) -> Cursor<'_> {
        let cut = self.copy.cut;
        let Cut {
            rows,
            columns,
            down,
            ..
        } = cut;
        let Fours {
            from,
            step,
            bend,
            twist,
        } = self.way;
        let ([light], [change], [turn], [twist_of_light]) = (
            self.light.from,
            self.light.step,
            self.light.bend,
            self.light.twist,
        );
        Cursor {
            texels: self.copy.texels,
            at: cut.both(from),
            step: cut.both_fine(step),
            bend: cut.both_fine(bend),
            twist: cut.both_fine(twist),
            rows,
            columns,
            down,
            light: [
                (light << FINE).wrapping_add(1 << (LIGHT_FRACTION - 1)),
                change,
                turn,
                twist_of_light,
            ],
        }
    }
}
