//! The list of meshlets to draw, near ones first.

use core::ops::Range;

use super::actors::Actors;
use super::stats::FrameStats;
use crate::cull::{Verdict, judge};
use crate::scene::Scene;

/// A meshlet that may be visible.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Entry {
    pub(super) meshlet: u32,
    pub(super) actor: u16,
    pub(super) first_row: u16,
    pub(super) end_row: u16,
    pub(super) nearness: u16,
}

impl Entry {
    pub(super) const EMPTY: Self = Self {
        meshlet: 0,
        actor: 0,
        first_row: 0,
        end_row: 0,
        nearness: 0,
    };

    pub(super) fn touches(&self, rows: &Range<u16>) -> bool {
        self.first_row < rows.end && self.end_row > rows.start
    }
}

/// Where the search for visible meshlets stands.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Cursor {
    actor: u16,
    meshlet: u32,
}

/// Lists visible meshlets that touch `rows`, from `cursor` on, until all are
/// looked at (then the cursor is `None`) or the list is full. Sorts them near
/// ones first; by actor first if the actors' matrices do not all fit.
pub(super) fn fill<'e>(
    entries: &'e mut [Entry],
    cursor: &mut Option<Cursor>,
    scene: &Scene<'_>,
    actors: &mut Actors<'_>,
    rows: &Range<u16>,
    height: u16,
    stats: &mut FrameStats,
) -> &'e [Entry] {
    let mut count = 0;
    while let Some(at) = cursor.as_mut() {
        if at.actor >= scene.actor_count() {
            *cursor = None;
            break;
        }
        let mesh = scene.mesh(scene.actor(at.actor).mesh);
        let found = (at.meshlet < mesh.meshlets)
            .then(|| scene.meshlet(mesh.first_meshlet.saturating_add(at.meshlet)))
            .flatten();
        let (Some(meshlet), Some(view)) = (found, actors.get(at.actor)) else {
            *at = Cursor {
                actor: at.actor + 1,
                meshlet: 0,
            };
            continue;
        };
        let Some(slot) = entries.get_mut(count) else {
            break;
        };
        let number = mesh.first_meshlet.saturating_add(at.meshlet);
        at.meshlet += 1;
        stats.meshlets += 1;
        match judge(view, &meshlet, height) {
            Verdict::Visible(visible) => {
                *slot = Entry {
                    meshlet: number,
                    actor: at.actor,
                    first_row: visible.first_row,
                    end_row: visible.end_row,
                    nearness: visible.nearness,
                };
                count += usize::from(slot.touches(rows));
            }
            Verdict::OutsideView => stats.meshlets_outside += 1,
            Verdict::FacesAway => stats.meshlets_away += 1,
        }
    }
    let list = entries.get_mut(..count).unwrap_or_default();
    let by_actor = !actors.all_fit();
    sort(list, |entry| {
        let group = if by_actor { u32::from(entry.actor) } else { 0 };
        group << 16 | u32::from(u16::MAX - entry.nearness)
    });
    list
}

/// Shell's sort with Ciura's gaps: small code, no recursion. Entries with equal
/// keys end in an order that depends on nothing but the list.
fn sort(list: &mut [Entry], key: impl Fn(&Entry) -> u32) {
    for gap in [701, 301, 132, 57, 23, 10, 4, 1] {
        for start in gap..list.len() {
            let mut at = start;
            while let Some(before) = at.checked_sub(gap) {
                let (Some(a), Some(b)) = (list.get(before), list.get(at)) else {
                    break;
                };
                if key(a) <= key(b) {
                    break;
                }
                list.swap(before, at);
                at = before;
            }
        }
    }
}
