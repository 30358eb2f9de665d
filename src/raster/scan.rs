//! The rows of a triangle, from its edges to its spans.

use core::ops::Range;

use super::edge::Edge;
use super::triangle::first_centre;
use crate::frame::Target;
use crate::math::{Depth, keep_rolled};
use crate::vertex::ScreenVertex;

/// A triangle to be filled.
pub(super) struct Shape<'a> {
    /// From the highest to the lowest vertex.
    pub sorted: [&'a ScreenVertex; 3],
    /// Twice the area; positive if the middle vertex is right of the long edge.
    pub area: i64,
    /// Screen rows that it may touch, half-open.
    pub rows: (i32, i32),
    /// Whether levels are interpolated in perspective.
    pub perspective: bool,
}

/// What changes over a triangle, held for one row.
pub(super) trait Stepped: Copy {
    /// On to the next row.
    fn advance(&mut self);
}

/// How a triangle's pixels get their attributes.
enum Planes<A> {
    /// Not known yet: no pixel was found.
    Unknown,
    /// Stepped.
    Stepped(A),
    /// Pixel by pixel.
    Sliver,
}

/// Two edges between which rows are filled. Taken by value into a loop: edges behind pointers
/// would be loaded and stored row by row.
#[derive(Clone, Copy)]
struct Between {
    left: Edge,
    right: Edge,
    width: i32,
}

impl Between {
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

/// The pixels of a span.
pub(super) struct Span<'t, C = u8> {
    pub indices: &'t mut [C],
    pub depths: &'t mut [Depth],
    /// Screen column and row of the first one.
    pub place: [i32; 2],
}

/// Walks the rows of a triangle. What changes over it is set up by `setup` when the
/// first pixel is found, on its row; `draw` fills a span, and `sliver` one of a triangle
/// for which `setup` exceeds the formats.
#[inline(always)]
pub(super) fn scan<A: Stepped, C>(
    target: &mut Target<'_, C>,
    shape: &Shape<'_>,
    setup: impl Fn(i32) -> Option<A>,
    draw: impl Fn(Span<'_, C>, &A),
    sliver: impl Fn(Span<'_, C>),
) {
    let [top, middle, bottom] = shape.sorted;
    let (first, end) = shape.rows;
    let (width, stride) = (i32::from(target.width), i32::from(target.stride));
    let bend = first_centre(middle.y().to_bits()).max(first).min(end);
    let band_top = i32::from(target.top);
    let mut planes = Planes::Unknown;
    // The long edge stays for both halves; it is on the left if the middle vertex is to its
    // right.
    let long_is_left = shape.area > 0;
    let long = Edge::new(top, bottom, first);
    let mut sides = Between {
        left: long,
        right: long,
        width,
    };
    for (from, to, upper, lower) in [(first, bend, top, middle), (bend, end, middle, bottom)] {
        // There once, not once for each half: it is long.
        keep_rolled();
        if from >= to {
            continue;
        }
        let short = Edge::new(upper, lower, from);
        if long_is_left {
            sides.right = short;
        } else {
            sides.left = short;
        }
        let mut row = from;
        if let Planes::Unknown = planes {
            // The first rows of a triangle are often empty, all rows of a small one.
            loop {
                let (left, right) = sides.span();
                if left < right {
                    planes = setup(row).map_or(Planes::Sliver, Planes::Stepped);
                    break;
                }
                sides.advance();
                row += 1;
                if row >= to {
                    break;
                }
            }
        }
        let start = (row - band_top) * stride;
        match &mut planes {
            Planes::Unknown => {}
            Planes::Stepped(at) => {
                let rows = Rows {
                    start,
                    stride,
                    row,
                    to,
                };
                (*at, sides) = step(target, rows, sides, *at, &draw);
            }
            Planes::Sliver => {
                sides = sliver_rows(target, row..to, sides, &sliver);
            }
        }
    }
}

/// Rows of a band that follow each other.
#[derive(Clone, Copy)]
struct Rows {
    /// Index of the first one's first pixel.
    start: i32,
    /// From a row's first pixel to the next one's.
    stride: i32,
    /// Screen rows, half-open.
    row: i32,
    to: i32,
}

/// Draws rows with stepped attributes; gives all as it is after the last row.
#[inline(always)]
fn step<A: Stepped, C>(
    target: &mut Target<'_, C>,
    rows: Rows,
    mut sides: Between,
    mut at: A,
    draw: &impl Fn(Span<'_, C>, &A),
) -> (A, Between) {
    let mut start = rows.start;
    for row in rows.row..rows.to {
        let (left, right) = sides.span();
        if left < right {
            let pixels = (start + left) as usize..(start + right) as usize;
            if let (Some(indices), Some(depths)) = (
                target.indices.get_mut(pixels.clone()),
                target.depths.get_mut(pixels),
            ) {
                let place = [left, row];
                let span = Span {
                    indices,
                    depths,
                    place,
                };
                draw(span, &at);
            }
        }
        at.advance();
        start += rows.stride;
        sides.advance();
    }
    (at, sides)
}

/// Draws rows of a triangle whose attributes cannot be stepped.
#[cold]
#[inline(never)]
fn sliver_rows<C>(
    target: &mut Target<'_, C>,
    rows: Range<i32>,
    mut sides: Between,
    sliver: &dyn Fn(Span<'_, C>),
) -> Between {
    for row in rows {
        let (left, right) = sides.span();
        let start = (row - i32::from(target.top)) * i32::from(target.stride);
        let pixels = (start + left) as usize..(start + right.max(left)) as usize;
        if let (Some(indices), Some(depths)) = (
            target.indices.get_mut(pixels.clone()),
            target.depths.get_mut(pixels),
        ) {
            let place = [left, row];
            sliver(Span {
                indices,
                depths,
                place,
            });
        }
        sides.advance();
    }
    sides
}
