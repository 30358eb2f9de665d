//! The rows of a triangle, from its edges to its spans.

use core::ops::Range;

use super::edge::Edge;
use super::gradient::Plane;
use super::triangle::first_centre;
use crate::frame::Target;
use crate::math::Depth;
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

/// The pixels of a span.
pub(super) struct Span<'t> {
    pub indices: &'t mut [u8],
    pub depths: &'t mut [Depth],
    /// Screen column and row of the first one.
    pub place: [i32; 2],
}

/// How a triangle is filled.
pub(super) trait Kernel {
    /// What it needs to know on a row.
    type Planes: Stepped;
    /// On the row of the first pixel; `None` if it exceeds the formats.
    fn setup(&self, plane: &Plane, row: i32) -> Option<Self::Planes>;
    /// Fills a span.
    fn draw(&mut self, span: Span<'_>, planes: &Self::Planes);
    /// Fills a span of a triangle that `setup` gave up on.
    fn sliver(&mut self, span: Span<'_>);
}

/// Walks the rows of a triangle.
#[inline(always)]
pub(super) fn scan<K: Kernel>(target: &mut Target<'_>, shape: &Shape<'_>, kernel: &mut K) {
    let [top, middle, bottom] = shape.sorted;
    let (first, end) = shape.rows;
    let (width, stride) = (i32::from(target.width), i32::from(target.stride));
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
                    planes = kernel
                        .setup(&plane, row)
                        .map_or(Planes::Sliver, Planes::Stepped);
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
                *at = step(target, rows, &mut sides, *at, kernel);
            }
            Planes::Sliver => {
                sliver_rows(target, row..to, &mut sides, &mut |span| kernel.sliver(span));
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

/// Draws rows with stepped attributes; gives them as they are after the last row.
#[inline(always)]
fn step<K: Kernel>(
    target: &mut Target<'_>,
    rows: Rows,
    sides: &mut Between<'_>,
    mut at: K::Planes,
    kernel: &mut K,
) -> K::Planes {
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
                kernel.draw(span, &at);
            }
        }
        at.advance();
        start += rows.stride;
        sides.advance();
    }
    at
}

/// Draws rows of a triangle whose attributes cannot be stepped.
#[cold]
#[inline(never)]
fn sliver_rows(
    target: &mut Target<'_>,
    rows: Range<i32>,
    sides: &mut Between<'_>,
    sliver: &mut dyn FnMut(Span<'_>),
) {
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
}
