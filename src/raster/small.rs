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
use super::gradient::{Gradient, SmallPlane};
use super::scan::Span;
use super::span::{self, Fill};
use super::triangle::Seen;
use crate::frame::Target;
use crate::math::{HALF_PX, SUBPX_BITS, SubPx, keep_rolled};
use crate::vertex::ScreenVertex;

/// Most columns and rows from one vertex to another.
const PIXELS: usize = 16;

/// Whether a triangle is small enough, and within the target's columns.
#[inline(always)]
pub(super) fn is_small<C>(seen: &Seen, target: &Target<'_, C>) -> bool {
    let [[left, top], [right, bottom]] = seen.bounds;
    let size = (right - left) | (bottom - top);
    size < (PIXELS as i32) << SUBPX_BITS
        && left >= 0
        && right >> SUBPX_BITS < i32::from(target.width)
}

/// Of each row, from the leftmost vertex's column: the first pixel, and the one after the
/// last; then the row's number, and a byte that makes it a word. Aligned as words are: they are
/// copied for each triangle, and cores that load words from their own places alone would go by bytes.
#[repr(align(4))]
struct Spans([[u8; 4]; PIXELS]);

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
    Spans(spans)
};

/// The rows of a small triangle of which a pixel was found.
pub(super) struct Rows {
    spans: Spans,
    /// Those that may have pixels.
    numbers: Range<usize>,
    /// The leftmost column's place in row 0, in the target.
    start: i32,
    /// The leftmost column, and row 0, on the screen.
    place: [i32; 2],
}

/// What changes over a small triangle, at the leftmost column of row 0.
pub(super) struct Planes<const N: usize> {
    z: Attribute,
    values: [Attribute; N],
}

/// The vertices of a small triangle with what goes with them, counter-clockwise on the screen:
/// what goes down is on the left.
#[inline(always)]
pub(super) fn turned<T>([a, b, c]: [T; 3], seen: &Seen) -> [T; 3] {
    if seen.area < 0 { [a, b, c] } else { [a, c, b] }
}

/// Fills a small triangle; `false` if its attributes exceed the formats.
#[inline(always)]
pub(super) fn fill_small(
    target: &mut Target<'_>,
    triangle: [&ScreenVertex; 3],
    seen: &Seen,
    fill: Fill<'_>,
) -> bool {
    let triangle = turned(triangle, seen);
    let mut rows = Rows::new(target, seen);
    if !rows.find(triangle) {
        return true;
    }
    match fill {
        Fill::Depth => {}
        Fill::Flat(index) => {
            let mut planes = Planes::ZERO;
            if !set_depth(&mut planes, triangle, seen, rows.place) {
                return false;
            }
            draw_flat(&rows, &planes, target, index);
        }
        Fill::Gouraud(shades) => {
            let mut planes = Planes::ZERO;
            if !set_depth_and_level(&mut planes, triangle, seen, rows.place) {
                return false;
            }
            draw_gouraud(&rows, &planes, target, shades);
        }
    }
    true
}

impl Rows {
    /// Of a triangle whose pixels are not known yet.
    #[inline(always)]
    pub(super) fn new<C>(target: &Target<'_, C>, seen: &Seen) -> Self {
        let [[left, _], _] = seen.bounds;
        let column = left >> SUBPX_BITS;
        let (first, end) = seen.rows;
        Self {
            spans: EMPTY,
            numbers: 0..(end - first) as usize,
            start: (first - i32::from(target.top)) * i32::from(target.stride) + column,
            place: [column, first],
        }
    }

    /// The pixel from which planes are to be set.
    pub(super) fn place(&self) -> [i32; 2] {
        self.place
    }

    /// Finds the pixels; `false` if there is none.
    #[inline(always)]
    pub(super) fn find(&mut self, triangle: [&ScreenVertex; 3]) -> bool {
        let count = self.numbers.end as i32;
        find_spans(&mut self.spans, triangle, self.place, count);
        let mut spans = self.spans.0.iter();
        let first = spans.position(|[left, right, ..]| {
            keep_rolled();
            left < right
        });
        self.numbers.start = first.unwrap_or(self.numbers.end);
        first.is_some()
    }

    /// The rows that may have pixels.
    #[inline(always)]
    pub(super) fn all(&self) -> &[[u8; 4]] {
        self.spans.0.get(self.numbers.clone()).unwrap_or_default()
    }

