//! Where actors are, roughly, for a frame: most rays and tiles pass most actors by.

use super::coarse::{Sphere, Unit};
use crate::math::Rect;

/// How many actors are known for each that a scratch has a slot for.
pub(super) const KNOWN_A_SLOT: usize = 6;

/// Pixels of a side of the cells in which actors are seen.
const CELL: u16 = 8;

// The widest and highest frame: a cell's number is a byte.
const _: () = assert!(CELL << 8 == 2048);

/// Where an actor is.
#[derive(Clone, Copy, Debug)]
pub struct Known {
    sphere: Sphere,
    /// The first and the last column and row of cells that a viewport's camera may see it in.
    columns: [u8; 2],
    rows: [u8; 2],
}

impl Known {
    /// All zero, so that working memory starts as zeros: a frame begins by filling it.
    pub(super) const EMPTY: Self = Self {
        sphere: Sphere::NONE,
        columns: [0; 2],
        rows: [0; 2],
    };

    /// Notes a sphere that holds it, raw world bits; see [`Unit::sphere`].
    pub(super) fn place(&mut self, unit: Unit, centre: [i32; 3], radius: i32) {
        self.sphere = unit.sphere(centre, radius);
    }

    /// Notes where it is seen.
    pub(super) fn see(&mut self, bounds: &Rect) {
        let cells = |first: u16, end: u16| match first < end {
            true => [first, end - 1].map(|at| (at / CELL).min(u8::MAX.into()) as u8),
            // Ends before it begins.
            false => [u8::MAX, 0],
        };
        self.columns = cells(bounds.left, bounds.right);
        self.rows = cells(bounds.top, bounds.bottom);
    }

    /// Whether none of it is seen in a tile.
    #[inline(always)]
    pub(super) fn is_off(&self, tile: &Rect) -> bool {
        let off = |[first, last]: [u8; 2], start: u16, end: u16| {
            u16::from(first) * CELL >= end || u16::from(last) * CELL + (CELL - 1) < start
        };
        off(self.columns, tile.left, tile.right) || off(self.rows, tile.top, tile.bottom)
    }
}

impl AsRef<Sphere> for Known {
    #[inline(always)]
    fn as_ref(&self) -> &Sphere {
        &self.sphere
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn known(left: u16, right: u16) -> Known {
        let mut known = Known::EMPTY;
        known.see(&Rect {
            left,
            right,
            top: 3,
            bottom: 20,
        });
        known
    }

    fn tile(left: u16, top: u16) -> Rect {
        Rect {
            left,
            top,
            right: left + 8,
            bottom: top + 8,
        }
    }

    /// A tile that has a pixel of it is never off; one that is whole cells aside is.
    #[test]
    fn tiles_beside_are_off() {
        for left in (0..2040).step_by(13) {
            for wide in [1, 7, 8, 9, 40] {
                let right = (left + wide).min(2048);
                let known = known(left, right);
                for from in (0..2041).step_by(3) {
                    let touches = from < right && from + 8 > left;
                    let far = from >= right + 8 || from + 16 <= left;
                    let off = known.is_off(&tile(from, 8));
                    assert!(!(touches && off), "{left}..{right}, tile at {from}");
                    assert!(!far || off, "{left}..{right}, tile at {from}");
                }
            }
        }
        assert!(known(0, 8).is_off(&tile(0, 24)));
    }

    #[test]
    fn what_is_seen_nowhere_is_off_everywhere() {
        let nowhere = known(9, 9);
        assert!((0..2041).all(|left| nowhere.is_off(&tile(left, 8))));
    }
}
