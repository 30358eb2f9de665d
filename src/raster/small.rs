//! Triangles of a few pixels, which most of a fine mesh are: no edge is divided, and
//! all products have 32 bits. Same coverage as [`scan`](super::scan), to the last bit.
//!
//! First the rows' spans, by following each edge down, a pixel aside at a time, by the
//! sign of its edge function (Pineda, "A parallel algorithm for polygon rasterization",
//! 1988); then the attributes, if there is a pixel; then the pixels. In one pass, edges
//! and attributes together would not fit into a processor's registers.

use core::ops::Range;

use super::attribute::Attribute;
use super::gradient::SmallPlane;
use super::span::{self, Fill};
use super::triangle::{Seen, first_centre, sort};
use crate::frame::Target;
use crate::math::{Depth, HALF_PX, SUBPX_BITS, SubPx};
use crate::vertex::ScreenVertex;

/// Most columns and rows from one vertex to another.
const PIXELS: usize = 16;

/// Whether a triangle is small enough, and within the target's columns.
#[inline(always)]
pub(super) fn is_small(seen: &Seen, target: &Target<'_>) -> bool {
    let [[left, top], [right, bottom]] = seen.bounds;
    let size = (right - left) | (bottom - top);
    size < (PIXELS as i32) << SUBPX_BITS
        && left >= 0
        && right >> SUBPX_BITS < i32::from(target.width)
}

/// For each row a column, from the triangle's leftmost.
type Columns = [u8; PIXELS];

/// Fills a small triangle; `false` if its attributes exceed the formats.
#[inline(always)]
pub(super) fn fill_small(
    target: &mut Target<'_>,
    triangle: [&ScreenVertex; 3],
    seen: &Seen,
    fill: Fill<'_>,
) -> bool {
    let [[left, _], _] = seen.bounds;
    let column = left >> SUBPX_BITS;
    let (first, end) = seen.rows;
    let (sorted, flipped) = sort(triangle.map(|v| (v, ())));
    let [top, middle, bottom] = sorted.map(|(v, ())| v);
    // Whether the middle vertex is to the right of the long edge.
    let long_is_left = (seen.area > 0) != flipped;
    let bend = first_centre(middle.y().to_bits()).max(first).min(end);

    // Of each row the first pixel, and the one after the last.
    let (mut lefts, mut rights) = (Columns::default(), Columns::default());
    let (long, short) = if long_is_left {
        (&mut lefts, &mut rights)
    } else {
        (&mut rights, &mut lefts)
    };
    follow(long, [top, bottom], column, first, first..end);
    follow(short, [top, middle], column, first, first..bend);
    follow(short, [middle, bottom], column, first, bend..end);

    let mut row = first;
    let at = |row: i32| ((row - first) as usize) % PIXELS;
    #[expect(clippy::indexing_slicing, reason = "held below the array's length")]
    while lefts[at(row)] >= rights[at(row)] {
        row += 1;
        if row >= end {
            return true;
        }
    }

    let plane = SmallPlane::new([top, middle, bottom], seen.area, long_is_left);
    let centre = |pixel: i32, v: SubPx| (pixel << SUBPX_BITS) + HALF_PX - v.to_bits();
    let place = [centre(column, top.x()), centre(row, top.y())];
    let [za, zb, zc] = [top, middle, bottom].map(|v| v.z().to_bits() as i32);
    let Some(gradient) = plane.depth(zb - za, zc - za) else {
        return false;
    };
    if gradient.is_steep() {
        return false;
    }
    let z = Attribute::beside((za as u32) << 12, gradient, place);
    let start = (row - i32::from(target.top)) * i32::from(target.stride) + column;
    let rows = Rows {
        lefts: &lefts,
        rights: &rights,
        numbers: (row - first) as usize..(end - first) as usize,
        start,
    };
    match fill {
        Fill::Depth => {}
        Fill::Flat(index) => {
            rows.draw(target, z, Attribute::default(), |span, z, dz, _, _| {
                span::flat(span.indices, span.depths, z, dz, index);
            });
        }
        Fill::Gouraud(shades) => {
            let [la, lb, lc] = [top, middle, bottom].map(|v| i32::from(v.level().to_bits()));
            let Some(gradient) = plane.level(lb - la, lc - la) else {
                return false;
            };
            let level = Attribute::beside((la as u32) << 10, gradient, place);
            rows.draw(target, z, level, |span, z, dz, level, dl| {
                span::gouraud::<true>(span.indices, span.depths, (z, dz), (level, dl), shades);
            });
        }
    }
    true
}

