//! A whole meshlet, transformed and lit.

use super::{ClipVertex, ScreenVertex, project};
use crate::scene::layout::MESHLET_VERTICES;
use crate::scene::{Meshlet, Scene, Shading};
use crate::view::{ActorView, MeshletRows};

/// The vertices of one meshlet on the screen.
pub type TransformedMeshlet = [ScreenVertex; MESHLET_VERTICES];

/// Transforms and lights all vertices of `meshlet` into `out`.
pub fn transform_meshlet(
    scene: &Scene<'_>,
    view: &ActorView,
    meshlet: &Meshlet,
    out: &mut TransformedMeshlet,
) {
    let rows = MeshletRows::new(view, meshlet);
    let lit = view.material.shading == Shading::Gouraud;
    for (out, vertex) in out.iter_mut().zip(scene.meshlet_vertices(meshlet)) {
        *out = project(view, &clip_vertex(&rows, view, *vertex, lit));
    }
}

/// One vertex of a meshlet in clip space, for clipping.
pub fn vertex(rows: &MeshletRows, view: &ActorView, vertex: [i16; 4]) -> ClipVertex {
    clip_vertex(
        rows,
        view,
        vertex,
        view.material.shading == Shading::Gouraud,
    )
}

#[inline(always)]
fn clip_vertex(rows: &MeshletRows, view: &ActorView, vertex: [i16; 4], lit: bool) -> ClipVertex {
    let [x, y, z, normal] = vertex.map(i16::from_le);
    let [x, y, distance] = rows.apply([x, y, z]);
    let level = if lit {
        let normal = normal.to_le_bytes().map(|b| b as i8);
        i32::from(view.lights.level(normal).to_bits())
    } else {
        0
    };
    ClipVertex {
        x,
        y,
        distance,
        level,
    }
}
