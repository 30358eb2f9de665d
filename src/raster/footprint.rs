//! How texture coordinates change at a pixel: what copies of a texture are chosen by.

use super::run::RUN_FRACTION;
use super::surface_planes::{Here, OVER, Surface, quotient};
use crate::math::{Reciprocal, mul_high, reciprocal};

/// How the first two attributes change at a pixel's centre, or how that changes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Footprint {
    /// From pixel to pixel.
    pub across: [i32; 2],
    /// From row to row.
    pub down: [i32; 2],
}

impl<const A: usize> Surface<A> {
    /// How a footprint changes from pixel to pixel between two that are `pixels` apart.
    #[inline(always)]
    pub(super) fn footprint_step(&self, from: Footprint, to: Footprint, pixels: i32) -> Footprint {
        if !self.kind.footprint {
            return Footprint::default();
        }
        let over = OVER.get(pixels as usize).copied().unwrap_or_else(|| {
            let Reciprocal { mantissa, shift } = reciprocal(pixels as u32);
            mantissa >> (31 - shift)
        });
        let part = |from: i32, to: i32| mul_high(to.wrapping_sub(from), over) << 1;
        let parts = |[a, b]: [i32; 2], [c, d]: [i32; 2]| [part(a, c), part(b, d)];
        Footprint {
            across: parts(from.across, to.across),
            down: parts(from.down, to.down),
        }
    }

    /// The footprint of a pixel, where asked for.
    #[inline(always)]
    pub(super) fn footprint(&self, here: &Here<A>) -> Footprint {
        if self.kind.footprint {
            self.own_footprint(here)
        } else {
            Footprint::default()
        }
    }

    #[inline(never)]
    fn own_footprint(&self, here: &Here<A>) -> Footprint {
        let [across, down] = self.changes;
        Footprint {
            across: self.change(here, across),
            down: self.change(here, down),
        }
    }

    /// Those a pixel, and those a row.
    pub(super) fn changes_of_planes(&self) -> [[i32; 3]; 2] {
        // They have 30 bits, but for what is nowhere inside.
        let whole = |v: i64| (v >> 16).clamp(-(1 << 30), 1 << 30) as i32;
        let mut changes = [[0; 3]; 2];
        let planes = self.attributes.iter().take(2).chain([&self.nearness]);
        let [across, down] = &mut changes;
        for ((plane, across), down) in planes.zip(across).zip(down) {
            (*across, *down) = (whole(plane.x), whole(plane.y));
        }
        changes
    }

    /// The change of the first two attributes along an axis: (P' - a N') / N for the
    /// attribute a = P / N.
    #[inline(always)]
    fn change(&self, here: &Here<A>, [u, v, nearer]: [i32; 3]) -> [i32; 2] {
        if !self.perspective {
            return [u, v];
        }
        let mut changes = [u, v];
        let nearer = i64::from(nearer) << 1;
        let all = changes.iter_mut().zip(self.shifts).zip(here.values);
        for ((change, shift), value) in all {
            // In the units of the product; in 64 bits, as far from the origin of a
            // texture that repeats often P' and a N' are all but the same.
            let down = i32::from(shift) + RUN_FRACTION as i32;
            let lens = (i64::from(value) * nearer) >> (down & 63);
            let own = (i64::from(*change) - lens).clamp(-(1 << 31), (1 << 31) - 1);
            *change = quotient(own as i32, here.recip, shift);
        }
        changes
    }
}
