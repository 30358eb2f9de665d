//! Windows: what parallel rays to a light may meet that start side by side. The corners of
//! a tile tell how far apart its rays start; for the rectangle that holds them, in the
//! plane across the light, a mesh's triangles are gathered once. The exact test decides on
//! a window's triangles as it does on those of the hierarchy.

use super::actor::RayActor;
use super::grid_ray::GridRay;
use super::hierarchy::{NOTHING_LEFT, Stack};
use super::pause::Pause;
use super::ray::{Ray, between};
use super::window::{Key, NONE, Place, Window, any_alone};
use super::window_space::{Space, Start};
use crate::scene::Scene;

/// Windows that are kept.
const WINDOWS: usize = 2;
/// Rays that make a further window of a tile.
const FIRST: u32 = 3;
/// Places that a window is made of.
const NOTES: usize = 6;
/// A place that rays to lights start at, raw world bits, and the actor that it is on.
type Note = (u16, [i32; 3]);

/// The windows of a frame.
#[derive(Debug)]
pub(super) struct Windows {
    all: [Window; WINDOWS],
    /// Boxes that are left for later while one is filled, or a tile's triangles are gathered.
    pub left: Stack,
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
        all: [Window::EMPTY; WINDOWS],
        left: NOTHING_LEFT,
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

    /// Whether a ray to a directional light meets any triangle of an actor. Its sphere is tried only
    /// where no window holds the ray.
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
                return window.any(actor, scene, ray, &start, &mut self.left);
            }
        }
        if actor.missed(ray, ray.far) {
            return false;
        }
        let made = self.make(actor, scene, ray, (key, parallel.source));
        let window = made.and_then(|(which, start)| Some((self.all.get(which)?, start)));
        match window {
            Some((window, start)) => window.any(actor, scene, ray, &start, &mut self.left),
            None => any_alone(actor, scene, ray, &mut self.left),
        }
    }

    /// A window for a ray that none holds, by its number, if it pays.
    #[inline(never)]
    fn make(
        &mut self,
        actor: &RayActor,
        scene: &Scene<'_>,
        ray: &Ray,
        (key, source): (Key, Option<u16>),
    ) -> Option<(usize, Start)> {
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
        Some((which, start))
    }
}
