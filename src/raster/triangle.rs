//! A triangle becomes spans.

use super::attributes::Attributes;
use super::perspective;
use super::scan::{Shape, Span, scan};
use super::sliver;
use super::span::{self, Fill};
use crate::frame::Target;
use crate::math::{HALF_PX, SUBPX_BITS};
use crate::vertex::ScreenVertex;

/// Which sides of a triangle are drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Sides {
    /// Seen counter-clockwise on the screen.
    pub front: bool,
    /// Seen clockwise.
    pub back: bool,
}

/// What became of a triangle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Drawn {
    /// It is not in these rows, or between pixel centres.
    Missed,
    /// It shows a side that is not drawn, or is seen edge-on.
    Away,
    /// Its pixels were filled where nothing nearer stood.
    Filled,
}

/// Twice the signed area in sub-pixels squared; exact.
#[inline(always)]
fn doubled_area([a, b, c]: [&ScreenVertex; 3]) -> i64 {
    let (ax, ay) = (a.x.to_bits(), a.y.to_bits());
    let (bx, by) = (b.x.to_bits() - ax, b.y.to_bits() - ay);
    let (cx, cy) = (c.x.to_bits() - ax, c.y.to_bits() - ay);
    let size = bx.abs() | by.abs() | cx.abs() | cy.abs();
    if cfg!(narrow_multiply) && size < 1 << 15 {
        return i64::from(bx * cy - cx * by);
    }
    i64::from(bx) * i64::from(cy) - i64::from(cx) * i64::from(by)
}

/// The first pixel whose centre is at or past `v`.
#[inline(always)]
pub(super) fn first_centre(v: i32) -> i32 {
    (v + (HALF_PX - 1)) >> SUBPX_BITS
}

/// Pixel rows or columns whose centres lie between the ends, held to `least..most`.
#[inline(always)]
fn centres([a, b, c]: [i32; 3], least: i32, most: i32) -> (i32, i32) {
    let (low, high) = (a.min(b).min(c), a.max(b).max(c));
    (first_centre(low).max(least), first_centre(high).min(most))
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
    // Many triangles of a fine mesh lie between pixel centres, and in a band
    // most lie in other rows.
    let (clip_top, clip_end) = (i32::from(target.top), i32::from(target.end));
    let (first, end) = centres(triangle.map(|v| v.y.to_bits()), clip_top, clip_end);
    if first >= end {
        return Drawn::Missed;
    }
    let area = doubled_area(triangle);
    // y points down.
    let shown = if area < 0 {
        sides.front
    } else {
        sides.back && area > 0
    };
    if !shown {
        return Drawn::Away;
    }
    let columns = centres(triangle.map(|v| v.x.to_bits()), 0, target.width.into());
    if columns.0 >= columns.1 {
        return Drawn::Missed;
    }
    fill_triangle(target, triangle, area, (first, end), perspective, fill());
    Drawn::Filled
}

#[inline(never)]
fn fill_triangle(
    target: &mut Target<'_>,
    triangle: [&ScreenVertex; 3],
    area: i64,
    rows: (i32, i32),
    perspective: bool,
    fill: Fill<'_>,
) {
    let (sorted, area) = sort(triangle, area);
    let shape = Shape {
        sorted,
        area,
        rows,
        perspective: perspective && matches!(fill, Fill::Gouraud(_)) && perspective::shows(sorted),
    };
    let [top, ..] = sorted;
    let column = top.x.to_bits() >> SUBPX_BITS;
    let sliver = |span: Span<'_>| sliver::span(span, &shape, fill);
    match fill {
        Fill::Flat(index) => scan(
            target,
            &shape,
            |plane, row| Attributes::depth(plane, &shape, row),
            |Span {
                 indices,
                 depths,
                 place: [left, _],
             },
             at| {
                let z = at.z.at(left - column);
                span::flat(indices, depths, z, at.z.gradient.x, index);
            },
            sliver,
        ),
        Fill::Gouraud(shades) if shape.perspective => scan(
            target,
            &shape,
            |plane, row| Attributes::for_perspective(plane, &shape, row),
            |Span {
                 indices,
                 depths,
                 place: [left, _],
             },
             at| {
                let columns = left - column;
                perspective::gouraud(indices, depths, (&at.z, &at.level), columns, shades);
            },
            sliver,
        ),
        Fill::Gouraud(shades) => scan(
            target,
            &shape,
            |plane, row| Attributes::depth_and_level(plane, &shape, row),
            |Span {
                 indices,
                 depths,
                 place: [left, _],
             },
             at| {
                let z = (at.z.at(left - column), at.z.gradient.x);
                let level = (at.level.at(left - column), at.level.gradient.x);
                span::gouraud(indices, depths, z, level, shades);
            },
            sliver,
        ),
    }
}

/// From the highest to the lowest. The area's sign follows the winding.
#[inline(always)]
fn sort([mut a, mut b, mut c]: [&ScreenVertex; 3], mut area: i64) -> ([&ScreenVertex; 3], i64) {
    if a.y > b.y {
        (a, b, area) = (b, a, -area);
    }
    if b.y > c.y {
        (b, c, area) = (c, b, -area);
    }
    if a.y > b.y {
        (a, b, area) = (b, a, -area);
    }
    ([a, b, c], area)
}
