//! An edge, row by row.

use crate::math::{Divider, HALF_PX, SUBPX_BITS};
use crate::vertex::ScreenVertex;

/// Where an edge crosses the centre lines of rows.
#[derive(Clone, Copy, Debug)]
pub(super) struct Edge {
    /// The crossing rounded up to a sub-pixel, plus what makes its whole part
    /// the first pixel whose centre is not left of the crossing.
    at: i32,
    /// What `at` is too large by, in `1 / height` sub-pixels: 0..height.
    excess: i32,
    /// Change a row, rounded down.
    step: i32,
    /// What `step` is too small by, in `1 / height` sub-pixels: 0..height.
    rest: i32,
    /// Sub-pixels from the upper to the lower end.
    height: i32,
}

impl Edge {
    /// The edge from `upper` to `lower`, at the centre of screen row `row`. Long where there
    /// is no divide.
    #[cfg_attr(narrow_multiply, inline(never))]
    #[cfg_attr(not(narrow_multiply), inline(always))]
    pub(super) fn new(upper: &ScreenVertex, lower: &ScreenVertex, row: i32) -> Self {
        let (x, y) = (upper.x().to_bits(), upper.y().to_bits());
        let (dx, height) = (lower.x().to_bits() - x, lower.y().to_bits() - y);
        let down = (row << SUBPX_BITS) + HALF_PX - y;
        let height = height.max(1);
        let divider = Divider::new(height);
        let (along, excess, step, rest);
        if dx.unsigned_abs() < 1 << 18 && down < 1 << 12 {
            // Less than 64 pixels across, and from its first row on.
            (along, excess) = divider.ceil(dx * down);
            (step, rest) = divider.floor(dx << SUBPX_BITS);
        } else {
            (along, excess) = divider.ceil_wide(i64::from(dx) * i64::from(down));
            (step, rest) = divider.floor_wide(i64::from(dx) << SUBPX_BITS);
        }
        Self {
            at: x + along + (HALF_PX - 1),
            excess,
            step,
            rest,
            height,
        }
    }

    /// The first pixel whose centre is on the crossing or right of it.
    #[inline(always)]
    pub(super) fn pixel(&self) -> i32 {
        self.at >> SUBPX_BITS
    }

    /// On to the next row.
    #[inline(always)]
    pub(super) fn advance(&mut self) {
        self.at = self.at.wrapping_add(self.step);
        self.excess -= self.rest;
        if self.excess < 0 {
            self.excess += self.height;
            self.at = self.at.wrapping_add(1);
        }
    }
}
