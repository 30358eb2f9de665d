//! The list of meshlets to draw, near ones first.

use core::ops::Range;

use super::actors::Actors;
use super::entry::{Entry, Place};
use super::lines::{self, Pass};
use super::short_list::{Listed, ShortList};
use super::stats::FrameStats;
use crate::cull::{Verdict, judge};
use crate::scene::Scene;

/// Lists the visible meshlets, near ones first: those that touch the rows from the band's first
/// one to `end`, or as many of them as fit; after a place, those of the band that come after it.
/// See [`ShortList`].
#[inline(never)]
pub(super) fn fill(
    entries: &mut [Entry],
    after: Option<Place>,
    scene: &Scene<'_>,
    actors: &mut Actors<'_>,
    (band, end): (&Range<u16>, u16),
    stats: &mut FrameStats,
) -> Listed {
    let mut list = ShortList::new(entries, band.clone(), end, after);
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
                list.put(Entry {
                    key: Entry::key(viewport, *pass, number),
                    actor,
                    first_row: rect.top + visible.first_row,
                    end_row: rect.top + visible.end_row,
                    nearness: visible.nearness,
                });
            }
        }
    }
    list.finished()
}

/// Every viewport with every actor, in the order of drawing.
fn places(scene: &Scene<'_>) -> impl Iterator<Item = (u16, u16)> {
    let actors = scene.actor_count();
    (0..scene.viewport_count()).flat_map(move |viewport| (0..actors).map(move |a| (viewport, a)))
}
