//! Triangles that are seen from behind, and the vertices that only they have, before any vertex
//! is transformed.

use super::stats::FrameStats;
use super::triangles::Done;
use crate::cull::Sight;
use crate::scene::layout::CONE_TRIANGLES;
use crate::scene::{Cull, Meshlet, Scene};
use crate::vertex::Used;
use crate::view::ActorView;

/// Marks groups of triangles that show sides that are not drawn as done, and gives the vertices
/// of the others.
#[inline(never)]
pub(super) fn leave_out_backs(
    scene: &Scene<'_>,
    view: &ActorView,
    (number, meshlet): (u32, &Meshlet),
    done: &mut Done,
    stats: &mut FrameStats,
) -> Used {
    let cones = scene.meshlet_cones(number, meshlet);
    // Cones tell back faces only.
    if view.material.cull != Cull::Back || cones.is_empty() {
        return Used::ALL;
    }
    let sight = Sight::new(view, meshlet);
    let mut any = false;
    for (done, cone) in done.groups().iter_mut().zip(cones) {
        if sight.is_behind(*cone) {
            *done = Done::GROUP;
            any = true;
        }
    }
    if !any {
        return Used::ALL;
    }
    let mut used = Used::NONE;
    let groups = scene.meshlet_triangles(meshlet).chunks(CONE_TRIANGLES);
    for (done, triangles) in done.groups().iter().zip(groups) {
        if *done == Done::GROUP {
            stats.triangles_behind += triangles.len() as u32;
        } else {
            used.add(triangles);
        }
    }
    used
}
