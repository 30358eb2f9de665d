//! Runs of texels that need no wrapping pixel by pixel: the kernel for textures that
//! are not blended.

use super::texture::{Copied, PLACE_BITS, Places, Sampler, coordinates};
use crate::math::{Depth, keep_rolled};
use crate::raster::{Cubic, FINE, Fours, RUN_FRACTION, Run, Values};
use crate::scene::{NO_TEXEL, Wrap};

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

/// `log2` of the texels of the largest picture whose places have [`FINE`] bits more in the kernel,
/// which long runs need: columns stand below the rows.
const LARGEST: u8 = 32 - PLACE_BITS as u8 - FINE as u8;

/// Fractional bits of a light level.
const LIGHT_FRACTION: u32 = RUN_FRACTION + FINE;

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

/// From places in the picture to a number that has a texel's in its highest bits. Rows
/// wrap above, columns are cut out below them, so what repeats does so by itself.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Cut {
    /// What places are multiplied by: texels of the picture to 2^32 a picture.
    times: [u32; 2],
    /// A right shift of columns to below the rows.
    rows: u32,
    /// The bits of the column and of what is below it.
    columns: u32,
    /// A right shift to a texel's number.
    down: u32,
}

impl Cut {
    /// For a copy of a picture, both with `log2` of their sizes.
    pub fn new([w, h]: [u32; 2], [width, height]: [u32; 2]) -> Self {
        let whole = 32 - PLACE_BITS as u32;
        // A shift by 32, for a copy of one texel, does not exist: its places are all 0.
        let some = u32::from(w + h != 0);
        Self {
            times: [width, height].map(|size| some << (whole - size)),
            rows: h,
            columns: u32::MAX >> h,
            down: (32 - w - h).min(31),
        }
    }

    /// From a place, or a change of one, to numbers that a texel's is made of.
    #[inline(always)]
    fn both(&self, place: [i32; 2]) -> [u32; 2] {
        self.times(place, self.times)
    }

    /// The same of what has [`FINE`] fractional bits more, for which there is room in those numbers
    /// if pictures are no larger than [`LARGEST`].
    #[inline(always)]
    fn both_fine(&self, place: [i32; 2]) -> [u32; 2] {
        self.times(place, self.times.map(|times| times >> FINE))
    }

    #[inline(always)]
    fn times(&self, [x, y]: [i32; 2], [across, along]: [u32; 2]) -> [u32; 2] {
        let x = (x as u32).wrapping_mul(across) >> (self.rows & 31);
        [x, (y as u32).wrapping_mul(along)]
    }

    /// The number of the texel at a place.
    #[inline(always)]
    pub(super) fn texel(&self, place: [i32; 2]) -> usize {
        let [x, y] = self.both(place);
        (((x ^ y) & self.columns ^ y) >> (self.down & 31)) as usize
    }
}

/// What the kernel steps.
struct Cursor<'a> {
    texels: &'a [u8],
    at: [u32; 2],
    /// As of [`Fours`].
    step: [u32; 2],
    bend: [u32; 2],
    twist: [u32; 2],
    /// As of [`Cut`].
    rows: u32,
    columns: u32,
    down: u32,
    /// The third attribute with the same.
    light: [i32; 4],
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

impl Cursor<'_> {
    /// The kernel where every pixel is seen, and depths are in place: with them as well,
    /// half of its numbers would find no register.
    #[inline(always)]
    fn draw_all(&self, indices: &mut [u8], shade: &impl Fn(i32, i32, u8) -> u8) {
        let [light, change, turn, twist] = self.light;
        if change | turn | twist == 0 {
            // As on flat sides.
            let level = light >> LIGHT_FRACTION;
            texels(self, indices, |number, _, texel| {
                shade(number, level, texel)
            });
        } else {
            texels(self, indices, shade);
        }
    }

    /// After some pixels of a parabola: whole fours.
    #[inline(always)]
    fn after(&self, pixels: usize) -> Self {
        let fours = (pixels / 4) as u32;
        // Of the first n fours' steps, the sum of 0..n.
        let bends = (fours * fours.wrapping_sub(1)) >> 1;
        let along = |at: u32, step: u32, bend: u32| {
            let steps = step
                .wrapping_mul(fours)
                .wrapping_add(bend.wrapping_mul(bends));
            (
                at.wrapping_add(steps << 2),
                step.wrapping_add(bend.wrapping_mul(fours)),
            )
        };
        let ([x, y], [dx, dy], [bx, by]) = (self.at, self.step, self.bend);
        let ((x, dx), (y, dy)) = (along(x, dx, bx), along(y, dy, by));
        let [light, change, turn, twist] = self.light;
        let (light, change) = along(light as u32, change as u32, turn as u32);
        Self {
            at: [x, y],
            step: [dx, dy],
            light: [light as i32, change as i32, turn, twist],
            ..*self
        }
    }
}

