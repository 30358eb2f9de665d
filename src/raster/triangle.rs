//! A triangle becomes spans.

use super::edge::Edge;
use super::gradient::{Gradient, Plane};
use super::span::{self, Fill};
use crate::frame::Target;
use crate::math::{HALF_PX, SUBPX_BITS};
use crate::vertex::ScreenVertex;

/// Which side of a triangle is seen.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Facing {
    /// Counter-clockwise on the screen.
    Front,
    /// Clockwise.
    Back,
    /// Neither: it has no area on the screen's sub-pixel grid.
    Edge,
}

/// Which side is seen.
#[inline(always)]
pub fn facing(triangle: [&ScreenVertex; 3]) -> Facing {
    match doubled_area(triangle) {
        // y points down.
        ..0 => Facing::Front,
        0 => Facing::Edge,
        1.. => Facing::Back,
    }
}

/// Twice the signed area in sub-pixels squared; exact.
#[inline(always)]
fn doubled_area([a, b, c]: [&ScreenVertex; 3]) -> i64 {
    let (ax, ay) = (a.x.to_bits(), a.y.to_bits());
    let (bx, by) = (b.x.to_bits() - ax, b.y.to_bits() - ay);
    let (cx, cy) = (c.x.to_bits() - ax, c.y.to_bits() - ay);
    i64::from(bx) * i64::from(cy) - i64::from(cx) * i64::from(by)
}

/// The first pixel whose centre is at or past `v`.
#[inline(always)]
fn first_centre(v: i32) -> i32 {
    (v + (HALF_PX - 1)) >> SUBPX_BITS
}

/// Draws a triangle of either winding.
pub fn draw_triangle(target: &mut Target<'_>, triangle: [&ScreenVertex; 3], fill: Fill<'_>) {
    let [mut top, mut middle, mut bottom] = triangle;
    if top.y > middle.y {
        (top, middle) = (middle, top);
    }
    if middle.y > bottom.y {
        (middle, bottom) = (bottom, middle);
    }
    if top.y > middle.y {
        (top, middle) = (middle, top);
    }
    let (clip_top, clip_end) = (i32::from(target.top), i32::from(target.end));
    let first = first_centre(top.y.to_bits()).max(clip_top);
    let end = first_centre(bottom.y.to_bits()).min(clip_end);
    if first >= end {
        return;
    }
    let sorted = [top, middle, bottom];
    let area = doubled_area(sorted);
    if area == 0 {
        return;
    }
    let bend = first_centre(middle.y.to_bits()).clamp(first, end);

    let mut filler = Filler::new(sorted, area, first, fill);
    let mut long = Edge::new(top, bottom, first);
    // The long edge is on the left if the middle vertex is to its right.
    let long_left = area > 0;
    for (from, to, upper, lower) in [(first, bend, top, middle), (bend, end, middle, bottom)] {
        if from >= to {
            continue;
        }
        let mut short = Edge::new(upper, lower, from);
        for row in from..to {
            let (left, right) = if long_left {
                (&long, &short)
            } else {
                (&short, &long)
            };
            filler.row(target, row, left.pixel(), right.pixel());
            long.advance();
            short.advance();
        }
    }
}

/// An attribute over a triangle: its value at the centre of pixel
/// `(column, row)`, and how it changes. 16 fractional bits, and half a unit
/// added so that cutting off the fraction rounds.
#[derive(Clone, Copy, Debug, Default)]
struct Attribute {
    at_row: u32,
    gradient: Gradient,
}

impl Attribute {
    /// `value` with 16 fractional bits at `vertex`.
    #[inline(always)]
    fn new(value: u32, gradient: Gradient, to_centre: [i32; 2]) -> Self {
        let [dx, dy] = to_centre.map(i64::from);
        let change = i64::from(gradient.x) * dx + i64::from(gradient.y) * dy;
        // Modulo 2^32: the value inside the triangle is in range.
        let change = (change >> SUBPX_BITS) as i32;
        Self {
            at_row: value.wrapping_add(1 << 15).wrapping_add_signed(change),
            gradient,
        }
    }

    #[inline(always)]
    fn at(&self, columns: i32) -> u32 {
        self.at_row
            .wrapping_add_signed(self.gradient.x.wrapping_mul(columns))
    }

    #[inline(always)]
    fn advance(&mut self) {
        self.at_row = self.at_row.wrapping_add_signed(self.gradient.y);
    }
}

/// Fills the rows of one triangle.
struct Filler<'a> {
    column: i32,
    depth: Attribute,
    level: Attribute,
    fill: Fill<'a>,
}

impl<'a> Filler<'a> {
    #[inline(always)]
    fn new(sorted: [&ScreenVertex; 3], area: i64, row: i32, fill: Fill<'a>) -> Self {
        let [a, b, c] = sorted;
        let plane = Plane::new(sorted, area);
        let column = a.x.to_bits() >> SUBPX_BITS;
        let to_centre = [
            (column << SUBPX_BITS) + HALF_PX - a.x.to_bits(),
            (row << SUBPX_BITS) + HALF_PX - a.y.to_bits(),
        ];
        let attribute = |values: [i32; 3], fraction: i32| {
            let [va, vb, vc] = values;
            let gradient = plane
                .gradient(vb - va, vc - va, fraction)
                .unwrap_or_else(|| Plane::along(vc - va, (c.y - a.y).to_bits(), fraction));
            Attribute::new((va as u32) << (16 - fraction), gradient, to_centre)
        };
        let depth = attribute([a, b, c].map(|v| v.z.to_bits() as i32), 4);
        let level = match fill {
            Fill::Flat(_) => Attribute::default(),
            Fill::Gouraud(_) => attribute([a, b, c].map(|v| i32::from(v.level.to_bits())), 6),
        };
        Self {
            column,
            depth,
            level,
            fill,
        }
    }

    /// Pixels `left..right` of a row; then on to the next row.
    #[inline(always)]
    fn row(&mut self, target: &mut Target<'_>, row: i32, left: i32, right: i32) {
        let width = i32::from(target.width);
        let (left, right) = (left.max(0), right.min(width));
        if left < right {
            let start = ((row - i32::from(target.top)) * width + left) as usize;
            let pixels = start..start + (right - left) as usize;
            let columns = left - self.column;
            if let (Some(indices), Some(depths)) = (
                target.indices.get_mut(pixels.clone()),
                target.depths.get_mut(pixels),
            ) {
                let depth = (self.depth.at(columns), self.depth.gradient.x);
                match self.fill {
                    Fill::Flat(index) => span::flat(indices, depths, depth.0, depth.1, index),
                    Fill::Gouraud(shades) => {
                        let level = (self.level.at(columns), self.level.gradient.x);
                        span::gouraud(indices, depths, depth, level, shades);
                    }
                }
            }
        }
        self.depth.advance();
        self.level.advance();
    }
}
