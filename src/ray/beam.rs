//! A beam: the rays of a camera's tile, which all start at the eye, on their way through
//! a mesh's hierarchy at once. A box is left out if its middle is outside of one of the tile's
//! four sides by more than it reaches (Assarsson and Möller, "Optimized view frustum culling
//! algorithms for bounding boxes", 2000), so it is never left out if a ray of the tile meets it.

use super::actor::{GridPlace, RayActor};
use super::hierarchy::{Hierarchy, Later, Stack, depth_first};
use super::screen::{Projection, TileRays, bits};
use crate::math::mul_high;
use crate::scene::Leaf;

/// See the module.
#[derive(Clone, Copy, Debug)]
pub(super) struct Beam {
    /// The eye.
    pub from: GridPlace,
    pub screen: Projection,
    /// What is across the tile, along it and ahead: a place is inside of all four sides if
    /// neither of the first two is farther off 0 than the third. 30 bits.
    axes: [[i32; 3]; 3],
    /// The upper halves of that, and of the first and the second with the third without signs,
    /// rounded up.
    short: [[i32; 3]; 3],
    reach: [[i32; 3]; 2],
}

impl Beam {
    /// The rays of a tile of so many pixels; `None` if they are too narrow or too wide
    /// for its numbers.
    #[inline(never)]
    pub(super) fn new(
        actor: &RayActor,
        from: GridPlace,
        rays: &TileRays,
        [width, height]: [u16; 2],
    ) -> Option<Self> {
        let ways = [rays.middle, rays.across, rays.down].map(|v| actor.direction(v));
        let screen = Projection::new(ways, rays.up)?;
        let Projection { x, y, z, up } = screen;
        // In 2^-12 pixels, so that there are no fractions; half the longer of the tile's sides.
        let across = |v: [i32; 3]| v.map(|c| i64::from(c) << (up + 12));
        let half = i64::from(width.max(height)) << 11;
        let wide = [across(x), across(y), z.map(|c| i64::from(c) * half)];
        let down = wide.iter().fold(0, |most, v| bits(v).max(most)) as i32 - 29;
        let narrow = |c: i64| if down >= 0 { c >> down } else { c << -down } as i32;
        let axes = wide.map(|v| v.map(narrow));
        let short = axes.map(|v| v.map(|c| (c >> 16) + ((c >> 15) & 1)));
        let [x, y, z] = short;
        let with = |v: [i32; 3]| {
            let mut reach = z.map(i32::abs);
            for (c, v) in reach.iter_mut().zip(v) {
                *c += v.abs() + 1;
            }
            reach
        };
        Some(Self {
            from,
            screen,
            axes,
            short,
            reach: [with(x), with(y)],
        })
    }

    /// Goes through a hierarchy; `false` if `leaf` said so, and then ended there.
    #[inline(always)]
    pub(super) fn walk(
        &self,
        tree: &Hierarchy<'_>,
        left: &mut Stack,
        leaf: impl FnMut(Leaf) -> bool,
    ) -> bool {
        let node = |word, later: &mut Later<'_>| {
            let Some((met, children)) = self.boxes(tree, word) else {
                return;
            };
            for (child, word) in children.iter().enumerate() {
                if met >> child & 1 != 0 {
                    later.leave(u32::from_le(*word));
                }
            }
        };
        depth_first(left, node, leaf)
    }

    /// Which boxes of a node are not outside, a bit each, and what they are around.
    #[inline(always)]
    pub(super) fn boxes<'a>(
        &self,
        tree: &Hierarchy<'a>,
        number: u32,
    ) -> Option<(u32, &'a [u32; 4])> {
        let [o0, o1, o2, rest @ ..] = tree.node_words(number)?;
        let origin = [*o0, *o1, *o2].map(|word| u32::from_le(word) as i32);
        let (sides, _) = rest.split_first_chunk::<6>()?;
        let [s0, s1, s2, s3, s4, s5] = sides.map(u32::from_le);
        let sides = [[s0, s1], [s2, s3], [s4, s5]];
        let children = rest.last_chunk::<4>()?;
        let [_, c1, c2, c3] = *children;
        let mut met = 1 | u32::from(c1 != 0) << 1 | u32::from(c2 != 0) << 2;
        met |= u32::from(c3 != 0) << 3;
        // A unit of the boxes in units of a place.
        let exponent = (origin[0] & 31) + self.from.fraction;
        let [x, y, z] = self.from.off(origin.map(|c| c >> 5));
        if exponent < 0 {
            // Too small to tell.
            return Some((met, children));
        }
        let exponent = exponent.min(22);
        // All boxes together reach this, 2^24 of the units below.
        let limit = 1 << (exponent + 8);
        let [across, along, ahead] = self
            .axes
            .map(|[a, b, c]| mul_high(a, x) + mul_high(b, y) + mul_high(c, z));
        let inside = [ahead + across, ahead - across, ahead + along, ahead - along];
        if inside.iter().any(|c| *c < -limit - 8) {
            return None;
        }
        let [left, right, above, below] = inside.map(|c| c.min(limit));
        let units = |c: i32| {
            if exponent <= 16 {
                c.wrapping_shl((16 - exponent) as u32)
            } else {
                c >> (exponent - 16)
            }
        };
        // Middles count twice below. What shortened numbers' lost bits are on 510 units, twice, and
        // the products' roundings.
        let margin = 1600 + (12 << 16 >> exponent);
        let off = [units(left - right), units(above - below)];
        let reach = [units(left + right), units(above + below)].map(|c| c + margin);
        let ([off_x, off_y], [reach_x, reach_y]) = (off, reach);
        let [short_x, short_y, short_z] = self.short;
        let [wide_x, wide_y] = self.reach;
        for child in 0..4 {
            let byte = |all: u32| (all >> (8 * child) & 255) as i32;
            let (mut middle, mut size) = ([0; 3], [0; 3]);
            let all = middle.iter_mut().zip(&mut size).zip(sides);
            for ((middle, size), [low, high]) in all {
                let (low, high) = (byte(low), byte(high));
                (*middle, *size) = (low + high, high - low);
            }
            let sum = |[a, b, c]: [i32; 3], [x, y, z]: [i32; 3]| a * x + b * y + c * z;
            let ahead = sum(short_z, middle);
            let missed = |off: i32, reach: i32, short: [i32; 3], wide: [i32; 3]| {
                (off + sum(short, middle)).abs() > reach + ahead + sum(wide, size)
            };
            if missed(off_x, reach_x, short_x, wide_x) || missed(off_y, reach_y, short_y, wide_y) {
                met &= !(1 << child);
            }
        }
        Some((met, children))
    }
}
