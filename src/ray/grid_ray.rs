//! A ray in a mesh's grid, sheared: the grid's axis that the ray goes along most is
//! the third, and places are seen along the ray, so that the ray is the origin of the
//! other two (Woop, Benthin and Wald, "Watertight ray/triangle intersection", 2013).
//! A vertex is brought there with one rounding, whatever triangle it belongs to: no ray
//! slips through between two of them.

use super::actor::{GridPlace, RayActor};
use super::ray::Ray;
use crate::math::{mul_high, reciprocal};
use crate::scene::layout::GRID_HALF;

/// See the module. Lengths along the third axis are in `2^-fraction` grid steps, across
/// it in twice that, and are below 2^30.
#[derive(Clone, Copy, Debug)]
pub(super) struct GridRay {
    /// The grid's axes in the order of the sheared space's.
    pub axes: [usize; 3],
    /// Where the ray starts.
    pub from: GridPlace,
    /// From grid steps to its units: a shift to the left, and one to the right.
    pub shifts: [u32; 2],
    /// How much the ray goes along the first and the second axis for one of the third,
    /// Q31.
    pub slopes: [i32; 2],
    /// Whether the ray goes up the third axis.
    pub up: bool,
    /// The direction's component along the third axis, Q28.
    pub along: i32,
}

impl GridRay {
    /// A ray that starts at `from` in the actor's grid.
    pub(super) fn new(actor: &RayActor, ray: &Ray, from: &GridPlace) -> Self {
        let direction = actor.direction(ray.direction);
        let [x, y, z] = direction.map(i32::unsigned_abs);
        let [dx, dy, dz] = direction;
        let (axes, [sx, sy, along]) = if x > y && x > z {
            (AXES[0], [dy, dz, dx])
        } else if y > z {
            (AXES[1], [dz, dx, dy])
        } else {
            (AXES[2], direction)
        };
        // 29 bits at most.
        let recip = reciprocal(along.unsigned_abs() | 1);
        let lead = recip.shift - 1;
        let slope = |c: i32| {
            // Q29, at most 1 but for roundings.
            const MOST: i32 = (1 << 29) - 1;
            let slope = mul_high(c << lead, recip.mantissa).clamp(-MOST, MOST);
            if along < 0 { -slope << 2 } else { slope << 2 }
        };
        Self {
            axes,
            from: *from,
            shifts: [from.fraction, -from.fraction].map(|by| by.max(0) as u32),
            slopes: [slope(sx), slope(sy)],
            up: along >= 0,
            along,
        }
    }

    /// How far a grid point is off the ray's start.
    #[inline(always)]
    pub(super) fn off(&self, [x, y, z]: [i32; 3]) -> [i32; 3] {
        let [left, right] = self.shifts;
        let right = right.min(31);
        let [fx, fy, fz] = self.from.place;
        let off = |steps: i32, from: i32| (steps.wrapping_shl(left) >> right).wrapping_sub(from);
        [off(x, fx), off(y, fy), off(z, fz)]
    }

    /// What the grid's axes have, in the order of the sheared space's.
    #[inline(always)]
    pub(super) fn in_order<T>(&self, [x, y, z]: [T; 3]) -> [T; 3] {
        match self.axes {
            [.., 0] => [y, z, x],
            [.., 1] => [z, x, y],
            _ => [x, y, z],
        }
    }

    /// A place, given as it is off the ray's start, in the sheared space.
    #[inline(always)]
    pub(super) fn sheared(&self, [x, y, z]: [i32; 3]) -> [i32; 3] {
        let [sx, sy] = self.slopes;
        [
            (x >> 1).wrapping_sub(mul_high(sx, z)),
            (y >> 1).wrapping_sub(mul_high(sy, z)),
            z,
        ]
    }

    /// A place of the third axis by how far along the ray it is.
    #[inline(always)]
    pub(super) fn ahead(&self, z: i32) -> i32 {
        if self.up { z } else { z.wrapping_neg() }
    }

    /// A distance along the ray in units of the third axis, rounded down; saturates.
    pub(super) fn units(&self, actor: &RayActor, distance: u32) -> i32 {
        if distance >= super::ray::FAR {
            return i32::MAX;
        }
        if distance == 0 {
            return 0;
        }
        let along = crate::math::Scaled::new(self.along.unsigned_abs(), -28);
        let units = crate::math::Scaled::new(distance, self.from.fraction);
        let units = units.times(along).times(actor.per_bit);
        units.fixed(0).min(i32::MAX as u32) as i32
    }
}

/// The orders of axes, by the third one.
pub(super) const AXES: [[usize; 3]; 3] = [[1, 2, 0], [2, 0, 1], [0, 1, 2]];

const _: () = assert!(GRID_HALF == 1 << 21);
