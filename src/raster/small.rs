//! Triangles of a few pixels, which most of a fine mesh are: no edge is divided, and
//! all products have 32 bits. Same coverage as [`scan`](super::scan), to the last bit.
//!
//! First the rows' spans, by following each edge down, a pixel aside at a time, by the
//! sign of its edge function (Pineda, "A parallel algorithm for polygon rasterization",
//! 1988); then the attributes, if there is a pixel; then the pixels. Each is a function of
//! its own: together they would not fit into a processor's registers.

use core::ops::Range;

use super::attribute::Attribute;
use super::attributes::steep_depth;
use super::gradient::SmallPlane;
use super::span::{self, Fill};
use super::triangle::Seen;
use crate::frame::Target;
use crate::math::{Depth, HALF_PX, SUBPX_BITS, SubPx, keep_rolled};
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

/// Of each row, from the leftmost vertex's column: the first pixel, and the one after the
/// last; then the row's number, and a byte that makes it a word.
type Spans = [[u8; 4]; PIXELS];

/// Rows without pixels. Numbers are read back instead of counted: what is counted along
/// takes registers through a row's pixels, which have none to spare.
const EMPTY: Spans = {
    let mut spans = [[0; 4]; PIXELS];
    let mut row = 0;
    while row < PIXELS {
        #[expect(clippy::indexing_slicing, reason = "evaluated by the compiler")]
        {
            spans[row] = [0, 0, row as u8, 0];
        }
        row += 1;
    }
    spans
};

/// A small triangle of which a pixel was found.
struct Small {
    spans: Spans,
    /// Rows that may have pixels.
    numbers: Range<usize>,
    /// The leftmost column's place in row 0, in the target.
    start: i32,
    /// At the leftmost column of row 0.
    z: Attribute,
    level: Attribute,
}

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
    let [a, b, c] = triangle;
    // Counter-clockwise on the screen: what goes down is on the left.
    let triangle = if seen.area < 0 { [a, b, c] } else { [a, c, b] };
    let mut small = Small {
        spans: EMPTY,
        numbers: 0..(end - first) as usize,
        start: (first - i32::from(target.top)) * i32::from(target.stride) + column,
        z: Attribute::default(),
        level: Attribute::default(),
    };
    find_spans(&mut small.spans, triangle, [column, first], end - first);
    let Some(empty) = small
        .spans
        .iter()
        .position(|[left, right, ..]| left < right)
    else {
        return true;
    };
    small.numbers.start = empty;
    let place = [column, first];
    match fill {
        Fill::Depth => {}
        Fill::Flat(index) => {
            if !small.set_planes::<false>(triangle, seen, place) {
                return false;
            }
            small.draw_flat(target, index);
        }
        Fill::Gouraud(shades) => {
            if !small.set_planes::<true>(triangle, seen, place) {
                return false;
            }
            small.draw_gouraud(target, shades);
        }
    }
    true
}

/// Finds the pixels of `count` rows between the edges of a triangle, from a pixel on that
/// is not right of it.
#[inline(never)]
fn find_spans(
    spans: &mut Spans,
    triangle: [&ScreenVertex; 3],
    [column, row]: [i32; 2],
    count: i32,
) {
    // From the pixel's left edge, and so that whole parts of y are the first rows at or
    // below a vertex.
    let left = column << SUBPX_BITS;
    let above = (HALF_PX - 1) - (row << SUBPX_BITS);
    let [a, b, c] = triangle.map(|v| [v.x().to_bits() - left, v.y().to_bits() + above]);
    follow(spans, a, b, count);
    follow(spans, b, c, count);
    follow(spans, c, a, count);
}

/// Writes, for the rows of an edge, the first pixel whose centre is not left of it.
#[inline(always)]
fn follow(spans: &mut Spans, from: [i32; 2], to: [i32; 2], count: i32) {
    let ([_, y], [_, y_end]) = (from, to);
    if y < y_end {
        follow_down::<true>(spans, from, to, count);
    } else {
        follow_down::<false>(spans, to, from, count);
    }
}

/// The first pixel of a row, or the one after the last.
#[inline(always)]
fn side<const LEFT: bool>([left, right, ..]: &mut [u8; 4]) -> &mut u8 {
    if LEFT { left } else { right }
}