/// Writes, for some rows, the first pixel whose centre is not left of an edge.
#[inline(always)]
fn follow(
    columns: &mut Columns,
    [upper, lower]: [&ScreenVertex; 2],
    column: i32,
    first: i32,
    rows: Range<i32>,
) {
    if rows.is_empty() {
        return;
    }
    let (x, y) = (upper.x().to_bits(), upper.y().to_bits());
    let (dx, dy) = (lower.x().to_bits() - x, lower.y().to_bits() - y);
    // Pixels are tried from the vertex on in the edge's direction; none on the other
    // side can be the first.
    let top = first_centre(y);
    let mut at = (x >> SUBPX_BITS) - (dx >> 31);
    let across = (at << SUBPX_BITS) + HALF_PX - x;
    let down = (top << SUBPX_BITS) + HALF_PX - y;
    // The edge function at a pixel's centre, negative left of the edge, without the
    // bits that no step to another pixel changes: of 30 bits, 18.
    let mut value = ((dy * across - dx * down) >> SUBPX_BITS) - dx * (rows.start - top);
    at -= column;
    let numbers = (rows.start - first)..(rows.end - first);
    if dx >= 0 {
        for number in numbers {
            while value < 0 {
                value += dy;
                at += 1;
            }
            #[expect(clippy::indexing_slicing, reason = "held below the array's length")]
            {
                columns[number as usize % PIXELS] = at as u8;
            }
            value -= dx;
        }
    } else {
        for number in numbers {
            while value >= dy {
                value -= dy;
                at -= 1;
            }
            #[expect(clippy::indexing_slicing, reason = "held below the array's length")]
            {
                columns[number as usize % PIXELS] = at as u8;
            }
            value -= dx;
        }
    }
}

/// The rows of a triangle, from the first with a pixel on.
struct Rows<'a> {
    lefts: &'a Columns,
    rights: &'a Columns,
    /// Which of those.
    numbers: Range<usize>,
    /// The leftmost column's place in the first of them, in the target.
    start: i32,
}

/// The pixels of a row.
struct Span<'t> {
    indices: &'t mut [u8],
    depths: &'t mut [Depth],
}

impl Rows<'_> {
    /// Hands on each row's pixels, with the attributes of the first and their steps.
    #[inline(always)]
    fn draw(
        self,
        target: &mut Target<'_>,
        mut z: Attribute,
        mut level: Attribute,
        draw: impl Fn(Span<'_>, u32, i32, u32, i32),
    ) {
        let stride = i32::from(target.stride);
        let mut start = self.start;
        for number in self.numbers {
            #[expect(clippy::indexing_slicing, reason = "held below the array's length")]
            let [left, right] =
                [self.lefts, self.rights].map(|side| i32::from(side[number % PIXELS]));
            if left < right {
                let pixels = (start + left) as usize..(start + right) as usize;
                if let (Some(indices), Some(depths)) = (
                    target.indices.get_mut(pixels.clone()),
                    target.depths.get_mut(pixels),
                ) {
                    let span = Span { indices, depths };
                    let (z_here, level_here) = (z.at(left), level.at(left));
                    draw(span, z_here, z.gradient.x, level_here, level.gradient.x);
                }
            }
            z.advance();
            level.advance();
            start += stride;
        }
    }
}
