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
    let vertices = scene.meshlet_vertices(meshlet);
    let fine = scene.meshlet_fine(meshlet, &view.mesh);
    if fine.is_empty() {
        for (out, vertex) in out.iter_mut().zip(vertices) {
            let [x, y, z, normal] = vertex.map(i16::from_le);
            let place = rows.apply([x, y, z]);
            *out = project(view, &clip_vertex(view, place, normal, None, lit));
        }
        return;
    }
    for ((out, vertex), fine) in out.iter_mut().zip(vertices).zip(fine) {
        let [.., normal] = vertex.map(i16::from_le);
        let place = rows.apply_fine(fine_place(meshlet, *vertex, *fine));
        let [.., low] = *fine;
        *out = project(view, &clip_vertex(view, place, normal, Some(low), lit));
    }
}

/// One vertex of a meshlet in clip space, for clipping.
pub fn vertex(
    scene: &Scene<'_>,
    rows: &MeshletRows,
    view: &ActorView,
    meshlet: &Meshlet,
    index: u8,
) -> ClipVertex {
    let index = usize::from(index);
    let vertex = scene
        .meshlet_vertices(meshlet)
        .get(index)
        .copied()
        .unwrap_or_default();
    let [x, y, z, normal] = vertex.map(i16::from_le);
    let (place, low) = match scene.meshlet_fine(meshlet, &view.mesh).get(index) {
        Some(fine) => {
            let [.., low] = *fine;
            (
                rows.apply_fine(fine_place(meshlet, vertex, *fine)),
                Some(low),
            )
        }
        None => (rows.apply([x, y, z]), None),
    };
    let lit = view.material.shading == Shading::Gouraud;
    clip_vertex(view, place, normal, low, lit)
}

/// A vertex of a fine mesh in grid steps from the base.
fn fine_place(meshlet: &Meshlet, vertex: [i16; 4], fine: [u8; 4]) -> [i32; 3] {
    let [x, y, z, _] = vertex.map(|c| i32::from(i16::from_le(c)));
    let ([sx, sy, sz], [fx, fy, fz, _]) = (meshlet.shifts, fine.map(i32::from));
    [(x << sx) + fx, (y << sy) + fy, (z << sz) + fz]
}

#[inline(always)]
fn clip_vertex(
    view: &ActorView,
    [x, y, distance]: [i32; 3],
    normal: i16,
    low: Option<u8>,
    lit: bool,
) -> ClipVertex {
    let level = if lit {
        let normal = normal.to_le_bytes().map(|b| b as i8);
        let level = match low {
            Some(low) => view.lights.fine_level(normal, low),
            None => view.lights.level(normal),
        };
        i32::from(level.to_bits())
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