/// A function of its own, whose loop wants all registers.
#[inline(never)]
fn texels(cursor: &Cursor<'_>, indices: &mut [u8], shade: impl Fn(i32, i32, u8) -> u8) {
    let Cursor {
        texels,
        at: [mut x, mut y],
        step: [mut dx, mut dy],
        bend: [mut bx, mut by],
        twist: [tx, ty],
        columns,
        down,
        light: [mut light, mut change, mut turn, twist],
        ..
    } = *cursor;
    // Whatever the shift leaves, it is below this: then there is no check, and no branch.
    let Some(last) = texels.len().checked_sub(1) else {
        return;
    };
    let mut number = 0;
    let mut one = |pixel: &mut u8, [dx, dy]: [u32; 2], change: i32| {
        let texel = ((x ^ y) & columns ^ y) >> (down & 31);
        if let Some(&texel) = texels.get(texel as usize & last) {
            *pixel = shade(number, light >> LIGHT_FRACTION, texel);
        }
        (x, y) = (x.wrapping_add(dx), y.wrapping_add(dy));
        light = light.wrapping_add(change);
        number += 1;
    };
    let (fours, rest) = indices.as_chunks_mut::<4>();
    for [a, b, c, d] in fours {
        one(a, [dx, dy], change);
        one(b, [dx, dy], change);
        one(c, [dx, dy], change);
        one(d, [dx, dy], change);
        (dx, dy) = (dx.wrapping_add(bx), dy.wrapping_add(by));
        (bx, by) = (bx.wrapping_add(tx), by.wrapping_add(ty));
        change = change.wrapping_add(turn);
        turn = turn.wrapping_add(twist);
    }
    for pixel in rest {
        one(pixel, [dx, dy], change);
        keep_rolled();
    }
}

/// The kernel for pixels that may be hidden, or show none of the picture: its loop wants all
/// registers.
#[inline(never)]
fn draw<const OUTLINED: bool>(
    indices: &mut [u8],
    depths: &mut [Depth],
    (mut z, dz): (u32, i32),
    (cursor, mut number): (&Cursor<'_>, i32),
    shade: &impl Fn(i32, i32, u8) -> u8,
) {
    let Cursor {
        texels,
        at: [mut x, mut y],
        step: [mut dx, mut dy],
        bend: [mut bx, mut by],
        twist: [tx, ty],
        rows,
        columns,
        down,
        light: [mut light, mut change, mut turn, twist],
    } = *cursor;
    // Whatever the shift leaves, it is below this: then there is no check.
    let Some(last) = texels.len().checked_sub(1) else {
        return;
    };
    let (fours, indices) = indices.as_chunks_mut::<4>();
    let (four_depths, depths) = depths.as_chunks_mut::<4>();
    let mut one = |pixel: &mut u8, depth: &mut Depth, [dx, dy]: [u32; 2], change: i32| {
        let here = (z >> 16) as Depth;
        if here > *depth {
            let texel = ((x ^ y) & columns ^ y) >> (down & 31);
            if let Some(&texel) = texels.get(texel as usize & last)
                && texel != NO_TEXEL
            {
                *pixel = shade(number, light >> LIGHT_FRACTION, texel);
                *depth = here;
            }
        }
        z = z.wrapping_add_signed(dz);
        (x, y) = (x.wrapping_add(dx), y.wrapping_add(dy));
        light = light.wrapping_add(change);
        number += 1;
    };
    // Of outlines the step changes by a quarter of the bend from pixel to pixel, so that four
    // pixels are as long as a line.
    let curve = |[dx, dy]: [u32; 2], [bx, by]: [u32; 2]| {
        if !OUTLINED {
            return Curve {
                step: [dx, dy],
                bend: [0; 2],
            };
        }
        let eighths = [
            (bx << (rows & 31)) as i32 >> ((rows + 3) & 31),
            by as i32 >> 3,
        ];
        let [x, y] = eighths.map(|c| c as u32);
        Curve {
            step: [
                dx.wrapping_sub(x.wrapping_mul(3)),
                dy.wrapping_sub(y.wrapping_mul(3)),
            ],
            bend: [x << 1, y << 1],
        }
    };
    for ([a, b, c, d], [ad, bd, cd, dd]) in fours.iter_mut().zip(four_depths) {
        let mut now = curve([dx, dy], [bx, by]);
        one(a, ad, now.next(), change);
        one(b, bd, now.next(), change);
        one(c, cd, now.next(), change);
        one(d, dd, now.next(), change);
        (dx, dy) = (dx.wrapping_add(bx), dy.wrapping_add(by));
        change = change.wrapping_add(turn);
        // Others come in parabolas.
        if OUTLINED {
            (bx, by) = (bx.wrapping_add(tx), by.wrapping_add(ty));
            turn = turn.wrapping_add(twist);
        }
    }
    let mut now = curve([dx, dy], [bx, by]);
    for (pixel, depth) in indices.iter_mut().zip(depths) {
        one(pixel, depth, now.next(), change);
    }
}

/// Steps of four pixels, and how they change.
struct Curve {
    step: [u32; 2],
    bend: [u32; 2],
}

impl Curve {
    /// The next one.
    #[inline(always)]
    fn next(&mut self) -> [u32; 2] {
        let ([x, y], [turn_x, turn_y]) = (self.step, self.bend);
        self.step = [x.wrapping_add(turn_x), y.wrapping_add(turn_y)];
        [x, y]
    }
}
