//! An attribute over a triangle.

use super::gradient::{Gradient, UNROUNDED_BITS};
use crate::math::{HALF_PX, SUBPX_BITS};

/// An attribute at the centre of one pixel, and how it changes. 16 fractional
/// bits, and half a unit added so that cutting off the fraction rounds. Sums are
/// modulo 2^32: what lies inside the triangle is in range.
#[derive(Clone, Copy, Debug)]
pub(super) struct Attribute {
    at_row: u32,
    pub gradient: Gradient,
}

impl Attribute {
    /// 0 everywhere.
    pub(super) const ZERO: Self = Self {
        at_row: 0,
        gradient: Gradient { x: 0, y: 0 },
    };

    /// From its `value` at a vertex to the centre of the pixel in the vertex's
    /// column and in `row`.
    #[inline(always)]
    pub(super) fn new(value: u32, gradient: Gradient, [x, y]: [i32; 2], row: i32) -> Self {
        const FRACTION: i32 = (1 << SUBPX_BITS) - 1;
        let own = part(gradient.x, HALF_PX - (x & FRACTION))
            .wrapping_add(part(gradient.y, HALF_PX - (y & FRACTION)));
        let rows = row - (y >> SUBPX_BITS);
        let at_row = value
            .wrapping_add(1 << 15)
            .wrapping_add_signed(own)
            .wrapping_add_signed(gradient.y.wrapping_mul(rows));
        Self { at_row, gradient }
    }

    /// From its `value` at a vertex to a place `x, y` sub-pixels from there, at most 16
    /// pixels.
    #[inline(always)]
    pub(super) fn beside(value: u32, gradient: Gradient, [x, y]: [i32; 2]) -> Self {
        let change = part(gradient.x, x).wrapping_add(part(gradient.y, y));
        Self {
            at_row: value.wrapping_add(1 << 15).wrapping_add_signed(change),
            gradient,
        }
    }

    /// The same from a vertex as it was before rounding.
    pub(super) fn unrounded(
        value: u32,
        gradient: Gradient,
        [x, y]: [i32; 2],
        [column, row]: [i32; 2],
    ) -> Self {
        let to_centre = |pixel: i32, v: i32| {
            (i64::from(pixel) << UNROUNDED_BITS) + (1 << (UNROUNDED_BITS - 1)) - i64::from(v)
        };
        let change = i64::from(gradient.x) * to_centre(column, x)
            + i64::from(gradient.y) * to_centre(row, y);
        let change = (change >> UNROUNDED_BITS) as i32;
        Self {
            at_row: value.wrapping_add(1 << 15).wrapping_add_signed(change),
            gradient,
        }
    }

    /// The same without the half that makes cutting off the fraction round.
    #[inline(always)]
    pub(super) fn unrounded_value(self) -> Self {
        Self {
            at_row: self.at_row.wrapping_sub(1 << 15),
            ..self
        }
    }

    /// The value `columns` to the right.
    #[inline(always)]
    pub(super) fn at(&self, columns: i32) -> u32 {
        self.at_row
            .wrapping_add_signed(self.gradient.x.wrapping_mul(columns))
    }

    /// The value `rows` below and `columns` to the right.
    #[inline(always)]
    pub(super) fn below(&self, rows: i32, columns: i32) -> u32 {
        self.at(columns)
            .wrapping_add_signed(self.gradient.y.wrapping_mul(rows))
    }

    /// The same, held for the pixel `columns` to the right.
    pub(super) fn aside(self, columns: i32) -> Self {
        Self {
            at_row: self.at(columns),
            ..self
        }
    }

    /// The same, held for `rows` below.
    pub(super) fn lower(self, rows: i32) -> Self {
        Self {
            at_row: self.below(rows, 0),
            ..self
        }
    }

    /// On to the next row.
    #[inline(always)]
    pub(super) fn advance(&mut self) {
        self.at_row = self.at_row.wrapping_add_signed(self.gradient.y);
    }
}

/// The change over `distance` sub-pixels, at most 64 pixels: the product rounded down,
/// in two 32-bit halves.
#[inline(always)]
fn part(gradient: i32, distance: i32) -> i32 {
    const LOW: i32 = (1 << SUBPX_BITS) - 1;
    let (high, low) = (gradient >> SUBPX_BITS, gradient & LOW);
    high.wrapping_mul(distance)
        .wrapping_add((low * distance) >> SUBPX_BITS)
}
