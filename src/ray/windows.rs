//! Windows: what parallel rays to a light may meet that start side by side. The corners of
//! a tile tell how far apart its rays start; for the rectangle that holds them, in the
//! plane across the light, a mesh's triangles are gathered once. The exact test decides on
//! a window's triangles as it does on those of the hierarchy.

use super::actor::{GridPlace, RayActor};
use super::coverage::{Bits, FINE, TILE, cover_places};
use super::grid_ray::GridRay;
use super::hierarchy::Hierarchy;
use super::pause::Pause;
use super::ray::{Ray, between};
use super::triangle::Faces;
use super::window_space::{CORNER_BITS, Space, Start};
use crate::math::mul_high;
use crate::scene::layout::RAY_STACK;
use crate::scene::{Leaf, Scene};

/// Windows that are kept.
const WINDOWS: usize = 2;
/// Most triangles of a window: a bit each, in two words.
const MOST: usize = 64;
/// Rays that make a further window of a tile.
const FIRST: u32 = 3;
/// Places that a window is made of.
const NOTES: usize = 6;
/// The smallest half width and height of a window: what roundings take, some 12 units, is
/// less than the margin of a cell, a 64th of this.
const SMALLEST: i32 = 1 << 11;
/// What roundings take along the rays.
const ROUNDINGS: i32 = 64;
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
    space: Space,
    middle: [i32; 2],
    /// Half its sides.
    half: [i32; 2],
    /// From places across to cells, 2^32 is 1 cell's `2^-FINE`.
    scale: [i32; 2],
    /// Rays that start before this may meet others.
    nearest: i32,
    list: [Candidate; MOST],
    /// A window's cells, 8 by 8: the triangles that a ray may meet there, first those of the
    /// first half of the list.
    bits: [Bits; 2],
}

/// A place that rays to lights start at, raw world bits, and the actor that it is on.
type Note = (u16, [i32; 3]);

/// The windows of a frame.
#[derive(Debug)]
pub(super) struct Windows {
    all: [Window; WINDOWS],
    /// Boxes that are left for later while one is filled, or a tile's triangles are gathered.
    pub left: [u32; RAY_STACK],
    /// The one that is given up next.
    oldest: usize,
    /// Of this tile, places on what it shows.
    notes: [Note; NOTES],
    noted: usize,
    /// Of this tile, rays that no window held since one was made, if one was.
    missed: Option<u32>,
    /// Of windows for tiles and for their quarters, how many tiles do without them after one
    /// that has too many triangles: a mesh may be finer than pixels.
    pauses: [Pause; 2],
    /// Whether this is a quarter of a tile.
    quarter: bool,
}

/// A ray to a light at infinity.
#[derive(Clone, Copy)]
pub(super) struct Parallel {
    /// The light's number.
    pub light: u8,
    /// The actor that the ray starts on, if that is where the camera sees it.
    pub source: Option<u16>,
}

impl Windows {
    /// All zero: [`Windows::clear`] says that nothing is there.
    pub(super) const EMPTY: Self = Self {
        all: [Window {
            key: (0, 0),
            full: false,
            space: Space::EMPTY,
            middle: [0; 2],
            half: [0; 2],
            scale: [0; 2],
            nearest: 0,
            list: [Candidate {
                triangle: 0,
                farthest: 0,
            }; MOST],
            bits: [[0; TILE * TILE]; 2],
        }; WINDOWS],
        left: [0; RAY_STACK],
        oldest: 0,
        notes: [(0, [0; 3]); NOTES],
        noted: 0,
        missed: None,
        pauses: [Pause::NONE; 2],
        quarter: false,
    };

    /// Forgets all: actors moved.
    pub(super) fn clear(&mut self) {
        for window in &mut self.all {
            window.key = NONE;
        }
        self.pauses = [Pause::NONE; 2];
    }

    /// Whether a tile's rays are to follow quarter by quarter: whole tiles had too many
    /// triangles.
    pub(super) fn by_quarters(&mut self) -> bool {
        let [whole, quarters] = &mut self.pauses;
        let divided = !whole.is_over() && quarters.is_over();
        whole.pass();
        quarters.pass();
        divided
    }

    /// The rays of a tile follow, or of a quarter of one, which start elsewhere; says whether
    /// it helps to know where.
    pub(super) fn begin(&mut self, quarter: bool) -> bool {
        self.noted = 0;
        self.missed = None;
        self.quarter = quarter;
        self.pause().is_over()
    }

    fn pause(&mut self) -> &mut Pause {
        let [whole, quarters] = &mut self.pauses;
        if self.quarter { quarters } else { whole }
    }

    /// A place on an actor that this tile shows.
    pub(super) fn note(&mut self, note: Note) {
        if let Some(slot) = self.notes.get_mut(self.noted) {
            *slot = note;
            self.noted += 1;
        }
    }

