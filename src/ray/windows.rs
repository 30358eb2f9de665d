//! Windows: what parallel rays to a light may meet that start side by side. The first few
//! rays go by themselves and tell how far apart they start; for the rectangle that holds
//! them, in the plane across the light, a mesh's triangles are gathered once. The exact
//! test decides on a window's triangles as it does on those of the hierarchy.

use super::coverage::{Bits, FINE, TILE, cover_places};
use super::grid_ray::{GridRay, component};
use super::hierarchy::Hierarchy;
use super::pause::Pause;
use super::triangle::Faces;
use crate::math::mul_high;
use crate::scene::Leaf;
use crate::scene::layout::RAY_STACK;

/// Windows that are kept.
const WINDOWS: usize = 2;
/// Most triangles of a window: one bit each.
const MOST: usize = 32;
/// Rays that make a window.
const FIRST: u32 = 3;
/// Fractional bits of places along the rays, in grid steps, and across, in twice that.
const FRACTION: i32 = 4;
/// Places across are below this.
const REACH: i32 = 1 << 25;
/// The smallest half width and height of a window: what roundings take, 3 steps, is less
/// than the margin of a cell, a 64th of this.
const SMALLEST: i32 = 1 << 13;
/// A cell's places in a window, from its middle.
const HALF_CELLS: i32 = (TILE as i32) << (FINE - 1);

/// A triangle that rays may meet.
#[derive(Clone, Copy, Debug)]
struct Candidate {
    /// Meshlet and number in it, 8 bits.
    triangle: u32,
    /// Rays that start farther on do not meet it.
    farthest: i32,
}

/// An actor's and a light's number.
type Key = (u16, u8);

/// No actor's.
const NONE: Key = (u16::MAX, u8::MAX);

#[derive(Clone, Copy, Debug)]
struct Window {
    key: Key,
    /// It has more triangles than there is room for.
    full: bool,
    middle: [i32; 2],
    /// Half its sides.
    half: [i32; 2],
    /// From places across to cells, 2^32 is 1 cell's `2^-FINE`.
    scale: [i32; 2],
    /// Rays that start before this may meet others.
    nearest: i32,
    list: [Candidate; MOST],
    /// A window's cells, 8 by 8: the triangles that a ray may meet there.
    bits: Bits,
}

/// The windows of a frame.
#[derive(Debug)]
pub(super) struct Windows {
    all: [Window; WINDOWS],
    /// Boxes that are left for later while one is filled.
    left: [u32; RAY_STACK],
    /// The one that is given up next.
    oldest: usize,
    /// Rays that went by themselves since the last window: whose, how many, and what holds
    /// their starts.
    key: Key,
    count: u32,
    place: Place,
    /// Tiles that do without windows after one that has too many triangles: a mesh may be
    /// finer than pixels.
    pause: Pause,
}

/// What holds several starts.
#[derive(Clone, Copy, Debug)]
struct Place {
    /// Across the rays.
    low: [i32; 2],
    high: [i32; 2],
    /// Along them.
    nearest: i32,
}

/// Where a ray starts: across the light's rays, and along.
struct Start {
    across: [i32; 2],
    ahead: i32,
}

impl Start {
    /// `None` if it is too far off the mesh.
    fn of(ray: &GridRay) -> Option<Self> {
        let down = u32::try_from(ray.from.fraction - FRACTION).ok()?;
        let place = ray.axes.map(|axis| component(&ray.from.place, axis));
        let [x, y, z] = ray.sheared(place.map(|c| c >> down));
        let near = |c: i32| c.abs() < REACH;
        (near(x) && near(y)).then_some(Self {
            across: [x, y],
            ahead: ray.ahead(z),
        })
    }
}

impl Windows {
    /// All zero: [`Windows::clear`] says that nothing is there.
    pub(super) const EMPTY: Self = Self {
        all: [Window {
            key: (0, 0),
            full: false,
            middle: [0; 2],
            half: [0; 2],
            scale: [0; 2],
            nearest: 0,
            list: [Candidate {
                triangle: 0,
                farthest: 0,
            }; MOST],
            bits: [0; TILE * TILE],
        }; WINDOWS],
        left: [0; RAY_STACK],
        oldest: 0,
        key: (0, 0),
        count: 0,
        place: Place {
            low: [0; 2],
            high: [0; 2],
            nearest: 0,
        },
        pause: Pause::NONE,
    };

    /// Forgets all: actors moved.
    pub(super) fn clear(&mut self) {
        for window in &mut self.all {
            window.key = NONE;
        }
        (self.key, self.pause) = (NONE, Pause::NONE);
    }

    /// A tile's rays follow, which start elsewhere.
    pub(super) fn begin(&mut self) {
        self.key = NONE;
        self.pause.pass();
    }

    /// Whether a ray in an actor's grid that goes to a directional light meets any
    /// triangle.
    #[inline(never)]
    pub(super) fn any(&mut self, tree: &Hierarchy<'_>, key: Key, ray: &GridRay) -> bool {
        let range = (0, i32::MAX);
        let Some(start) = Start::of(ray) else {
            return tree.any(ray, range);
        };
        let held = |window: &&Window| window.key == key && window.holds(&start);
        if let Some(window) = self.all.iter().find(held) {
            return window.any(tree, ray, &start);
        }
        if !self.pause.is_over() {
            return tree.any(ray, range);
        }
        self.note(key, &start);
        if self.count < FIRST {
            return tree.any(ray, range);
        }
        self.key = NONE;
        let Some(window) = self.all.get_mut(self.oldest) else {
            return tree.any(ray, range);
        };
        self.oldest = (self.oldest + 1) % WINDOWS;
        window.fill(tree, (key, self.place), ray, &mut self.left);
        self.pause.tried(!window.full);
        window.any(tree, ray, &start)
    }

