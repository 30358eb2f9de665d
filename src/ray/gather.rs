//! What a tile's rays may meet, gathered by one beam an actor: triangles, or where there are too
//! many, parts of the mesh.

use super::actor::{Form, GridPlace, RayActor};
use super::actors::RayActors;
use super::beam::Beam;
use super::camera::RayCamera;
use super::candidates::{Candidate, Candidates, MOST};
use super::coverage::{Bits, TILE, cover, cover_bounds};
use super::hierarchy::{Hierarchy, Stack};
use super::outline::cover_rectangle;
use super::pause::Pause;
use super::screen::TileRays;
use crate::math::Rect;
use crate::scene::{Child, Leaf, Scene};

/// How a tile's rays find what they meet.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Way {
    /// Among what was gathered.
    Gathered,
    /// By quarters of the tile.
    Divided,
    /// One by one.
    Alone,
}

/// What a tile's rays may meet.
#[derive(Debug)]
pub(super) struct Gathered {
    list: [Candidate; MOST],
    bits: Bits,
    /// How many are in the list.
    count: usize,
    /// Of meshes, there are single triangles in it, not parts.
    single: bool,
    /// Of tiles and their quarters: how long they are not gathered where they have too many
    /// triangles.
    pauses: [Pause; 2],
}

impl Gathered {
    /// All zero.
    pub(super) const EMPTY: Self = Self {
        list: [Candidate::all_of(0); MOST],
        bits: [0; TILE * TILE],
        count: 0,
        single: false,
        pauses: [Pause::NONE; 2],
    };

    /// Gathers what the rays of a tile may meet of some actors, or says how to do without: whole
    /// tiles (`divided` 0) or quarters (1) are not gathered by triangles where those had too
    /// many lately. `left` is for what is left for later.
    pub(super) fn find(
        &mut self,
        scene: &Scene<'_>,
        actors: &mut RayActors<'_>,
        view: (u16, &RayCamera),
        listed: &[u16],
        (tile, divided): (&Rect, usize),
        left: &mut Stack,
    ) -> Way {
        let may_divide = divided == 0;
        let [whole, quarters] = &mut self.pauses;
        let quarters_pause = !quarters.is_over();
        let pause = if may_divide { whole } else { &mut *quarters };
        if pause.is_over() {
            let gathered = self.gather(scene, actors, view, listed, (tile, left));
            // Fewer rays than triangles are better cast by themselves.
            let rays = usize::from(tile.width()) * usize::from(tile.height());
            // Of a tile that shows nothing nothing is learnt.
            if let Some(pause) = self.pauses.get_mut(divided)
                && !(gathered && self.count == 0)
            {
                pause.tried(gathered && self.count <= rays);
            }
            if gathered {
                return Way::Gathered;
            }
        } else {
            pause.pass();
        }
        if may_divide && !quarters_pause {
            return Way::Divided;
        }
        if may_divide && let [_, quarters] = &mut self.pauses {
            quarters.pass();
        }
        if self.gather_parts(scene, actors, view, listed, tile) {
            Way::Gathered
        } else {
            Way::Alone
        }
    }

