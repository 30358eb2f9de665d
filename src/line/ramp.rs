//! A quantity along a line, pixel by pixel.

use crate::math::{Divider, SUBPX_BITS};

/// From one end of a line to the other, held within their values; linear but for
/// rounding (at most 1/8 of a unit of depth along 2048 pixels).
#[derive(Clone, Copy, Debug)]
pub(super) struct Ramp {
    /// At pixel 0.
    start: i32,
    /// Change a pixel.
    step: i32,
    least: i32,
    most: i32,
}

/// Changes a pixel are held below this: more is only reached by lines shorter than
/// a pixel, whose two pixels are at their ends.
const MOST_STEP: i32 = 1 << 29;

impl Ramp {
    /// From `from` to `to`, below 2^30, over `length` sub-pixels; pixel 0 is `first`
    /// sub-pixels from the start, and within a pixel of it.
    pub(super) fn new([from, to]: [i32; 2], length: &Divider, first: i32) -> Self {
        let change = i64::from(to) - i64::from(from);
        let half = i64::from(length.divisor() / 2);
        let (step, _) = length.floor_wide((change << SUBPX_BITS) + half);
        let step = step.clamp(-MOST_STEP, MOST_STEP);
        let own = (i64::from(step) * i64::from(first)) >> SUBPX_BITS;
        Self {
            start: (i64::from(from) + own) as i32,
            step,
            least: from.min(to),
            most: from.max(to),
        }
    }

    /// At pixel `n`, counted from the line's first.
    #[inline(always)]
    pub(super) fn at(&self, n: i32) -> i32 {
        self.start
            .wrapping_add(self.step.wrapping_mul(n))
            // Not `clamp`, which would panic if `least` were above `most`.
            .min(self.most)
            .max(self.least)
    }
}