    /// A row's pixels, if it has some, with the attributes of the first.
    #[inline(always)]
    pub(super) fn span<'t, const N: usize, C>(
        &self,
        row: &[u8; 4],
        planes: &Planes<N>,
        target: &'t mut Target<'_, C>,
    ) -> Option<(Span<'t, C>, Steps<N>)> {
        let [left, right, row, _] = row.map(i32::from);
        if left >= right {
            return None;
        }
        let start = self.start + row * i32::from(target.stride);
        let pixels = (start + left) as usize..(start + right) as usize;
        let (Some(indices), Some(depths)) = (
            target.indices.get_mut(pixels.clone()),
            target.depths.get_mut(pixels),
        ) else {
            return None;
        };
        let [column, first] = self.place;
        let span = Span {
            indices,
            depths,
            place: [column + left, first + row],
        };
        let Planes { z, values } = planes;
        let steps = Steps {
            z: (z.below(row, left), z.gradient.x),
            values: values.each_ref().map(|v| v.below(row, left) as i32),
            change: values.each_ref().map(|v| v.gradient.x),
        };
        Some((span, steps))
    }
}

#[inline(never)]
fn draw_flat(rows: &Rows, planes: &Planes<0>, target: &mut Target<'_>, index: u8) {
    for row in rows.all() {
        if let Some((span, Steps { z: (z, dz), .. })) = rows.span(row, planes, target) {
            span::flat(span.indices, span.depths, z, dz, index);
        }
    }
}

#[inline(never)]
fn draw_gouraud(rows: &Rows, planes: &Planes<1>, target: &mut Target<'_>, shades: &[u8; 256]) {
    for row in rows.all() {
        if let Some((span, steps)) = rows.span(row, planes, target) {
            let ([level], [change]) = (steps.values, steps.change);
            let level = (level as u32, change);
            span::gouraud(span.indices, span.depths, steps.z, level, shades);
        }
    }
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
    let Some(rows) = spans.0.get_mut(top.max(0) as usize..end as usize) else {
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

#[inline(never)]
fn set_depth(
    planes: &mut Planes<0>,
    triangle: [&ScreenVertex; 3],
    seen: &Seen,
    place: [i32; 2],
) -> bool {
    planes.set(triangle, seen, place, |_, _| Some([]))
}

#[inline(never)]
fn set_depth_and_level(
    planes: &mut Planes<1>,
    triangle: [&ScreenVertex; 3],
    seen: &Seen,
    place: [i32; 2],
) -> bool {
    planes.set(triangle, seen, place, |plane, place| {
        let levels = triangle.map(|v| i32::from(v.level().to_bits()));
        let [a, b, c] = levels.map(|level| level >> 2);
        let gradient = plane.level(b - a, c - a)?;
        Some([Attribute::beside((a as u32) << 12, gradient, place)])
    })
}

impl<const N: usize> Planes<N> {
    /// Until they are set.
    pub(super) const ZERO: Self = Self {
        z: Attribute::ZERO,
        values: [Attribute::ZERO; N],
    };

    /// Sets depth, and what else `values` says of a plane and the place from its first vertex to the
    /// pixel; `false` if they exceed the formats.
    #[inline(always)]
    pub(super) fn set(
        &mut self,
        triangle: [&ScreenVertex; 3],
        seen: &Seen,
        [column, row]: [i32; 2],
        values: impl FnOnce(&SmallPlane, [i32; 2]) -> Option<[Attribute; N]>,
    ) -> bool {
        let [a, ..] = triangle;
        let plane = SmallPlane::new(triangle, seen.area.unsigned_abs() as u32);
        let centre = |pixel: i32, v: SubPx| (pixel << SUBPX_BITS) + HALF_PX - v.to_bits();
        let place = [centre(column, a.x()), centre(row, a.y())];
        let Some(values) = values(&plane, place) else {
            return false;
        };
        self.values = values;
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

    /// How depth changes.
    pub(super) fn depth_change(&self) -> Gradient {
        self.z.gradient
    }

    /// How the values change.
    pub(super) fn changes(&self) -> [Gradient; N] {
        self.values.each_ref().map(|value| value.gradient)
    }
}

/// What changes along a row: depth and other values at its first pixel, and their changes a
/// pixel.
pub(super) struct Steps<const N: usize> {
    pub z: (u32, i32),
    pub values: [i32; N],
    pub change: [i32; N],
}
