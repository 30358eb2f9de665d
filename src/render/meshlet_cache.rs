//! Transformed meshlets, kept from band to band.

use super::triangles::Done;
use crate::vertex::TransformedMeshlet;

/// Room for one transformed meshlet.
#[derive(Clone, Copy, Debug)]
pub struct Slot {
    /// Actor; meshlet and viewport.
    key: Option<(u16, u32)>,
    /// One past the last row that needs it.
    until: u16,
    /// Whether none of its vertices has to be clipped.
    inside: bool,
    vertices: TransformedMeshlet,
    /// Its triangles that have no pixels in the next band.
    done: Done,
}

impl Slot {
    pub(super) const EMPTY: Self = Self {
        key: None,
        until: 0,
        inside: false,
        vertices: TransformedMeshlet::EMPTY,
        done: Done::NONE,
    };
}

/// What a slot holds.
pub(super) struct Held<'a> {
    pub vertices: &'a TransformedMeshlet,
    /// Whether none of its vertices has to be clipped.
    pub inside: bool,
    pub done: &'a mut Done,
}

/// The slots of a frame. The first is for meshlets that the next band does not
/// need, and for those that find no other; the others keep what they hold until
/// its last row is past. So the nearest meshlets, which come first in each
/// band, are never pushed out by those behind them.
#[derive(Debug)]
pub(super) struct MeshletCache<'a> {
    slots: &'a mut [Slot],
    /// One past the band's last row.
    band_end: u16,
}

impl<'a> MeshletCache<'a> {
    pub(super) fn new(slots: &'a mut [Slot]) -> Self {
        for slot in &mut *slots {
            slot.key = None;
        }
        Self { slots, band_end: 0 }
    }

    /// A band begins whose last row is the one before `end`.
    pub(super) fn begin_band(&mut self, end: u16) {
        self.band_end = end;
    }

    /// The meshlet's vertices, from a slot or through `transform`, and its triangles. `until` is
    /// one past its last row, at most; `transform` gives what that really is, and whether no
    /// vertex has to be clipped, and may say that triangles have no pixels.
    pub(super) fn get(
        &mut self,
        key: (u16, u32),
        until: u16,
        transform: impl FnOnce(&mut TransformedMeshlet, &mut Done) -> (u16, bool),
    ) -> Option<Held<'_>> {
        let held = self.slots.iter().position(|slot| slot.key == Some(key));
        let which = held.unwrap_or_else(|| self.choose(until));
        let slot = self.slots.get_mut(which)?;
        if held.is_none() {
            slot.done = Done::NONE;
            let (end, inside) = transform(&mut slot.vertices, &mut slot.done);
            (slot.until, slot.inside) = (end.min(until), inside);
            slot.key = Some(key);
        }
        if slot.until <= self.band_end {
            // Not needed again: free for the next one.
            slot.key = None;
        }
        Some(Held {
            vertices: &slot.vertices,
            inside: slot.inside,
            done: &mut slot.done,
        })
    }

    fn choose(&self, until: u16) -> usize {
        if until <= self.band_end {
            return 0;
        }
        let mut others = self.slots.iter().enumerate().skip(1);
        others
            .find(|(_, slot)| slot.key.is_none())
            .map_or(0, |(which, _)| which)
    }
}
