//! What may be between a place and a light, kept for the cell of space that the place is
//! in: rays to a lamp that start side by side pass the same actors by. Cells are as large
//! as a part of the distance that a place is seen from.

use super::actors::RayActors;
use super::coarse::Candidates;
use super::ray::{FAR, Ray, between};
use crate::math::{leading_zeros, unit_vector};
use crate::scene::layout::LIGHTS;

/// Cells that are kept.
const CELLS: usize = 16;

/// Where a lamp is.
#[derive(Clone, Copy, Debug)]
pub(super) enum Towards {
    /// Infinitely far away in a direction.
    Direction([i32; 3]),
    /// All of it is within some distance of a place, raw world bits.
    Place([i32; 3], u32),
}

/// A cell of space and a lamp: 16 bits each of the cell's place, and 8 times its level with
/// the light.
type Key = (u32, u32);

/// No cell's: levels begin at 1.
const NOTHING: Key = (0, 0);

/// What may be between them.
#[derive(Clone, Copy, Debug)]
struct Shade {
    key: Key,
    candidates: Candidates,
}

/// What is kept of a frame.
#[derive(Debug)]
pub(super) struct Shades([Shade; CELLS]);

impl Shades {
    pub(super) const NONE: Self = Self(
        [Shade {
            key: NOTHING,
            candidates: Candidates::NONE,
        }; CELLS],
    );

    /// Forgets all: actors moved.
    pub(super) fn clear(&mut self) {
        *self = Self::NONE;
    }

    /// The actors that may be between a place, or what is up to `lift` from it, and a light.
    /// What is found is kept for a cell that is no smaller than `size`.
    #[inline(always)]
    pub(super) fn find(
        &mut self,
        actors: &mut RayActors<'_>,
        place: [i32; 3],
        (light, towards): (usize, &Towards),
        (size, lift): (u32, u32),
    ) -> Candidates {
        // A cell is less than twice as large.
        let size = size.max(lift.min(1 << 24) * 8) | 1;
        let least = actors.unit().shift();
        let shift = (32 - leading_zeros(size)).max(least + 1).min(31);
        let [x, y, z] = place.map(|c| c >> shift);
        let far = |c: i32| i32::from(c as i16) != c;
        if far(x) || far(y) || far(z) {
            // Farther away than all that has a sphere.
            return actors.all();
        }
        let [cx, cy, cz] = [x, y, z].map(|c| u32::from(c as u16));
        let of = (shift - least) << 3 | light as u32;
        let key = (cx << 16 | cy, cz << 16 | of);
        let slot = (x + 6 * y + 4 * z + 5 * light as i32) as usize % CELLS;
        let Some(shade) = self.0.get_mut(slot) else {
            return Candidates::NONE;
        };
        if shade.key != key {
            shade.set(actors, key, (place, shift), towards);
        }
        shade.candidates
    }
}

// A light's number has 3 bits.
const _: () = assert!(LIGHTS <= 8);

impl Shade {
    #[inline(never)]
    fn set(
        &mut self,
        actors: &mut RayActors<'_>,
        key: Key,
        (place, shift): ([i32; 3], u32),
        towards: &Towards,
    ) {
        self.key = key;
        let middle = place.map(|c| (c >> shift << shift) + (1 << (shift - 1)));
        // Half a cube's diagonal, and what rays are lifted by, an eighth.
        let around = 1 << shift;
        let (ray, around) = match *towards {
            Towards::Direction(direction) => (Ray::from_to(middle, direction, FAR), around),
            Towards::Place(lamp, size) => {
                let way = between(lamp, middle);
                let direction = unit_vector(way).unwrap_or([0, 0, 1 << 30]);
                let far = way
                    .iter()
                    .fold(0u32, |all, c| all.saturating_add(c.unsigned_abs()));
                let around = size.max(around);
                (Ray::from_to(middle, direction, far.min(FAR)), around)
            }
        };
        self.candidates = actors.candidates(&ray, around);
        let mut left = self.candidates;
        while let Some(number) = left.next_sphere() {
            let beside = actors
                .get(number)
                .is_some_and(|actor| actor.is_beside(middle, towards, around));
            if beside {
                self.candidates = self.candidates.without(number);
            }
        }
    }
}