    /// Begins with an actor: what is no mesh is gathered as a whole; gives a mesh, with the
    /// eye in its grid and the first node of its hierarchy. `None` if there is no room, or it cannot be told.
    #[inline(always)]
    fn begin<'a>(
        &mut self,
        actors: &'a mut RayActors<'_>,
        number: u16,
        (viewport, camera): (u16, &RayCamera),
        place: (&Rect, &TileRays, [i32; 3]),
        count: &mut usize,
    ) -> Option<Option<(&'a RayActor, GridPlace, u32)>> {
        let bounds = actors.bounds(number, viewport, camera);
        let (actor, from) = actors.seen(number, viewport, camera)?;
        let Form::Triangles { first_node } = actor.form else {
            let bit = 1u32.checked_shl(*count as u32).unwrap_or(0);
            if cover_exact(actor, &bounds, place, &mut self.bits, bit) {
                *self.list.get_mut(*count)? = Candidate::all_of(number);
                *count += 1;
            }
            return Some(None);
        };
        // From where it is too small to be seen, no ray meets it.
        let Some(&from) = from else {
            return Some(None);
        };
        Some(Some((actor, from, first_node)))
    }

    /// Gathers what the rays of a perspective's tile may meet of some actors; `false` if
    /// that is more than there is room for, or cannot be told.
    #[inline(never)]
    fn gather(
        &mut self,
        scene: &Scene<'_>,
        actors: &mut RayActors<'_>,
        view: (u16, &RayCamera),
        listed: &[u16],
        (tile, left): (&Rect, &mut Stack),
    ) -> bool {
        let (_, camera) = view;
        let (Some(rays), Some(eye)) = (camera.tile(tile), camera.eye()) else {
            return false;
        };
        self.bits.fill(0);
        let size = [tile.width(), tile.height()];
        let place = (tile, &rays, eye);
        let mut count = 0;
        for number in listed {
            let Some(found) = self.begin(actors, *number, view, place, &mut count) else {
                return false;
            };
            let Some((actor, from, first_node)) = found else {
                continue;
            };
            let Some(beam) = Beam::new(actor, from, &rays, size) else {
                return false;
            };
            let mesh = scene.mesh(actor.mesh);
            let tree = Hierarchy::new(scene, &mesh, first_node, None);
            let (list, bits) = (&mut self.list, &mut self.bits);
            let all = beam.walk(&tree, left, |leaf| {
                tree.each_triangle(leaf, &from, |triangle, corners| {
                    let bit = 1u32.checked_shl(count as u32).unwrap_or(0);
                    if !cover(&beam.screen, corners, actor.faces, size, bits, bit) {
                        return true;
                    }
                    let Some(slot) = list.get_mut(count) else {
                        return false;
                    };
                    let only = Leaf {
                        first: triangle,
                        count: 1,
                        ..leaf
                    };
                    *slot = Candidate {
                        word: u32::from_le(Child::Leaf(only).to_word()),
                        ..Candidate::all_of(*number)
                    };
                    count += 1;
                    true
                })
            });
            if !all {
                return false;
            }
        }
        (self.count, self.single) = (count, true);
        true
    }

    /// The same by parts of meshes, of which there are never too many.
    #[inline(never)]
    fn gather_parts(
        &mut self,
        scene: &Scene<'_>,
        actors: &mut RayActors<'_>,
        view: (u16, &RayCamera),
        listed: &[u16],
        tile: &Rect,
    ) -> bool {
        let (_, camera) = view;
        let (Some(rays), Some(eye)) = (camera.tile(tile), camera.eye()) else {
            return false;
        };
        self.bits.fill(0);
        let size = [tile.width(), tile.height()];
        let place = (tile, &rays, eye);
        let mut count = 0;
        // Each that follows has room for one.
        let Some(mut room) = MOST.checked_sub(listed.len()) else {
            return false;
        };
        for number in listed {
            let Some(found) = self.begin(actors, *number, view, place, &mut count) else {
                return false;
            };
            let Some((actor, from, first_node)) = found else {
                continue;
            };
            let Some(beam) = Beam::new(actor, from, &rays, size) else {
                return false;
            };
            let mesh = scene.mesh(actor.mesh);
            let tree = Hierarchy::new(scene, &mesh, first_node, None);
            let list = self.list.get_mut(count..).unwrap_or_default();
            let list = list.get_mut(..=room).unwrap_or_default();
            let found = beam.parts(&tree, *number, size, list);
            for part in list.iter().take(found) {
                let bit = 1u32.checked_shl(count as u32).unwrap_or(0);
                part.seen.cover(&mut self.bits, bit);
                count += 1;
            }
            room = room.saturating_sub(found.saturating_sub(1));
        }
        (self.count, self.single) = (count, false);
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
            of: Some(&self.list),
            bits: self.bits.get(pixel).copied().unwrap_or(0),
            single: self.single,
        }
    }
}

/// Sets a bit in the pixels of a tile whose rays may meet a ball or a rectangle.
fn cover_exact(
    actor: &RayActor,
    bounds: &Rect,
    (tile, rays, eye): (&Rect, &TileRays, [i32; 3]),
    bits: &mut Bits,
    bit: u32,
) -> bool {
    match actor.form {
        Form::Rectangle { half, .. } => {
            // Two and two of them opposite.
            let [a, b, d, c, ..] = actor.rectangle_corners(half);
            let size = [tile.width(), tile.height()];
            cover_rectangle(rays, eye, [a, b, c, d], size, bits, bit)
        }
        _ => cover_bounds(bounds, tile, bits, bit),
    }
}
