//! A triangle becomes spans.

use super::attributes::Attributes;
use super::perspective;
use super::scan::{Shape, Span, scan};
use super::sliver;
use super::small::{fill_small, is_small};
use super::span::{self, Fill};
use super::tiny::{fill_tiny, is_tiny};
use crate::frame::Target;
use crate::math::{HALF_PX, SUBPX_BITS, product};
use crate::vertex::ScreenVertex;

/// Which sides of a triangle are drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Sides {
    /// Seen counter-clockwise on the screen.
    pub front: bool,
    /// Seen clockwise.
    pub back: bool,
}

/// What became of a triangle in the rows of a target.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Drawn {
    /// What it is.
    pub how: How,
    /// Whether rows below may have pixels of it.
    pub more: bool,
}

/// What became of a triangle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum How {
    /// It is not in these rows, or between pixel centres.
    Missed,
    /// It shows a side that is not drawn, or is seen edge-on.
    Away,
    /// Its pixels were filled where nothing nearer stood.
    Filled,
}

impl Drawn {
    /// There was nothing to draw.
    pub const NOTHING: Self = Self::last(How::Missed);

    /// It is done with.
    const fn last(how: How) -> Self {
        Self { how, more: false }
    }
}

/// Twice the signed area in sub-pixels squared; exact.
#[inline(always)]
fn doubled_area([a, b, c]: [&ScreenVertex; 3]) -> i64 {
    let (ax, ay) = (a.x().to_bits(), a.y().to_bits());
    let (bx, by) = (b.x().to_bits() - ax, b.y().to_bits() - ay);
    let (cx, cy) = (c.x().to_bits() - ax, c.y().to_bits() - ay);
    // Whether each is within 15 bits and a sign.
    const HALF: i32 = 1 << 15;
    let shifted = (bx + HALF) | (by + HALF) | (cx + HALF) | (cy + HALF);
    if cfg!(narrow_multiply) && (shifted as u32) < 2 * HALF as u32 {
        return i64::from(bx * cy - cx * by);
    }
    product(bx, cy) - product(cx, by)
}

/// The first pixel whose centre is at or past `v`.
#[inline(always)]
pub(super) fn first_centre(v: i32) -> i32 {
    (v + (HALF_PX - 1)) >> SUBPX_BITS
}

/// The least and the most of three.
#[inline(always)]
fn range([a, b, c]: [i32; 3]) -> (i32, i32) {
    (a.min(b).min(c), a.max(b).max(c))
}

/// A triangle of which something may be seen.
#[derive(Clone, Copy)]
pub(super) struct Seen {
    /// Twice the signed area in sub-pixels squared, not 0; exact.
    pub area: i64,
    /// Rows of the target in which it may have pixels, half-open.
    pub rows: (i32, i32),
    /// Least and most x, y of the vertices, sub-pixels.
    pub bounds: [[i32; 2]; 2],
    /// Whether rows below the target may have pixels of it.
    pub more: bool,
}

impl Seen {
    /// What has become of it when it is drawn.
    #[inline(always)]
    pub fn filled(&self) -> Drawn {
        Drawn {
            how: How::Filled,
            more: self.more,
        }
    }
}

/// Draws a triangle if it shows one of `sides`; `fill` is asked for only then.
/// `perspective` says that depth is proportional to 1 / w.
#[inline(always)]
pub fn draw_triangle<'f>(
    target: &mut Target<'_>,
    triangle: [&ScreenVertex; 3],
    sides: Sides,
    perspective: bool,
    fill: impl FnOnce() -> Fill<'f>,
) -> Drawn {
    let seen = match shown(target, triangle, sides) {
        Ok(seen) => seen,
        Err(drawn) => return drawn,
    };
    fill_triangle(target, triangle, &seen, perspective, fill());
    seen.filled()
}

/// A triangle that shows one of `sides` and may have pixels in the target.
#[inline(always)]
pub(super) fn shown<C>(
    target: &Target<'_, C>,
    triangle: [&ScreenVertex; 3],
    sides: Sides,
) -> Result<Seen, Drawn> {
    // First what most triangles end with, and needs to be known only once.
    let area = doubled_area(triangle);
    // y points down.
    let shown = if area < 0 {
        sides.front
    } else {
        sides.back && area > 0
    };
    if !shown {
        return Err(Drawn::last(How::Away));
    }
    // Many triangles of a fine mesh lie between pixel centres, and in a band
    // most lie in other rows.
    let (clip_top, clip_end) = (i32::from(target.top), i32::from(target.end));
    let (above, below) = range(triangle.map(|v| v.y().to_bits()));
    let (first, end) = (first_centre(above).max(clip_top), first_centre(below));
    let more = end > clip_end;
    let end = end.min(clip_end);
    if first >= end {
        return Err(Drawn {
            how: How::Missed,
            more,
        });
    }
    let (left, right) = range(triangle.map(|v| v.x().to_bits()));
    if first_centre(left).max(0) >= first_centre(right).min(target.width.into()) {
        return Err(Drawn::last(How::Missed));
    }
    Ok(Seen {
        area,
        rows: (first, end),
        bounds: [[left, above], [right, below]],
        more,
    })
}

