//! Rays that wait for their turn, an explicit stack.

use crate::math::Unit3;

/// Rays that wait: every one of a chain of 8 leaves one behind, and the last two.
const WAITING: usize = 10;

/// A ray that waits for its turn.
#[derive(Clone, Copy, Debug)]
pub(super) struct Waiting {
    pub origin: [i32; 3],
    pub direction: Unit3,
    pub weight: u32,
    /// See [`Ray::on`](super::ray::Ray::on).
    pub on: u16,
    /// Rays that may still follow one after the other, itself counted.
    pub left: u8,
}

/// Rays that wait for their turn.
#[derive(Debug)]
pub(super) struct WaitingRays {
    all: [Waiting; WAITING],
    count: usize,
}

impl WaitingRays {
    pub(super) const NONE: Self = Self {
        all: [Waiting {
            origin: [0; 3],
            direction: [0; 3],
            weight: 0,
            on: 0,
            left: 0,
        }; WAITING],
        count: 0,
    };

    /// None any more.
    pub(super) fn clear(&mut self) {
        self.count = 0;
    }

    pub(super) fn push(&mut self, ray: Waiting) {
        if let Some(slot) = self.all.get_mut(self.count) {
            *slot = ray;
            self.count += 1;
        }
    }

    pub(super) fn pop(&mut self) -> Option<Waiting> {
        self.count = self.count.checked_sub(1)?;
        self.all.get(self.count).copied()
    }
}
