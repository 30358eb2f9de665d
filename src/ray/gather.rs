//! The triangles that a tile's rays may meet, gathered by one beam an actor.

use super::actor::Form;
use super::actors::RayActors;
use super::beam::Beam;
use super::camera::RayCamera;
use super::coverage::{Bits, TILE, cover, cover_bounds, cover_rectangle};
use super::hierarchy::Hierarchy;
use super::pause::Pause;
use crate::math::Rect;
use crate::scene::Scene;
use crate::scene::layout::RAY_STACK;

/// Most triangles of a tile: one bit each.
const MOST: usize = 32;

/// A triangle that a ray may meet.
#[derive(Clone, Copy, Debug)]
struct Candidate {
    meshlet: u32,
    actor: u16,
    triangle: u8,
}

/// What a tile's rays may meet.
#[derive(Debug)]
pub(super) struct Gathered {
    list: [Candidate; MOST],
    bits: Bits,
    /// How many are in the list.
    count: usize,
    /// Of tiles and their quarters: how long they are not gathered where they have too many
    /// triangles.
    pauses: [Pause; 2],
}

/// What one pixel's ray may meet.
#[derive(Clone, Copy, Debug)]
pub(super) struct Candidates<'a> {
    list: &'a [Candidate; MOST],
    bits: u32,
}

impl Gathered {
    pub(super) const EMPTY: Self = Self {
        list: [Candidate {
            meshlet: 0,
            actor: 0,
            triangle: 0,
        }; MOST],
        bits: [0; TILE * TILE],
        count: 0,
        pauses: [Pause::NONE; 2],
    };

    /// The same as [`Gathered::gather`]; not tried where tiles of this `size` (a number in
    /// `pauses`) had too many triangles lately. `left` is for what is left for later.
    pub(super) fn gather_if_it_pays(
        &mut self,
        scene: &Scene<'_>,
        actors: &mut RayActors<'_>,
        view: (u16, &RayCamera),
        listed: &[u16],
        (tile, size): (&Rect, usize),
        left: &mut [u32; RAY_STACK],
    ) -> bool {
        let pause = self.pauses.get_mut(size);
        if let Some(pause) = pause
            && !pause.is_over()
        {
            pause.pass();
            return false;
        }
        let gathered = self.gather(scene, actors, view, listed, (tile, left));
        if let Some(pause) = self.pauses.get_mut(size) {
            // Fewer rays than triangles are better cast by themselves.
            let rays = usize::from(tile.width()) * usize::from(tile.height());
            pause.tried(gathered && self.count <= rays);
        }
        gathered
    }

    /// Gathers what the rays of a perspective's tile may meet of some actors; `false` if
    /// that is more than there is room for, or cannot be told.
    #[inline(never)]
    fn gather(
        &mut self,
        scene: &Scene<'_>,
        actors: &mut RayActors<'_>,
        (viewport, camera): (u16, &RayCamera),
        listed: &[u16],
        (tile, left): (&Rect, &mut [u32; RAY_STACK]),
    ) -> bool {
        let (Some(rays), Some(eye)) = (camera.tile(tile), camera.eye()) else {
            return false;
        };
        self.bits.fill(0);
        let size = [tile.width(), tile.height()];
        let mut count = 0;
        for number in listed {
            let bounds = actors.bounds(*number, viewport, camera);
            let Some((actor, from)) = actors.seen(*number, viewport, camera) else {
                return false;
            };
            let bit = 1u32.checked_shl(count as u32).unwrap_or(0);
            let first_node = match actor.form {
                Form::Triangles { first_node } => first_node,
                form => {
                    let covers = match form {
                        Form::Rectangle { half, .. } => {
                            let sides = actor.rectangle_corners(half);
                            cover_rectangle(&rays, eye, &sides, size, &mut self.bits, bit)
                        }
                        _ => cover_bounds(&bounds, tile, &mut self.bits, bit),
                    };
                    if covers {
                        let Some(slot) = self.list.get_mut(count) else {
                            return false;
                        };
                        *slot = Candidate {
                            meshlet: 0,
                            actor: *number,
                            triangle: 0,
                        };
                        count += 1;
                    }
                    continue;
                }
            };
            // From where it is too small to be seen, no ray meets it.
            let Some(&from) = from else { continue };
            let Some(beam) = Beam::new(actor, from, &rays, size) else {
                return false;
            };
            let mesh = scene.mesh(actor.mesh);
            let tree = Hierarchy::new(scene, &mesh, first_node, None);
            let (list, bits) = (&mut self.list, &mut self.bits);
            let all = beam.walk(&tree, left, |leaf| {
                for (triangle, corners) in tree.corners(leaf, &from) {
                    let bit = 1u32.checked_shl(count as u32).unwrap_or(0);
                    if !cover(&beam, &corners, actor.faces, size, bits, bit) {
                        continue;
                    }
                    let Some(slot) = list.get_mut(count) else {
                        return false;
                    };
                    *slot = Candidate {
                        meshlet: leaf.meshlet,
                        actor: *number,
                        triangle,
                    };
                    count += 1;
                }
                true
            });
            if !all {
                return false;
            }
        }
        self.count = count;
        true
    }

    /// Whether a pixel's ray meets nothing.
    #[inline(always)]
    pub(super) fn nothing_at(&self, pixel: usize) -> bool {
        self.at(pixel).bits == 0
    }

    /// What a pixel's ray may meet.
    pub(super) fn at(&self, pixel: usize) -> Candidates<'_> {
        Candidates {
            list: &self.list,
            bits: self.bits.get(pixel).copied().unwrap_or(0),
        }
    }
}

impl<'a> Candidates<'a> {
    /// Whether there is none.
    #[inline(always)]
    pub(super) fn is_empty(&self) -> bool {
        self.bits == 0
    }

    /// The next actor, which then is not here any more.
    #[inline(always)]
    pub(super) fn next_actor(&mut self) -> Option<u16> {
        let mut first = None;
        while self.bits != 0 {
            let found = self.list.get(self.bits.trailing_zeros() as usize)?;
            if *first.get_or_insert(found.actor) != found.actor {
                break;
            }
            self.bits &= self.bits - 1;
        }
        first
    }

    /// The triangles of an actor: meshlet, and number in it.
    #[inline(always)]
    pub(super) fn of(self, actor: u16) -> impl Iterator<Item = (u32, u8)> + 'a {
        let mut bits = self.bits;
        let list = self.list;
        core::iter::from_fn(move || {
            while bits != 0 {
                let found = list.get(bits.trailing_zeros() as usize)?;
                bits &= bits - 1;
                if found.actor == actor {
                    return Some((found.meshlet, found.triangle));
                }
            }
            None
        })
    }
}
