//! One window: the triangles that parallel rays may meet which start in a rectangle across
//! them, in 8 by 8 cells.

use super::actor::{GridPlace, RayActor};
use super::coverage::{Bits, FINE, TILE, cover_places};
use super::faces::Faces;
use super::grid_ray::GridRay;
use super::hierarchy::{Hierarchy, Stack};
use super::ray::Ray;
use super::window_space::{CORNER_BITS, Space, Start};
use crate::math::mul_high;
use crate::scene::{Leaf, Scene};

/// Most triangles of a window: a bit each, in two words.
const MOST: usize = 64;
/// The smallest half width and height of a window: what roundings take, some 12 units, is
/// less than the margin of a cell, a 64th of this.
const SMALLEST: i32 = 1 << 11;
/// What roundings take along the rays.
const ROUNDINGS: i32 = 64;
/// A cell's places in a window, from its middle.
const HALF_CELLS: i32 = (TILE as i32) << (FINE - 1);

/// Bits that are left off places along the rays where candidates keep them.
const COARSE: u32 = 16;

/// An actor's and a light's number.
pub(super) type Key = (u16, u8);

/// No actor's.
pub(super) const NONE: Key = (u16::MAX, u8::MAX);

/// See the module.
#[derive(Clone, Copy, Debug)]
pub(super) struct Window {
    pub key: Key,
    /// It has more triangles than there is room for.
    pub full: bool,
    pub space: Space,
    middle: [i32; 2],
    /// Half its sides.
    half: [i32; 2],
    /// From places across to cells, 2^32 is 1 cell's `2^-FINE`.
    scale: [i32; 2],
    /// Rays that start before this may meet others.
    nearest: i32,
    /// Triangles that rays may meet: meshlet, and number in it, 8 bits.
    triangles: [u32; MOST],
    /// Of each: rays that start farther on do not meet it. [`COARSE`].
    farthest: [i16; MOST],
    /// A window's cells, 8 by 8: the triangles that a ray may meet there, first those of the
    /// first half of the list.
    bits: [Bits; 2],
}

/// The same as [`Windows::any`] for a ray by itself.
#[inline(never)]
pub(super) fn any_alone(actor: &RayActor, scene: &Scene<'_>, ray: &Ray, left: &mut Stack) -> bool {
    let mesh = scene.mesh(actor.mesh);
    match (actor.hierarchy(scene, &mesh), actor.place(ray.origin)) {
        (Some(tree), Some(from)) => tree.any(&GridRay::new(actor, ray, &from), (0, i32::MAX), left),
        _ => false,
    }
}

/// What holds several starts.
#[derive(Clone, Copy, Debug)]
pub(super) struct Place {
    /// Across the rays.
    low: [i32; 2],
    high: [i32; 2],
    /// Along them.
    nearest: i32,
}

impl Place {
    pub(super) fn of(start: &Start) -> Self {
        Self {
            low: start.across,
            high: start.across,
            nearest: start.ahead,
        }
    }

    pub(super) fn add(&mut self, start: &Start) {
        let sides = self.low.iter_mut().zip(&mut self.high);
        for ((low, high), c) in sides.zip(start.across) {
            *low = c.min(*low);
            *high = c.max(*high);
        }
        self.nearest = self.nearest.min(start.ahead);
    }
}

impl Window {
    /// All zero.
    pub(super) const EMPTY: Self = Self {
        key: (0, 0),
        full: false,
        space: Space::EMPTY,
        middle: [0; 2],
        half: [0; 2],
        scale: [0; 2],
        nearest: 0,
        triangles: [0; MOST],
        farthest: [0; MOST],
        bits: [[0; TILE * TILE]; 2],
    };

    #[inline(always)]
    pub(super) fn holds(&self, start: &Start) -> bool {
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
    pub(super) fn fill(
        &mut self,
        (actor, tree): (&RayActor, &Hierarchy<'_>),
        place: &Place,
        ray: &GridRay,
        left: &mut Stack,
    ) {
        self.bits.as_flattened_mut().fill(0);
        let Place { low, high, nearest } = *place;
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
        let before = self.nearest - ROUNDINGS;
        let (through, thick, from) =
            self.space
                .thick_ray(actor, ray, (self.middle, self.half, before));
        let size = [TILE as u16; 2];
        let mut count = 0;
        let corner_of = GridPlace {
            place: [0; 3],
            fraction: CORNER_BITS,
        };
        let all = tree.walk_window(&through, thick, (from, i32::MAX), left, |leaf: Leaf| {
            tree.each_triangle(leaf, &corner_of, |triangle, corners| {
                let corners = corners.map(|corner| self.space.corner(ray, corner));
                // What roundings of both may be off.
                let ahead = corners.map(|corner| corner.ahead);
                let farthest = ahead.into_iter().fold(i32::MIN, i32::max) + ROUNDINGS;
                if farthest < before {
                    return true;
                }
                let places = corners.map(|corner| self.in_cells(corner.across));
                let [first, second] = &mut self.bits;
                let bits = if count < 32 { first } else { second };
                let bit = 1u32 << (count % 32);
                // A whole cell, not its middle alone.
                let around = 1 << (FINE - 1);
                if !cover_places(&places, Faces::BOTH, (size, around), bits, bit) {
                    return true;
                }
                let slots = (self.triangles.get_mut(count), self.farthest.get_mut(count));
                let (Some(number), Some(reach)) = slots else {
                    return false;
                };
                *number = leaf.meshlet << 8 | u32::from(triangle);
                *reach = (farthest >> COARSE) as i16;
                count += 1;
                true
            })
        });
        self.full = !all;
    }

    /// Whether a ray that starts in this window meets any triangle.
    #[inline(always)]
    pub(super) fn any(
        &self,
        actor: &RayActor,
        scene: &Scene<'_>,
        ray: &Ray,
        start: &Start,
        left: &mut Stack,
    ) -> bool {
        if self.full {
            return any_alone(actor, scene, ray, left);
        }
        let cell = |c: i32| (c + HALF_CELLS).clamp(0, 2 * HALF_CELLS - 1) as usize >> FINE;
        let [x, y] = self.in_cells(start.across).map(cell);
        let word = |bits: &Bits| bits.get(y * TILE + x).copied().unwrap_or(0);
        let [first, second] = &self.bits;
        let bits = u64::from(word(second)) << 32 | u64::from(word(first));
        bits != 0 && self.any_of(bits, actor, scene, ray, start)
    }

    /// Whether it meets any of some triangles.
    #[inline(never)]
    fn any_of(
        &self,
        mut bits: u64,
        actor: &RayActor,
        scene: &Scene<'_>,
        ray: &Ray,
        start: &Start,
    ) -> bool {
        let mut candidates = core::iter::from_fn(|| {
            while bits != 0 {
                let at = bits.trailing_zeros() as usize;
                let (triangle, farthest) = (self.triangles.get(at)?, self.farthest.get(at)?);
                bits &= bits - 1;
                if i32::from(*farthest) >= start.ahead >> COARSE {
                    return Some((triangle >> 8, *triangle as u8));
                }
            }
            None
        });
        // Most have none that is not behind.
        let Some(first) = candidates.next() else {
            return false;
        };
        let Some(from) = actor.place(ray.origin) else {
            return false;
        };
        let mesh = scene.mesh(actor.mesh);
        let Some(tree) = actor.hierarchy(scene, &mesh) else {
            return false;
        };
        let grid = GridRay::new(actor, ray, &from);
        let candidates = core::iter::once(first).chain(candidates);
        tree.any_of(&grid, (0, i32::MAX), candidates)
    }
}
