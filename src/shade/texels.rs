//! The kernels for texels of one copy of a texture that need no wrapping pixel by pixel and are
//! not blended.

use crate::math::{Depth, keep_rolled};
use crate::raster::{FINE, RUN_FRACTION};
use crate::scene::NO_TEXEL;

/// Fractional bits of a light level.
pub(super) const LIGHT_FRACTION: u32 = RUN_FRACTION + FINE;

/// What the kernel steps.
pub(super) struct Cursor<'a> {
    pub texels: &'a [u8],
    pub at: [u32; 2],
    /// As of [`Fours`](crate::raster::Fours).
    pub step: [u32; 2],
    pub bend: [u32; 2],
    pub twist: [u32; 2],
    /// As of [`Cut`](super::cut::Cut).
    pub rows: u32,
    pub columns: u32,
    pub down: u32,
    /// The third attribute with the same.
    pub light: [i32; 4],
}

impl Cursor<'_> {
    /// The kernel where every pixel is seen, and depths are in place: with them as well,
    /// half of its numbers would find no register.
    #[inline(always)]
    pub fn draw_all(&self, indices: &mut [u8], shade: &impl Fn(i32, i32, u8) -> u8) {
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
    pub fn after(&self, pixels: usize) -> Self {
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
pub(super) fn draw<const OUTLINED: bool>(
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
