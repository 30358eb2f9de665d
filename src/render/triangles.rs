//! The triangles of a transformed meshlet, those that need it clipped.

use super::stats::FrameStats;
use crate::clip::{Cut, clip};
use crate::raster::Drawn;
use crate::scene::layout::MESHLET_VERTICES;
use crate::scene::{Meshlet, Scene};
use crate::vertex::{ClipVertex, ScreenVertex, TransformedMeshlet, vertex};
use crate::view::{ActorView, MeshletRows};

/// A triangle of a meshlet, or a part of one.
pub(super) struct Triangle<'a> {
    /// Its number in the meshlet.
    pub number: usize,
    /// The meshlet's vertices that it has.
    pub indices: &'a [u8; 3],
    /// Its corners on the screen.
    pub corners: [&'a ScreenVertex; 3],
    /// Of a part, where its corners are.
    pub cuts: Option<[&'a Cut; 3]>,
}

/// What is done with triangles. Not a closure, because those that are called in two
/// places are not inlined, and a fine mesh has many triangles.
pub(super) trait Draw {
    /// Draws one.
    fn draw(&mut self, triangle: &Triangle<'_>) -> Drawn;
}

/// Hands each triangle that may be seen to `to`.
#[inline(always)]
pub(super) fn triangles(
    scene: &Scene<'_>,
    view: &ActorView,
    meshlet: &Meshlet,
    transformed: &TransformedMeshlet,
    stats: &mut FrameStats,
    to: &mut impl Draw,
) {
    stats.triangles += u32::from(meshlet.triangles);
    for (number, indices) in scene.meshlet_triangles(meshlet).iter().enumerate() {
        let corners = indices.map(|index| corner(transformed, index));
        let (any, all) = ScreenVertex::any_and_all_outside(corners);
        if all {
            stats.triangles_outside += 1;
            continue;
        }
        if !any {
            stats.count(to.draw(&Triangle {
                number,
                indices,
                corners,
                cuts: None,
            }));
            continue;
        }
        stats.triangles_clipped += 1;
        let polygon = clip(view, clip_vertices(scene, view, meshlet, *indices, corners));
        let all = polygon.vertices().iter().zip(polygon.cuts());
        let mut all = all.clone().zip(all.skip(1));
        let Some((first, _)) = all.next() else {
            continue;
        };
        for (b, c) in all {
            stats.count(to.draw(&Triangle {
                number,
                indices,
                corners: [first.0, b.0, c.0],
                cuts: Some([first.1, b.1, c.1]),
            }));
        }
    }
}

/// A meshlet's vertex by index.
#[inline(always)]
pub(super) fn corner(transformed: &TransformedMeshlet, index: u8) -> &ScreenVertex {
    #[expect(clippy::indexing_slicing, reason = "held below the array's length")]
    &transformed.vertices[usize::from(index) % MESHLET_VERTICES]
}

/// Some of a meshlet's vertices in clip space. Kept vertices have no clip coordinates:
/// they are made again for the few triangles and edges that need them.
#[cold]
pub(super) fn clip_vertices<const N: usize>(
    scene: &Scene<'_>,
    view: &ActorView,
    meshlet: &Meshlet,
    indices: [u8; N],
    kept: [&ScreenVertex; N],
) -> [ClipVertex; N] {
    let rows = MeshletRows::new(view, meshlet);
    let mut vertices = indices.map(|index| vertex(scene, &rows, view, meshlet, index));
    for (vertex, kept) in vertices.iter_mut().zip(kept) {
        vertex.level = i32::from(kept.level().to_bits());
    }
    vertices
}