    /// Whether a ray to a directional light meets any triangle of an actor.
    #[inline(never)]
    pub(super) fn any(
        &mut self,
        actor: &RayActor,
        scene: &Scene<'_>,
        ray: &Ray,
        parallel: Parallel,
    ) -> bool {
        let key = (actor.number, parallel.light);
        let off = between(ray.origin, actor.centre);
        for window in &self.all {
            if window.key == key
                && let Some(start) = window.space.start(off)
                && window.holds(&start)
            {
                return window.any(actor, scene, ray, &start);
            }
        }
        match self.make(actor, scene, ray, (key, parallel.source)) {
            Some((window, start)) => window.any(actor, scene, ray, &start),
            None => any_alone(actor, scene, ray),
        }
    }

    /// A window for a ray that none holds, if it pays.
    #[inline(never)]
    fn make(
        &mut self,
        actor: &RayActor,
        scene: &Scene<'_>,
        ray: &Ray,
        (key, source): (Key, Option<u16>),
    ) -> Option<(&Window, Start)> {
        let pays = self.pause().is_over();
        let source = source.filter(|_| pays)?;
        let noted = self.notes.iter().take(self.noted);
        let beside = noted.filter(|(on, _)| *on == source).count();
        self.note((source, ray.origin));
        if let Some(missed) = &mut self.missed {
            *missed += 1;
            if *missed < FIRST {
                return None;
            }
        }
        if beside < 2 {
            return None;
        }
        self.missed = Some(0);
        let mesh = scene.mesh(actor.mesh);
        let tree = actor.hierarchy(scene, &mesh)?;
        let grid = GridRay::new(actor, ray, &actor.place(ray.origin)?);
        let space = Space::new(actor, &grid);
        let start = space.start(between(ray.origin, actor.centre))?;
        let mut place = Place::of(&start);
        for (on, at) in self.notes.iter().take(self.noted) {
            if *on == source
                && let Some(start) = space.start(between(*at, actor.centre))
            {
                place.add(&start);
            }
        }
        let which = self.oldest;
        let window = self.all.get_mut(which)?;
        self.oldest = (which + 1) % WINDOWS;
        window.key = key;
        window.space = space;
        window.fill((actor, &tree), &place, &grid, &mut self.left);
        let full = window.full;
        self.pause().tried(!full);
        self.all.get(which).map(|window| (window, start))
    }
}

/// The same as [`Windows::any`] for a ray by itself.
#[inline(never)]
fn any_alone(actor: &RayActor, scene: &Scene<'_>, ray: &Ray) -> bool {
    let mesh = scene.mesh(actor.mesh);
    match (actor.hierarchy(scene, &mesh), actor.place(ray.origin)) {
        (Some(tree), Some(from)) => tree.any(&GridRay::new(actor, ray, &from), (0, i32::MAX)),
        _ => false,
    }
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

impl Place {
    fn of(start: &Start) -> Self {
        Self {
            low: start.across,
            high: start.across,
            nearest: start.ahead,
        }
    }

    fn add(&mut self, start: &Start) {
        let sides = self.low.iter_mut().zip(&mut self.high);
        for ((low, high), c) in sides.zip(start.across) {
            *low = c.min(*low);
            *high = c.max(*high);
        }
        self.nearest = self.nearest.min(start.ahead);
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
        (actor, tree): (&RayActor, &Hierarchy<'_>),
        place: &Place,
        ray: &GridRay,
        left: &mut [u32; RAY_STACK],
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
            for (triangle, corners) in tree.corners(leaf, &corner_of) {
                let corners = corners.map(|corner| self.space.corner(ray, corner));
                // What roundings of both may be off.
                let ahead = corners.map(|corner| corner.ahead);
                let farthest = ahead.into_iter().fold(i32::MIN, i32::max) + ROUNDINGS;
                if farthest < before {
                    continue;
                }
                let places = corners.map(|corner| self.in_cells(corner.across));
                let [first, second] = &mut self.bits;
                let bits = if count < 32 { first } else { second };
                let bit = 1u32 << (count % 32);
                // A whole cell, not its middle alone.
                let around = 1 << (FINE - 1);
                let cells = (size, around);
                if !cover_places(&places, Faces::BOTH, cells, bits, bit) {
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
    fn any(&self, actor: &RayActor, scene: &Scene<'_>, ray: &Ray, start: &Start) -> bool {
        if self.full {
            return any_alone(actor, scene, ray);
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
                let found = self.list.get(bits.trailing_zeros() as usize)?;
                bits &= bits - 1;
                if found.farthest >= start.ahead {
                    return Some((found.triangle >> 8, found.triangle as u8));
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