#[inline(always)]
fn follow_down<const LEFT: bool>(
    spans: &mut Spans,
    [x, y]: [i32; 2],
    [x_end, y_end]: [i32; 2],
    count: i32,
) {
    const FRACTION: i32 = (1 << SUBPX_BITS) - 1;
    let top = y >> SUBPX_BITS;
    let end = (y_end >> SUBPX_BITS).min(count);
    let Some(rows) = spans.get_mut(top.max(0) as usize..end as usize) else {
        return;
    };
    if rows.is_empty() {
        return;
    }
    let (dx, dy) = (x_end - x, y_end - y);
    // From the vertex to centres of its column and of the edge's first row.
    let across = HALF_PX - (x & FRACTION);
    let down = !y & FRACTION;
    // The edge function at a pixel's centre, negative left of the edge, without the
    // bits that no step to another pixel changes: of 30 bits, 18.
    let mut value = (dy * across - dx * down) >> SUBPX_BITS;
    if top < 0 {
        value += dx * top;
    }
    // Pixels are tried from the vertex on in the edge's direction; none on the other
    // side can be the first.
    let mut at = x >> SUBPX_BITS;
    if dx >= 0 {
        for row in rows {
            while value < 0 {
                value += dy;
                at += 1;
                keep_rolled();
            }
            *side::<LEFT>(row) = at as u8;
            value -= dx;
        }
    } else {
        // The value is that of the pixel to the left.
        at += 1;
        for row in rows {
            while value >= 0 {
                value -= dy;
                at -= 1;
                keep_rolled();
            }
            *side::<LEFT>(row) = at as u8;
            value -= dx;
        }
    }
}

impl Small {
    /// Sets depth and level at a pixel; `false` if they exceed the formats.
    #[inline(never)]
    fn set_planes<const LEVEL: bool>(
        &mut self,
        triangle: [&ScreenVertex; 3],
        seen: &Seen,
        [column, row]: [i32; 2],
    ) -> bool {
        let [a, ..] = triangle;
        let plane = SmallPlane::new(triangle, seen.area.unsigned_abs() as u32);
        let centre = |pixel: i32, v: SubPx| (pixel << SUBPX_BITS) + HALF_PX - v.to_bits();
        let place = [centre(column, a.x()), centre(row, a.y())];
        if LEVEL {
            let levels = triangle.map(|v| i32::from(v.level().to_bits()));
            let [la, lb, lc] = levels.map(|level| level >> 2);
            let Some(gradient) = plane.level(lb - la, lc - la) else {
                return false;
            };
            self.level = Attribute::beside((la as u32) << 12, gradient, place);
        }
        let depths = triangle.map(|v| v.z().to_bits() as i32);
        let [za, zb, zc] = depths;
        if let Some(gradient) = plane.depth(zb - za, zc - za) {
            self.z = Attribute::beside((za as u32) << 12, gradient, place);
            return true;
        }
        let steep = steep_depth(triangle, -seen.area.abs(), depths, row);
        if let Some(z) = steep {
            self.z = z.aside(column - (a.x().to_bits() >> SUBPX_BITS));
        }
        steep.is_some()
    }

    #[inline(never)]
    fn draw_flat(&self, target: &mut Target<'_>, index: u8) {
        self.draw(target, |span, z, dz, _, _| {
            span::flat(span.indices, span.depths, z, dz, index);
        });
    }

    #[inline(never)]
    fn draw_gouraud(&self, target: &mut Target<'_>, shades: &[u8; 256]) {
        self.draw(target, |span, z, dz, level, dl| {
            span::gouraud(span.indices, span.depths, (z, dz), (level, dl), shades);
        });
    }

    /// Hands on each row's pixels, with the attributes of the first and their steps.
    #[inline(always)]
    fn draw(&self, target: &mut Target<'_>, draw: impl Fn(Span<'_>, u32, i32, u32, i32)) {
        let stride = i32::from(target.stride);
        let spans = self.spans.get(self.numbers.clone()).unwrap_or_default();
        for [left, right, row, _] in spans {
            let [left, right, row] = [*left, *right, *row].map(i32::from);
            if left < right {
                let start = self.start + row * stride;
                let pixels = (start + left) as usize..(start + right) as usize;
                if let (Some(indices), Some(depths)) = (
                    target.indices.get_mut(pixels.clone()),
                    target.depths.get_mut(pixels),
                ) {
                    let span = Span { indices, depths };
                    let Self { z, level, .. } = self;
                    let (z_here, level_here) = (z.below(row, left), level.below(row, left));
                    draw(span, z_here, z.gradient.x, level_here, level.gradient.x);
                }
            }
        }
    }
}

/// The pixels of a row.
struct Span<'t> {
    indices: &'t mut [u8],
    depths: &'t mut [Depth],
}
