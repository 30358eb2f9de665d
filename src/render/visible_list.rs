//! The list of meshlets to draw, near ones first.

use core::ops::Range;

use super::actors::Actors;
use super::lines::{self, Pass};
use super::stats::FrameStats;
use crate::cull::{Verdict, judge};
use crate::math::{Rect, keep_rolled};
use crate::scene::Scene;
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
    fn place(&self) -> Place {
        let near = match self.pass() {
            Pass::Over => 0,
            Pass::Blended => self.nearness,
            _ => u16::MAX - self.nearness,
        };
        let part = self.key >> PASS_SHIFT;
        (part << 16 | u32::from(near), self.actor, self.key)
    }

    /// What it is sorted by.
    fn key_of(&self, order: Order) -> Place {
        match order {
            Order::Drawing => self.place(),
            Order::Rows => (self.first_row.into(), 0, 0),
        }
    }
}

/// How a list is sorted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Order {
    /// As it is drawn: by [`Entry::place`].
    Drawing,
    /// By the first row.
    Rows,
}

/// What a list, sorted as it is drawn, holds.
pub(super) struct Listed {
    /// How many entries.
    pub(super) count: usize,
    /// The row before which it holds all; the first of the rows asked for if not even all of the
    /// band are.
    pub(super) complete_to: u16,
    /// If not even all of the band are in it, the place of its last entry: the rest come after
    /// it.
    pub(super) last: Option<Place>,
}

/// Lists the visible meshlets that touch `rows`, or if they are too many, those that begin
/// first. If more than fit touch the band, which is the first rows, up to `band_end`: as many
/// of those that come after place `after` as fit, near ones first.
#[inline(never)]
pub(super) fn fill(
    entries: &mut [Entry],
    after: Option<Place>,
    scene: &Scene<'_>,
    actors: &mut Actors<'_>,
    (rows, band_end): (&Range<u16>, u16),
    stats: &mut FrameStats,
) -> Listed {
    let mut count = 0;
    // Entries that begin here or later are left out.
    let mut end = if after.is_some() { band_end } else { rows.end };
    // How a full list is sorted.
    let mut sorted = None;
    for (viewport, actor) in places(scene) {
        let rect = actors.viewport(viewport).rect;
        let Some(view) = actors.get(viewport, actor) else {
            continue;
        };
        let mesh = view.mesh;
        let look = lines::look(scene, actor);
        let passes = Pass::of(look.as_ref(), view.material.is_blended());
        let reach = look.map_or(0, |look| look.reach());
        for number in mesh.first_meshlet..mesh.first_meshlet.saturating_add(mesh.meshlets) {
            let Some(meshlet) = scene.meshlet(number) else {
                continue;
            };
            stats.meshlets += 1;
            let visible = match judge(view, &meshlet, rect.height(), reach) {
                Verdict::Visible(visible) => visible,
                Verdict::OutsideView => {
                    stats.meshlets_outside += 1;
                    continue;
                }
                Verdict::FacesAway => {
                    stats.meshlets_away += 1;
                    continue;
                }
            };
            for pass in passes {
                let part = u32::from(viewport) << VIEWPORT_SHIFT | (*pass as u32) << PASS_SHIFT;
                let mut entry = Entry {
                    key: part | number,
                    actor,
                    first_row: rect.top + visible.first_row,
                    end_row: rect.top + visible.end_row,
                    nearness: visible.nearness,
                };
                let touched = rows.start..end;
                if !entry.touches(&touched) || after.is_some_and(|after| entry.place() <= after) {
                    continue;
                }
                if let Some(slot) = entries.get_mut(count) {
                    *slot = entry;
                    count += 1;
                    continue;
                }
                let order = sorted.unwrap_or_else(|| {
                    let crowded = after.is_some();
                    let order = if crowded { Order::Drawing } else { Order::Rows };
                    sort(entries, order);
                    order
                });
                sorted = Some(order);
                entry = displace_last(entries, entry, order);
                if order == Order::Drawing {
                    continue;
                }
                end = entry.first_row.max(band_end);
                if entry.first_row < band_end {
                    // Now all in the list, and what fell out, touch the band.
                    sorted = Some(Order::Drawing);
                    sort(entries, Order::Drawing);
                    displace_last(entries, entry, Order::Drawing);
                }
            }
        }
    }
    let list = entries.get_mut(..count).unwrap_or_default();
    let crowded = sorted == Some(Order::Drawing);
    if !crowded {
        sort(list, Order::Drawing);
    }
    let last = if crowded {
        list.last().map(Entry::place)
    } else {
        None
    };
    Listed {
        count,
        complete_to: if crowded { rows.start } else { end },
        last,
    }
}

/// Every viewport with every actor, in the order of drawing.
fn places(scene: &Scene<'_>) -> impl Iterator<Item = (u16, u16)> {
    let actors = scene.actor_count();
    (0..scene.viewport_count()).flat_map(move |viewport| (0..actors).map(move |a| (viewport, a)))
}

/// Whether an entry comes before another. A call, so that a search does not have it twice.
#[inline(never)]
fn comes_before(one: &Entry, other: &Entry, order: Order) -> bool {
    one.key_of(order) < other.key_of(order)
}

/// Puts an entry into a full sorted list at its place; gives the last one, which falls out.
#[cold]
#[inline(never)]
fn displace_last(list: &mut [Entry], entry: Entry, order: Order) -> Entry {
    let at = list.partition_point(|held| comes_before(held, &entry, order));
    // Each takes over what stood before it.
    let mut carried = entry;
    for held in list.iter_mut().skip(at) {
        core::mem::swap(held, &mut carried);
        keep_rolled();
    }
    carried
}

/// Shell's sort with Ciura's gaps: small code, no recursion.
#[inline(never)]
fn sort(list: &mut [Entry], order: Order) {
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
