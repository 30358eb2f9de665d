//! One meshlet into one band.

use super::meshlet_cache::MeshletCache;
use super::paint::{Ids, Paint};
use super::stats::FrameStats;
use super::visible_list::Entry;
use crate::clip::clip;
use crate::frame::Target;
use crate::raster::{Sides, draw_triangle};
use crate::scene::layout::MESHLET_VERTICES;
use crate::scene::{Cull, Meshlet, Scene, Shading};
use crate::vertex::{ScreenVertex, TransformedMeshlet, transform_meshlet, vertex};
use crate::view::{ActorView, MeshletRows, round_level};

/// Draws the triangles of a listed meshlet into its viewport's rows.
pub(super) fn draw_meshlet<P: Paint>(
    paint: &P,
    scene: &Scene<'_>,
    view: &ActorView,
    entry: &Entry,
    cache: &mut MeshletCache<'_>,
    target: &mut Target<'_>,
    stats: &mut FrameStats,
) {
    let Some(meshlet) = scene.meshlet(entry.meshlet()) else {
        return;
    };
    let key = (entry.actor, entry.key);
    let transformed = cache.get(key, entry.end_row, |out| {
        stats.meshlets_transformed += 1;
        stats.vertices += u32::from(meshlet.vertices);
        transform_meshlet(scene, view, &meshlet, out);
    });
    let Some(vertices) = transformed else { return };

    let shades = scene.shade(&view.material);
    let flat = view.material.shading == Shading::Flat;
    let sides = sides(view.material.cull);
    let normals = scene.meshlet_face_normals(&meshlet, &view.mesh);
    stats.triangles += u32::from(meshlet.triangles);
    for (i, indices) in scene.meshlet_triangles(&meshlet).iter().enumerate() {
        let triangle = indices.map(|index| corner(vertices, index));
        let [a, b, c] = triangle.map(|v| v.outside);
        if a & b & c != 0 {
            stats.triangles_outside += 1;
            continue;
        }
        let fill = || {
            let level = flat.then(|| {
                let normal = normals.get(i).copied().unwrap_or_default();
                round_level(view.lights.face_level(u32::from_le(normal)))
            });
            let triangle = meshlet.first_triangle + i as u32;
            paint.fill(
                shades,
                level,
                Ids {
                    actor: entry.actor,
                    triangle,
                },
            )
        };
        if a | b | c == 0 {
            stats.count(draw_triangle(
                target,
                triangle,
                sides,
                view.perspective,
                fill,
            ));
            continue;
        }
        stats.triangles_clipped += 1;
        let polygon = clip(view, clip_corners(scene, view, &meshlet, indices));
        let Some((first, rest)) = polygon.vertices().split_first() else {
            continue;
        };
        for (b, c) in rest.iter().zip(rest.iter().skip(1)) {
            stats.count(draw_triangle(
                target,
                [first, b, c],
                sides,
                view.perspective,
                fill,
            ));
        }
    }
}

/// A meshlet's vertex by index.
#[inline(always)]
fn corner(vertices: &TransformedMeshlet, index: u8) -> &ScreenVertex {
    #[expect(clippy::indexing_slicing, reason = "held below the array's length")]
    &vertices[usize::from(index) % MESHLET_VERTICES]
}

fn sides(cull: Cull) -> Sides {
    Sides {
        front: cull != Cull::Front,
        back: cull != Cull::Back,
    }
}

/// The corners of a triangle in clip space. Kept vertices have no clip
/// coordinates: they are made again for the few triangles that need them.
#[cold]
fn clip_corners(
    scene: &Scene<'_>,
    view: &ActorView,
    meshlet: &Meshlet,
    indices: &[u8; 3],
) -> [crate::vertex::ClipVertex; 3] {
    let rows = MeshletRows::new(view, meshlet);
    indices.map(|index| vertex(scene, &rows, view, meshlet, index))
}
