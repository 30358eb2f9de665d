//! A triangle becomes spans.

use core::ops::Range;

use super::attribute::Attribute;
use super::edge::Edge;
use super::gradient::Plane;
use super::perspective;
use super::sliver;
use super::span::{self, Fill};
use crate::frame::Target;
use crate::math::{Depth, HALF_PX, SUBPX_BITS};
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
fn first_centre(v: i32) -> i32 {
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
    let shape = Shape { sorted, area, rows };
    match fill {
        Fill::Flat(index) => scan(
            target,
            &shape,
            fill,
            |plane, row| Attributes::depth(plane, &shape, row),
            |indices, depths, at, columns| {
                span::flat(indices, depths, at.z.at(columns), at.z.gradient.x, index);
            },
        ),
        Fill::Gouraud(shades) if perspective && perspective::shows(sorted) => scan(
            target,
            &shape,
            fill,
            |plane, row| Attributes::for_perspective(plane, &shape, row),
            |indices, depths, at, columns| {
                perspective::gouraud(indices, depths, (&at.z, &at.level), columns, shades);
            },
        ),
        Fill::Gouraud(shades) => scan(
            target,
            &shape,
            fill,
            |plane, row| Attributes::depth_and_level(plane, &shape, row),
            |indices, depths, at, columns| {
                let z = (at.z.at(columns), at.z.gradient.x);
                let level = (at.level.at(columns), at.level.gradient.x);
                span::gouraud(indices, depths, z, level, shades);
            },
        ),
    }
}

/// A triangle to be filled.
struct Shape<'a> {
    /// From the highest to the lowest vertex.
    sorted: [&'a ScreenVertex; 3],
    /// Twice the area; positive if the middle vertex is right of the long edge.
    area: i64,
    /// Screen rows that it may touch, half-open.
    rows: (i32, i32),
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

/// What changes over a triangle, at the centre of one pixel: the top vertex's
/// column in the current row.
#[derive(Clone, Copy)]
struct Attributes {
    z: Attribute,
    level: Attribute,
}

impl Attributes {
    #[inline(always)]
    fn depth(plane: &Plane, shape: &Shape<'_>, row: i32) -> Option<Self> {
        let values = shape.sorted.map(|v| v.z.to_bits() as i32);
        let mut z = attribute(plane, shape, values, 4, row)?;
        if z.gradient.is_steep() {
            z = steep_depth(shape, values, row).unwrap_or(z);
        }
        Some(Self {
            z,
            level: Attribute::default(),
        })
    }

    #[inline(always)]
    fn depth_and_level(plane: &Plane, shape: &Shape<'_>, row: i32) -> Option<Self> {
        let levels = shape.sorted.map(|v| i32::from(v.level.to_bits()));
        let level = attribute(plane, shape, levels, 6, row)?;
        Some(Self {
            level,
            ..Self::depth(plane, shape, row)?
        })
    }

    /// Depth, and level times depth instead of the level.
    fn for_perspective(plane: &Plane, shape: &Shape<'_>, row: i32) -> Option<Self> {
        let products = shape.sorted.map(perspective::level_times_depth);
        // Whole units of 2^-30 are fine enough: no further fraction.
        let level = attribute(plane, shape, products, 16, row)?;
        Some(Self {
            level,
            ..Self::depth(plane, shape, row)?
        })
    }

    #[inline(always)]
    fn advance(&mut self) {
        self.z.advance();
        self.level.advance();
    }
}

/// The depth of a face so steep that the rounding of its vertices would show: its
/// plane goes through the vertices as they were. `None` where that might leave
/// the range of depths.
#[cold]
#[inline(never)]
fn steep_depth(shape: &Shape<'_>, values: [i32; 3], row: i32) -> Option<Attribute> {
    // A gradient of 2^15 units a pixel over half a sub-pixel: 4 units.
    const ROOM: i32 = 8 << 4;
    if values
        .iter()
        .any(|z| !(ROOM..=(65535 << 4) - ROOM).contains(z))
    {
        return None;
    }
    let (plane, place) = Plane::unrounded(shape.sorted, shape.area)?;
    let [a, b, c] = values;
    let gradient = plane.gradient(b - a, c - a, 4)?;
    let [top, ..] = shape.sorted;
    let column = top.x.to_bits() >> SUBPX_BITS;
    Some(Attribute::unrounded(
        (a as u32) << 12,
        gradient,
        place,
        [column, row],
    ))
}

/// An attribute with `fraction` fractional bits at the three vertices, on `row`;
/// `None` if its gradient exceeds the format.
#[inline(always)]
fn attribute(
    plane: &Plane,
    shape: &Shape<'_>,
    [a, b, c]: [i32; 3],
    fraction: i32,
    row: i32,
) -> Option<Attribute> {
    let gradient = plane.gradient(b - a, c - a, fraction)?;
    let value = (a as u32) << (16 - fraction);
    let [top, ..] = shape.sorted;
    Some(Attribute::new(
        value,
        gradient,
        [top.x.to_bits(), top.y.to_bits()],
        row,
    ))
}

/// How a triangle's pixels get their attributes.
enum Planes {
    /// Not known yet: no pixel was found.
    Unknown,
    /// Stepped.
    Stepped(Attributes),
    /// Pixel by pixel.
    Sliver,
}

/// Two edges between which rows are filled.
struct Between<'e> {
    left: &'e mut Edge,
    right: &'e mut Edge,
    width: i32,
}

