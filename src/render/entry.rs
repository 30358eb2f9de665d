//! An entry of the list of meshlets to draw, and its place in the order of drawing.

use core::ops::Range;

use super::lines::Pass;
use crate::math::Rect;
use crate::scene::layout::MESHLETS;

/// A meshlet that may be visible.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Entry {
    /// The meshlet in the low 25 bits, the pass above, the viewport in the last four.
    pub(super) key: u32,
    pub(super) actor: u16,
    /// Rows of the frame.
    pub(super) first_row: u16,
    pub(super) end_row: u16,
    pub(super) nearness: u16,
}

const PASS_SHIFT: u32 = MESHLETS.ilog2();
const PASSES: u32 = 7;
const VIEWPORT_SHIFT: u32 = 28;
const _: () = assert!(PASSES << PASS_SHIFT == (1 << VIEWPORT_SHIFT) - (1 << PASS_SHIFT));

/// The order of drawing: no two meshlets of a frame have the same place in it,
/// so that the picture does not depend on how many the list holds.
pub(super) type Place = (u32, u16, u32);

impl Entry {
    pub(super) const EMPTY: Self = Self {
        key: 0,
        actor: 0,
        first_row: 0,
        end_row: 0,
        nearness: 0,
    };

    /// The key of a meshlet in a viewport and a pass.
    pub(super) fn key(viewport: u16, pass: Pass, meshlet: u32) -> u32 {
        u32::from(viewport) << VIEWPORT_SHIFT | (pass as u32) << PASS_SHIFT | meshlet
    }

    /// Takes over the rows of the viewport at `rect` that its vertices have, which are
    /// some of those that it had.
    pub(super) fn narrow(&mut self, rows: Range<u16>, rect: &Rect) {
        self.first_row = self.first_row.max(rect.top.saturating_add(rows.start));
        self.end_row = self.end_row.min(rect.top.saturating_add(rows.end));
    }

    pub(super) fn touches(&self, rows: &Range<u16>) -> bool {
        self.first_row < rows.end && self.end_row > rows.start
    }

    pub(super) fn viewport(&self) -> u16 {
        (self.key >> VIEWPORT_SHIFT) as u16
    }

    pub(super) fn meshlet(&self) -> u32 {
        self.key & ((1 << PASS_SHIFT) - 1)
    }

    pub(super) fn pass(&self) -> Pass {
        let code = (self.key >> PASS_SHIFT & PASSES) as usize;
        Pass::ALL.get(code).copied().unwrap_or(Pass::Surface)
    }

    /// The meshlet and the viewport: its vertices are the same in all passes.
    pub(super) fn cache_key(&self) -> u32 {
        self.key & !(PASSES << PASS_SHIFT)
    }

    /// By viewport, then by pass, then near ones first (blended ones last), then by
    /// actor and meshlet.
    pub(super) fn place(&self) -> Place {
        let near = match self.pass() {
            Pass::Over => 0,
            Pass::Blended => self.nearness,
            _ => u16::MAX - self.nearness,
        };
        let part = self.key >> PASS_SHIFT;
        (part << 16 | u32::from(near), self.actor, self.key)
    }

    /// What it is sorted by.
    pub(super) fn key_of(&self, order: Order) -> Place {
        match order {
            Order::Drawing => self.place(),
            Order::Rows => (self.first_row.into(), 0, 0),
        }
    }
}

/// How a list is sorted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Order {
    /// As it is drawn: by [`Entry::place`].
    Drawing,
    /// By the first row.
    Rows,
}

/// Shell's sort with Ciura's gaps: small code, no recursion.
#[inline(never)]
pub(super) fn sort(list: &mut [Entry], order: Order) {
    for gap in [701, 301, 132, 57, 23, 10, 4, 1] {
        for start in gap..list.len() {
            let mut at = start;
            let Some(moved) = list.get(start).map(|entry| entry.key_of(order)) else {
                break;
            };
            while let Some(before) = at.checked_sub(gap) {
                let Ok([earlier, later]) = list.get_disjoint_mut([before, at]) else {
                    break;
                };
                if earlier.key_of(order) <= moved {
                    break;
                }
                core::mem::swap(earlier, later);
                at = before;
            }
        }
    }
}
