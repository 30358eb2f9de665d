//! Transformed meshlets, kept from band to band.

use super::triangles::Done;
use crate::scene::Scene;
use crate::scene::layout::MESHLET_VERTICES;
use crate::vertex::{COLOUR_ROOM, Room, ScreenVertex, TransformedMeshlet};

/// Vertices that a slot has room for: those of a meshlet and its colours. In scenes without
/// colours at vertices, which most are, four meshlets are kept where three slots are.
const ROOM: usize = MESHLET_VERTICES + COLOUR_ROOM;
/// Meshlets that are kept in the room of a slot, at most.
const IN_SLOT: usize = if COLOUR_ROOM == 0 { 1 } else { 2 };

/// The memory of a slot for vertices.
pub(super) type SlotRoom = [ScreenVertex; ROOM];
/// What is known of the meshlets in it.
pub(super) type SlotKept = [Kept; IN_SLOT];

/// No meshlet's vertices.
pub(super) const EMPTY_ROOM: SlotRoom = [ScreenVertex::ZERO; ROOM];
/// No meshlet.
pub(super) const EMPTY_KEPT: SlotKept = [Kept::NONE; IN_SLOT];

/// A transformed meshlet that is kept.
#[derive(Clone, Copy, Debug)]
pub(super) struct Kept {
    /// Actor; meshlet and viewport.
    key: Option<(u16, u32)>,
    /// One past the last row that needs it.
    until: u16,
    /// Whether none of its vertices has to be clipped.
    inside: bool,
    /// Its triangles that have no pixels in the next band.
    done: Done,
}

impl Kept {
    const NONE: Self = Self {
        key: None,
        until: 0,
        inside: false,
        done: Done::NONE,
    };
}

/// A meshlet from its place.
pub(super) struct Held<'a> {
    pub vertices: TransformedMeshlet<'a>,
    /// Whether none of its vertices has to be clipped.
    pub inside: bool,
    pub done: &'a mut Done,
}

/// The meshlets of a frame. The first place is for meshlets that the next band does not
/// need, and for those that find no other; the others keep what they hold until
/// its last row is past. So the nearest meshlets, which come first in each
/// band, are never pushed out by those behind them.
#[derive(Debug)]
pub(super) struct MeshletCache<'a> {
    kept: &'a mut [Kept],
    room: &'a mut [ScreenVertex],
    /// Vertices from one place to the next.
    stride: usize,
    /// One past the band's last row.
    band_end: u16,
}

impl<'a> MeshletCache<'a> {
    pub(super) fn new(
        scene: &Scene<'_>,
        room: &'a mut [SlotRoom],
        kept: &'a mut [SlotKept],
    ) -> Self {
        let (room, kept) = (room.as_flattened_mut(), kept.as_flattened_mut());
        let stride = if scene.has_colours_at_vertices() {
            ROOM
        } else {
            MESHLET_VERTICES
        };
        let places = kept.len().min(room.len().checked_div(stride).unwrap_or(0));
        let kept = kept.get_mut(..places).unwrap_or_default();
        for kept in &mut *kept {
            kept.key = None;
        }
        Self {
            kept,
            room,
            stride,
            band_end: 0,
        }
    }

    /// A band begins whose last row is the one before `end`.
    pub(super) fn begin_band(&mut self, end: u16) {
        self.band_end = end;
    }

    /// The meshlet's vertices, from their place or through `transform`, and its triangles. `until`
    /// is one past its last row, at most; `transform` gives what that really is, and whether no
    /// vertex has to be clipped, and may say that triangles have no pixels.
    pub(super) fn get(
        &mut self,
        key: (u16, u32),
        until: u16,
        transform: impl FnOnce(&mut Room<'_>, &mut Done) -> (u16, bool),
    ) -> Option<Held<'_>> {
        let held = self.kept.iter().position(|kept| kept.key == Some(key));
        let which = held.unwrap_or_else(|| self.choose(until));
        let kept = self.kept.get_mut(which)?;
        let (_, from) = self.room.split_at_mut_checked(which * self.stride)?;
        let (vertices, rest) = from.split_first_chunk_mut()?;
        let colours = rest.get_mut(..self.stride - MESHLET_VERTICES)?;
        let mut room = Room { vertices, colours };
        if held.is_none() {
            kept.done = Done::NONE;
            let (end, inside) = transform(&mut room, &mut kept.done);
            (kept.until, kept.inside) = (end.min(until), inside);
            kept.key = Some(key);
        }
        if kept.until <= self.band_end {
            // Not needed again: free for the next one.
            kept.key = None;
        }
        Some(Held {
            vertices: room.held(),
            inside: kept.inside,
            done: &mut kept.done,
        })
    }

    fn choose(&self, until: u16) -> usize {
        if until <= self.band_end {
            return 0;
        }
        let mut others = self.kept.iter().enumerate().skip(1);
        others
            .find(|(_, kept)| kept.key.is_none())
            .map_or(0, |(which, _)| which)
    }
}
