//! Places as parallel rays to a light see them: across the rays and along them, with so
//! many bits as an actor's size leaves.

use super::actor::RayActor;
use super::grid_ray::GridRay;
use crate::math::{Scaled, Unit3, mul_high, mul_q30};

/// Fractional bits of a corner in grid steps, for [`Space::corner`].
pub(super) const CORNER_BITS: i32 = 8;
/// Fractional bits of a thick ray's places, in grid steps.
const FRACTION: i32 = 4;

/// An actor's grid sheared along a light's rays, as [`GridRay`] has it, for places of the
/// world. A unit is `2^(2 - up)` raw world bits.
#[derive(Clone, Copy, Debug)]
pub(super) struct Space {
    /// What a place's components are multiplied by: across the rays twice, and along the
    /// grid's axis that they go along most. Q30.
    rows: [[i32; 3]; 3],
    up: u32,
    /// A grid step with [`CORNER_BITS`] is this high product, times `2^by`.
    step: i32,
    by: i32,
}

/// Where a ray starts.
#[derive(Clone, Copy, Debug)]
pub(super) struct Start {
    pub across: [i32; 2],
    pub ahead: i32,
}

impl Space {
    pub(super) const EMPTY: Self = Self {
        rows: [[0; 3]; 3],
        up: 0,
        step: 0,
        by: 0,
    };

    /// That of an actor for a light that a ray goes to.
    #[inline(never)]
    pub(super) fn new(actor: &RayActor, ray: &GridRay) -> Self {
        // Places up to 8 radii away fit 29 bits.
        let up = actor.radius.leading_zeros().saturating_sub(6);
        let row = |axis: usize| actor.to_grid.get(axis).copied().unwrap_or([0; 3]);
        let [x, y, z] = ray.axes.map(row);
        let sheared = |mut row: Unit3, slope: i32| {
            for (c, z) in row.iter_mut().zip(z) {
                // Slopes are Q31.
                *c -= mul_q30(slope >> 1, z);
            }
            row
        };
        let [sx, sy] = ray.slopes;
        Self {
            rows: [
                sheared(x, sx),
                sheared(y, sy),
                z.map(|c| if ray.up { c } else { -c }),
            ],
            up,
            // Half the mantissa, the high product, half a step with its bits, and a
            // quarter of a raw bit.
            step: (actor.step.mantissa() >> 1) as i32,
            by: actor.step.exponent() + up as i32 + (1 + 32 + 1 - CORNER_BITS - 2),
        }
    }

    /// A place that is so far off the actor's centre, raw world bits; `None` if that is too
    /// far.
    #[inline(always)]
    pub(super) fn start(&self, off: [i32; 3]) -> Option<Start> {
        let [x, y, z] = off;
        let most = (x ^ (x >> 31)) | (y ^ (y >> 31)) | (z ^ (z >> 31));
        if most >> (29 - self.up.min(29)) != 0 {
            return None;
        }
        let [x, y, z] = off.map(|c| c << self.up);
        let [across, down, ahead] = self
            .rows
            .map(|[a, b, c]| mul_high(a, x) + mul_high(b, y) + mul_high(c, z));
        Some(Start {
            across: [across, down],
            ahead,
        })
    }

    /// A corner of a triangle, in grid steps with [`CORNER_BITS`].
    #[inline(always)]
    pub(super) fn corner(&self, ray: &GridRay, corner: [i32; 3]) -> Start {
        let [x, y, z] = ray.sheared(ray.in_order(corner));
        let [x, y, z] = [x, y, z].map(|c| mul_high(c, self.step));
        // Across the rays sheared places are half as large.
        Start {
            across: [shifted(x, self.by), shifted(y, self.by)],
            ahead: ray.ahead(shifted(z, self.by - 1)),
        }
    }

    /// The ray through a window's middle, what rays start beside it, in its places, and before
    /// where along it nothing is met by those that start at `before` or farther on.
    pub(super) fn thick_ray(
        &self,
        actor: &RayActor,
        ray: &GridRay,
        (middle, half, before): ([i32; 2], [i32; 2], i32),
    ) -> (GridRay, [i32; 2], i32) {
        let grid = |c: i32, bits: i32| {
            let units = Scaled::new(c.unsigned_abs(), 2 + bits - self.up as i32);
            let steps = units.times(actor.per_bit).fixed(0).min(1 << 29) as i32;
            if c < 0 { -steps } else { steps }
        };
        let mut through = *ray;
        through.from.fraction = FRACTION;
        through.from.place = [0; 3];
        through.shifts = [FRACTION as u32, 0];
        for (axis, c) in through.axes.into_iter().zip(middle) {
            if let Some(place) = through.from.place.get_mut(axis) {
                *place = grid(c, FRACTION);
            }
        }
        // Sheared places are half as large; and a little more.
        let thick = half.map(|half| grid(half + (half >> 5), FRACTION - 1) + 2);
        (through, thick, grid(before, FRACTION) - 2)
    }
}

/// `value * 2^by`.
#[inline(always)]
fn shifted(value: i32, by: i32) -> i32 {
    if by >= 0 {
        value.wrapping_shl(by as u32)
    } else {
        value >> by.wrapping_neg().min(31)
    }
}
