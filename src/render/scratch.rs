//! The renderer's working memory: its size is the application's choice.

use super::actors::ActorSlot;
use super::entry::Entry;
use super::meshlet_cache::{EMPTY_KEPT, EMPTY_ROOM, SlotKept, SlotRoom};

/// Working memory of a fixed size; put it into a `static`. None of the sizes
/// changes the picture, only the speed:
///
/// * `MESHLETS` that are listed at once, 12 bytes each. If a frame has more
///   that are visible, the list is made again where it ends, after some bands.
/// * `SLOTS` of transformed meshlets that are kept from band to band, 1.1 KB
///   each, at least 1. A meshlet that reaches into the next band and finds no
///   room is transformed again there. In scenes whose vertices have levels of light
///   and no colours, three slots keep four meshlets.
/// * `ACTORS` whose matrices are kept for the frame, about 0.5 KB each, at
///   least 1. Beyond that they are made again whenever the actor changes.
#[derive(Debug)]
pub struct Scratch<const MESHLETS: usize, const SLOTS: usize, const ACTORS: usize> {
    entries: [Entry; MESHLETS],
    room: [SlotRoom; SLOTS],
    kept: [SlotKept; SLOTS],
    actors: [ActorSlot; ACTORS],
}

impl<const MESHLETS: usize, const SLOTS: usize, const ACTORS: usize>
    Scratch<MESHLETS, SLOTS, ACTORS>
{
    const SOME_OF_EACH: () = assert!(MESHLETS > 0 && SLOTS > 0 && ACTORS > 0);

    /// Empty.
    pub const fn new() -> Self {
        let () = Self::SOME_OF_EACH;
        Self {
            entries: [Entry::EMPTY; MESHLETS],
            room: [EMPTY_ROOM; SLOTS],
            kept: [EMPTY_KEPT; SLOTS],
            actors: [ActorSlot::EMPTY; ACTORS],
        }
    }

    /// The memory without its sizes, for [`render_frame`](super::render_frame).
    pub fn workspace(&mut self) -> Workspace<'_> {
        Workspace {
            entries: &mut self.entries,
            room: &mut self.room,
            kept: &mut self.kept,
            actors: &mut self.actors,
        }
    }
}

impl<const MESHLETS: usize, const SLOTS: usize, const ACTORS: usize> Default
    for Scratch<MESHLETS, SLOTS, ACTORS>
{
    fn default() -> Self {
        Self::new()
    }
}

/// A [`Scratch`] of any size.
#[derive(Debug)]
pub struct Workspace<'a> {
    pub(super) entries: &'a mut [Entry],
    pub(super) room: &'a mut [SlotRoom],
    pub(super) kept: &'a mut [SlotKept],
    pub(super) actors: &'a mut [ActorSlot],
}
