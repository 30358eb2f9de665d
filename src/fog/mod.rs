//! Fog over finished pixels. In: the depths and indices of a
//! [`Target`], a view, and the scene's table of fogged
//! indices. Out: the indices, fogged. Used by `render` between a viewport's opaque
//! triangles and what lies over it, and by `ray` after a pass.
//!
//! By then each pixel is decided, so that fog costs one look-up a pixel, however
//! often it was drawn over and whatever it was shaded by. A pixel's depth says how
//! far away it is; where nothing was drawn there is no fog, as in OpenGL and VTK.
#![expect(
    clippy::arithmetic_side_effects,
    reason = "depths of 16 bits and the rows of a table, in wider integers; tests stop at overflow"
)]

use crate::frame::Target;
use crate::math::{Depth, reciprocal};
use crate::scene::layout::FOG_ROWS;
use crate::view::{DepthMap, ViewFrame};

/// Steps between rows of a fog table.
const STEPS: usize = FOG_ROWS - 1;

/// Which depths belong to which row of the fog table, in one view.
#[derive(Clone, Copy, Debug)]
pub struct FogDepths {
    /// Depths below the one at `r` are of row `r + 1` or a thicker one.
    below: [Depth; STEPS],
}

impl FogDepths {
    /// For `distances` along the line of sight at which each next row begins:
    /// raw [`World`](crate::math::World) bits, not falling.
    pub fn new(view: &ViewFrame, distances: &[i32; STEPS]) -> Self {
        // Only a parallel view's near plane can be farther than a world length.
        let bits = 64 - view.near.unsigned_abs().leading_zeros() as i32;
        let down = (bits - 30).max(0);
        let map = DepthMap::new(view, 16 - down, (view.near >> down) as i32);
        let depth = |distance: i32| {
            let distance = (distance >> down).max(1);
            let depth = map.depth(distance, reciprocal(distance as u32));
            ((depth.to_bits() + 8) >> 4) as Depth
        };
        Self {
            below: distances.map(depth),
        }
    }

    /// The row of a depth, found from that of a pixel nearby.
    fn row(&self, depth: Depth, mut row: usize) -> usize {
        while self.below.get(row).is_some_and(|below| depth < *below) {
            row += 1;
        }
        while let Some(before) = row.checked_sub(1) {
            if self.below.get(before).is_none_or(|below| depth < *below) {
                break;
            }
            row = before;
        }
        row
    }

    /// The depths of a row: the least, and one past the largest.
    fn range(&self, row: usize) -> (u32, u32) {
        let least = self.below.get(row).map_or(1, |depth| u32::from(*depth));
        let before = row.checked_sub(1).and_then(|row| self.below.get(row));
        (least, before.map_or(1 << 16, |depth| u32::from(*depth)))
    }
}

/// Fog before single pixels.
#[derive(Clone, Copy, Debug)]
pub struct Haze {
    /// How much there is.
    pub depths: FogDepths,
    /// Its colour.
    pub colour: [u8; 3],
}

impl Haze {
    /// A colour behind the fog that is before a depth, in 1/64 of a level; `row` is that
    /// of a pixel nearby, and becomes that of this one.
    #[inline(always)]
    pub fn over(&self, mut colour: [u16; 3], depth: Depth, row: &mut usize) -> [u16; 3] {
        *row = self.depths.row(depth, *row);
        // Of 1024, from none to all in 31 steps.
        let part = (*row * 33 + (*row >> 4)) as i32;
        for (c, fog) in colour.iter_mut().zip(self.colour) {
            let own = i32::from(*c);
            let change = ((i32::from(fog) << 6) - own) * part;
            *c = (own + ((change + (1 << 9)) >> 10)) as u16;
        }
        colour
    }
}

/// Fogs all that was drawn. Of `table`, a row says what each index becomes: the
/// first is no fog, the last is all fog.
pub fn apply(target: &mut Target<'_>, table: &[[u8; 256]; FOG_ROWS], depths: &FogDepths) {
    let width = usize::from(target.width);
    let stride = usize::from(target.stride).max(1);
    let mut row = 0;
    for (mut indices, mut depths_here) in target
        .indices
        .chunks_mut(stride)
        .zip(target.depths.chunks(stride))
    {
        indices = indices.get_mut(..width).unwrap_or_default();
        depths_here = depths_here.get(..width).unwrap_or_default();
        while let Some(depth) = depths_here.first() {
            let done = if *depth == 0 {
                depths_here.iter().take_while(|depth| **depth == 0).count()
            } else {
                row = depths.row(*depth, row);
                run(indices, depths_here, depths.range(row), shades(table, row))
            };
            indices = indices.get_mut(done..).unwrap_or_default();
            depths_here = depths_here.get(done..).unwrap_or_default();
        }
    }
}

/// Hands on each pixel that was drawn, with its depth and the row of a pixel nearby; see
/// [`Haze::over`].
pub fn each<C>(target: &mut Target<'_, C>, mut fogged: impl FnMut(&mut C, Depth, &mut usize)) {
    let width = usize::from(target.width);
    let stride = usize::from(target.stride).max(1);
    let mut row = 0;
    let rows = target.indices.chunks_mut(stride);
    for (pixels, depths) in rows.zip(target.depths.chunks(stride)) {
        for (pixel, depth) in pixels.iter_mut().zip(depths).take(width) {
            if *depth != 0 {
                fogged(pixel, *depth, &mut row);
            }
        }
    }
}

/// Fogs the first pixels, as far as their depths are in a row's range; says how many.
/// About 11 instructions a pixel on Cortex-M4.
#[inline(always)]
fn run(
    indices: &mut [u8],
    depths: &[Depth],
    (least, end): (u32, u32),
    shades: &[u8; 256],
) -> usize {
    let span = end.wrapping_sub(least);
    let mut count = 0;
    for (pixel, depth) in indices.iter_mut().zip(depths) {
        if u32::from(*depth).wrapping_sub(least) >= span {
            break;
        }
        #[expect(clippy::indexing_slicing, reason = "a byte indexes 256 entries")]
        {
            *pixel = shades[usize::from(*pixel)];
        }
        count += 1;
    }
    count
}

fn shades(table: &[[u8; 256]; FOG_ROWS], row: usize) -> &[u8; 256] {
    #[expect(clippy::indexing_slicing, reason = "held below the array's length")]
    &table[row % FOG_ROWS]
}

#[cfg(test)]
mod tests;
