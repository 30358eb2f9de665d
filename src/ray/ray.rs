//! A ray in the world.

use crate::math::{Unit3, mul_q30};

/// A ray; distances along it are in raw world bits.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Ray {
    /// Where it starts, raw world bits.
    pub origin: [i32; 3],
    /// Where it goes.
    pub direction: Unit3,
    /// What is nearer is not met.
    pub near: u32,
    /// What is farther is not met.
    pub far: u32,
    /// The ball or rectangle that it starts on, if it does: 1 more than the actor's
    /// number.
    pub on: u16,
}

/// As far as rays go.
pub(super) const FAR: u32 = i32::MAX as u32;

impl Ray {
    /// From a place in a direction, up to `far`.
    pub(super) fn from_to(origin: [i32; 3], direction: Unit3, far: u32) -> Self {
        Self {
            origin,
            direction,
            near: 0,
            far,
            on: 0,
        }
    }

    /// The place at a distance.
    pub(super) fn at(&self, distance: u32) -> [i32; 3] {
        let mut place = self.origin;
        for (c, d) in place.iter_mut().zip(self.direction) {
            *c = c.saturating_add(mul_q30(d, distance as i32));
        }
        place
    }
}

/// A place moved along a direction of length 1 (Q30), saturating.
pub(super) fn moved(place: [i32; 3], direction: Unit3, by: i32) -> [i32; 3] {
    let mut place = place;
    for (c, d) in place.iter_mut().zip(direction) {
        *c = c.saturating_add(mul_q30(d, by));
    }
    place
}

/// The difference of two places, saturating.
pub(super) fn between(to: [i32; 3], from: [i32; 3]) -> [i32; 3] {
    let ([tx, ty, tz], [fx, fy, fz]) = (to, from);
    [
        tx.saturating_sub(fx),
        ty.saturating_sub(fy),
        tz.saturating_sub(fz),
    ]
}