#[inline(never)]
fn fill_triangle(
    target: &mut Target<'_>,
    triangle: [&ScreenVertex; 3],
    seen: &Seen,
    perspective: bool,
    fill: Fill<'_>,
) {
    let perspective = cfg!(feature = "gouraud")
        && perspective
        && matches!(fill, Fill::Gouraud(_))
        && perspective::shows(triangle, seen);
    if !perspective && is_small(seen, target) {
        let tiny = is_tiny(seen) && fill_tiny(target, triangle, seen, fill);
        if tiny || fill_small(target, triangle, seen, fill) {
            return;
        }
    }
    fill_large(target, triangle, seen, perspective, fill);
}

/// A triangle of any size.
#[inline(always)]
fn fill_large(
    target: &mut Target<'_>,
    triangle: [&ScreenVertex; 3],
    seen: &Seen,
    perspective: bool,
    fill: Fill<'_>,
) {
    let (sorted, flipped) = sort(triangle.map(|v| (v, ())));
    let shape = Shape {
        sorted: sorted.map(|(v, ())| v),
        area: if flipped { -seen.area } else { seen.area },
        rows: seen.rows,
        perspective,
    };
    match fill {
        Fill::Depth => {}
        // Without the feature there is none.
        Fill::Gouraud(_) if !cfg!(feature = "gouraud") => {}
        Fill::Flat(index) => fill_flat(target, &shape, index),
        Fill::Gouraud(shades) if perspective => fill_in_perspective(target, &shape, shades),
        Fill::Gouraud(shades) => fill_gouraud(target, &shape, shades),
    }
}

/// Functions of their own, so that the stack holds what one of them needs.
#[inline(never)]
fn fill_flat(target: &mut Target<'_>, shape: &Shape<'_>, index: u8) {
    let columns = columns(shape);
    scan(
        target,
        shape,
        |row| Attributes::depth(shape, row),
        |span, z| {
            let here = z.at(columns(&span));
            span::long_flat(span.indices, span.depths, here, z.gradient.x, index);
        },
        |span| sliver::span(span, shape, Fill::Flat(index)),
    );
}

#[inline(never)]
fn fill_in_perspective(target: &mut Target<'_>, shape: &Shape<'_>, shades: &[u8; 256]) {
    let columns = columns(shape);
    let range = perspective::range(shape.sorted);
    scan(
        target,
        shape,
        |row| Attributes::for_perspective(shape, row),
        |span, at| {
            let (planes, columns) = ((&at.z, &at.level), columns(&span));
            perspective::gouraud(span.indices, span.depths, planes, range, columns, shades);
        },
        |span| sliver::span(span, shape, Fill::Gouraud(shades)),
    );
}

#[inline(never)]
fn fill_gouraud(target: &mut Target<'_>, shape: &Shape<'_>, shades: &[u8; 256]) {
    let columns = columns(shape);
    scan(
        target,
        shape,
        |row| Attributes::depth_and_level(shape, row),
        |span, at| {
            let columns = columns(&span);
            let z = (at.z.at(columns), at.z.gradient.x);
            let level = (at.level.at(columns), at.level.gradient.x);
            span::long_gouraud(span.indices, span.depths, z, level, shades);
        },
        |span| sliver::span(span, shape, Fill::Gouraud(shades)),
    );
}

/// From the attributes' place, the top vertex's column, to a span's first pixel.
#[inline(always)]
fn columns<C>(shape: &Shape<'_>) -> impl Fn(&Span<'_, C>) -> i32 + Copy + use<C> {
    let [top, ..] = shape.sorted;
    let column = top.x().to_bits() >> SUBPX_BITS;
    move |span| {
        let [left, _] = span.place;
        left - column
    }
}

/// Draws a triangle's depth alone if it shows one of `sides`: no index changes.
#[inline(never)]
pub fn draw_depth<C>(
    target: &mut Target<'_, C>,
    triangle: [&ScreenVertex; 3],
    sides: Sides,
) -> Drawn {
    let seen = match shown(target, triangle, sides) {
        Ok(seen) => seen,
        Err(drawn) => return drawn,
    };
    let (sorted, flipped) = sort(triangle.map(|v| (v, ())));
    let shape = Shape {
        sorted: sorted.map(|(v, ())| v),
        area: if flipped { -seen.area } else { seen.area },
        rows: seen.rows,
        perspective: false,
    };
    let columns = columns(&shape);
    scan(
        target,
        &shape,
        |row| Attributes::depth(&shape, row),
        |span, z| span::depth(span.depths, z.at(columns(&span)), z.gradient.x),
        |span| sliver::depth(span, &shape),
    );
    seen.filled()
}

/// A vertex and what goes with it.
type With<'a, T> = (&'a ScreenVertex, T);

/// From the highest to the lowest, and whether that turns the winding round.
#[inline(always)]
pub(super) fn sort<T>([mut a, mut b, mut c]: [With<'_, T>; 3]) -> ([With<'_, T>; 3], bool) {
    let mut flipped = false;
    if a.0.y() > b.0.y() {
        (a, b) = (b, a);
        flipped = !flipped;
    }
    if b.0.y() > c.0.y() {
        (b, c) = (c, b);
        flipped = !flipped;
    }
    if a.0.y() > b.0.y() {
        (a, b) = (b, a);
        flipped = !flipped;
    }
    ([a, b, c], flipped)
}