    /// Counts a start that no window holds.
    fn note(&mut self, key: Key, start: &Start) {
        if self.key != key {
            self.key = key;
            self.count = 0;
            self.place = Place {
                low: start.across,
                high: start.across,
                nearest: start.ahead,
            };
        }
        self.count += 1;
        let place = &mut self.place;
        let sides = place.low.iter_mut().zip(&mut place.high);
        for ((low, high), c) in sides.zip(start.across) {
            *low = c.min(*low);
            *high = c.max(*high);
        }
        place.nearest = place.nearest.min(start.ahead);
    }
}

impl Window {
    #[inline(always)]
    fn holds(&self, start: &Start) -> bool {
        let ([x, y], [mx, my], [hx, hy]) = (start.across, self.middle, self.half);
        let inside = |c: i32, half: i32| (c + half) as u32 <= 2 * half as u32;
        inside(x - mx, hx) && inside(y - my, hy) && start.ahead >= self.nearest
    }

    /// A place across the rays in cells, `FINE` fractional bits, from the middle.
    #[inline(always)]
    fn in_cells(&self, [x, y]: [i32; 2]) -> [i32; 2] {
        let ([mx, my], [sx, sy]) = (self.middle, self.scale);
        [mul_high(x - mx, sx), mul_high(y - my, sy)]
    }

    /// Gathers the triangles in the way of all rays that go where `ray` does and start
    /// where the window is to be.
    #[inline(never)]
    fn fill(
        &mut self,
        tree: &Hierarchy<'_>,
        (key, place): (Key, Place),
        ray: &GridRay,
        left: &mut [u32; RAY_STACK],
    ) {
        self.key = key;
        self.bits.fill(0);
        let Place { low, high, nearest } = place;
        let mut most = 0;
        for axis in [0, 1] {
            let [low, high] = [low, high].map(|side| side.get(axis).copied().unwrap_or(0));
            // A little more than its rays need, for those that follow.
            let half = ((high - low) / 2 + (high - low) / 8).max(SMALLEST);
            most = half.max(most);
            let scale = (u32::MAX / (half as u32 >> 7)) as i32;
            for (all, c) in [
                (&mut self.middle, low + (high - low) / 2),
                (&mut self.half, half),
                (&mut self.scale, scale),
            ] {
                if let Some(slot) = all.get_mut(axis) {
                    *slot = c;
                }
            }
        }
        self.nearest = nearest - most;
        // A ray through its middle.
        let mut through = *ray;
        through.from.fraction = FRACTION;
        through.from.place = [0; 3];
        through.shifts = [FRACTION as u32, 0];
        for (axis, c) in through.axes.into_iter().zip(self.middle) {
            if let Some(place) = through.from.place.get_mut(axis) {
                *place = c << 1;
            }
        }
        let thick = self.half.map(|half| half + (half >> 5));
        let size = [TILE as u16; 2];
        let mut count = 0;
        let before = self.nearest - 4;
        let all = tree.walk_window(&through, thick, before, left, |leaf: Leaf| {
            for (triangle, corners) in tree.corners(leaf, &through.from) {
                let corners = corners.map(|corner| {
                    through.sheared(through.axes.map(|axis| component(&corner, axis)))
                });
                // What roundings of both may be off.
                let ahead = corners.map(|[.., z]| through.ahead(z));
                let farthest = ahead.into_iter().fold(i32::MIN, i32::max) + 4;
                if farthest < before {
                    continue;
                }
                let [mx, my] = self.middle;
                let places = corners.map(|[x, y, _]| self.in_cells([x + mx, y + my]));
                let bit = 1u32.checked_shl(count as u32).unwrap_or(0);
                // A whole cell, not its middle alone.
                let around = 1 << (FINE - 1);
                let cells = (size, around);
                if !cover_places(&places, Faces::BOTH, cells, &mut self.bits, bit) {
                    continue;
                }
                let Some(slot) = self.list.get_mut(count) else {
                    return false;
                };
                *slot = Candidate {
                    triangle: leaf.meshlet << 8 | u32::from(triangle),
                    farthest,
                };
                count += 1;
            }
            true
        });
        self.full = !all;
    }

    /// Whether a ray that starts in this window meets any triangle.
    #[inline(always)]
    fn any(&self, tree: &Hierarchy<'_>, ray: &GridRay, start: &Start) -> bool {
        if self.full {
            return tree.any(ray, (0, i32::MAX));
        }
        let cell = |c: i32| (c + HALF_CELLS).clamp(0, 2 * HALF_CELLS - 1) as usize >> FINE;
        let [x, y] = self.in_cells(start.across).map(cell);
        let mut bits = self.bits.get(y * TILE + x).copied().unwrap_or(0);
        if bits == 0 {
            return false;
        }
        let candidates = core::iter::from_fn(|| {
            while bits != 0 {
                let found = self.list.get(bits.trailing_zeros() as usize)?;
                bits &= bits - 1;
                if found.farthest >= start.ahead {
                    return Some((found.triangle >> 8, found.triangle as u8));
                }
            }
            None
        });
        tree.any_of(ray, (0, i32::MAX), candidates)
    }
}