impl Between<'_> {
    /// The row's pixels, half-open; empty if the first is not below the second.
    #[inline(always)]
    fn span(&self) -> (i32, i32) {
        (self.left.pixel().max(0), self.right.pixel().min(self.width))
    }

    #[inline(always)]
    fn advance(&mut self) {
        self.left.advance();
        self.right.advance();
    }
}

/// Walks the rows of a triangle. Attributes are set up by `setup` when the first
/// pixel is found, and `draw` gets the pixels of each span and the columns from
/// the attributes' place to the span's first pixel.
#[inline(always)]
fn scan(
    target: &mut Target<'_>,
    shape: &Shape<'_>,
    fill: Fill<'_>,
    setup: impl Fn(&Plane, i32) -> Option<Attributes>,
    draw: impl Fn(&mut [u8], &mut [Depth], &Attributes, i32),
) {
    let [top, middle, bottom] = shape.sorted;
    let (first, end) = shape.rows;
    let width = i32::from(target.width);
    let column = top.x.to_bits() >> SUBPX_BITS;
    let bend = first_centre(middle.y.to_bits()).max(first).min(end);
    let band_top = i32::from(target.top);
    let mut planes = Planes::Unknown;
    let mut long = Edge::new(top, bottom, first);
    for (from, to, upper, lower) in [(first, bend, top, middle), (bend, end, middle, bottom)] {
        if from >= to {
            continue;
        }
        let mut short = Edge::new(upper, lower, from);
        // The long edge is on the left if the middle vertex is to its right.
        let (left, right) = if shape.area > 0 {
            (&mut long, &mut short)
        } else {
            (&mut short, &mut long)
        };
        let mut sides = Between { left, right, width };
        let mut row = from;
        if let Planes::Unknown = planes {
            // The first rows of a triangle are often empty, all rows of a small one.
            loop {
                let (left, right) = sides.span();
                if left < right {
                    let plane = Plane::new(shape.sorted, shape.area);
                    planes = setup(&plane, row).map_or(Planes::Sliver, Planes::Stepped);
                    break;
                }
                sides.advance();
                row += 1;
                if row >= to {
                    break;
                }
            }
        }
        let start = (row - band_top) * width;
        match &mut planes {
            Planes::Unknown => {}
            Planes::Stepped(at) => {
                let rows = Rows {
                    start,
                    count: to - row,
                };
                *at = step(target, rows, &mut sides, *at, column, &draw);
            }
            Planes::Sliver => sliver_rows(target, shape, fill, row..to, &mut sides),
        }
    }
}

/// Rows of a band that follow each other.
#[derive(Clone, Copy)]
struct Rows {
    /// Index of the first one's first pixel.
    start: i32,
    count: i32,
}

/// Draws rows with stepped attributes; gives them as they are after the last row.
#[inline(always)]
fn step(
    target: &mut Target<'_>,
    rows: Rows,
    sides: &mut Between<'_>,
    mut at: Attributes,
    column: i32,
    draw: &impl Fn(&mut [u8], &mut [Depth], &Attributes, i32),
) -> Attributes {
    let mut start = rows.start;
    for _ in 0..rows.count {
        let (left, right) = sides.span();
        if left < right {
            let pixels = (start + left) as usize..(start + right) as usize;
            if let (Some(indices), Some(depths)) = (
                target.indices.get_mut(pixels.clone()),
                target.depths.get_mut(pixels),
            ) {
                draw(indices, depths, &at, left - column);
            }
        }
        at.advance();
        start += sides.width;
        sides.advance();
    }
    at
}

/// Draws rows of a triangle whose attributes cannot be stepped.
#[cold]
#[inline(never)]
fn sliver_rows(
    target: &mut Target<'_>,
    shape: &Shape<'_>,
    fill: Fill<'_>,
    rows: Range<i32>,
    sides: &mut Between<'_>,
) {
    for row in rows {
        let (left, right) = sides.span();
        let start = (row - i32::from(target.top)) * sides.width;
        let pixels = (start + left) as usize..(start + right.max(left)) as usize;
        if let (Some(indices), Some(depths)) = (
            target.indices.get_mut(pixels.clone()),
            target.depths.get_mut(pixels),
        ) {
            sliver::span(indices, depths, shape.sorted, shape.area, [left, row], fill);
        }
        sides.advance();
    }
}
