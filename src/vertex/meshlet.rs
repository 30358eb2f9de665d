//! A whole meshlet, transformed and lit.

use core::ops::Range;

use super::{ClipVertex, Heights, Perspective, ScreenVertex, Used, guard, project};
use crate::light::{Patch, ShortUnit, SurfaceLights, vertex_normal};
use crate::math::{FineLevel, HALF_PX, SUBPX_BITS, SubPx};
use crate::scene::layout::MESHLET_VERTICES;
use crate::scene::{Meshlet, Scene, Shading};
use crate::view::{ActorView, MeshletRows};

/// Colours that take the room of a vertex.
const COLOURS: usize = 3;
/// Room for the colours of a meshlet, in vertices.
pub const COLOUR_ROOM: usize = if cfg!(feature = "light") {
    MESHLET_VERTICES.div_ceil(COLOURS)
} else {
    0
};

/// The vertices of one meshlet on the screen.
#[derive(Clone, Copy, Debug)]
pub struct TransformedMeshlet<'a> {
    /// The vertices.
    pub vertices: &'a [ScreenVertex; MESHLET_VERTICES],
    /// See [`Room`].
    colours: &'a [ScreenVertex],
}

impl TransformedMeshlet<'_> {
    /// A vertex's colour in 1/64 of a level.
    pub fn colour(&self, index: u8) -> [i32; 3] {
        let (number, part) = (usize::from(index) / COLOURS, usize::from(index) % COLOURS);
        let words = self.colours.get(number).map(ScreenVertex::words);
        let packed = words.and_then(|words| words.get(part).copied());
        let packed = packed.unwrap_or(0);
        [0, 10, 20].map(|shift| ((packed >> shift & 1023) << 4) as i32)
    }
}

/// Where a meshlet's vertices go.
#[derive(Debug)]
pub struct Room<'a> {
    /// The vertices.
    pub vertices: &'a mut [ScreenVertex; MESHLET_VERTICES],
    /// Their colours, of a material that goes by colour and is lit at vertices: three in the
    /// room of a vertex, each 10 bits of red (lowest), green and blue. [`COLOUR_ROOM`], or
    /// nothing if the scene has no such material.
    pub colours: &'a mut [ScreenVertex],
}

impl<'a> Room<'a> {
    /// What is there.
    pub fn held(self) -> TransformedMeshlet<'a> {
        TransformedMeshlet {
            vertices: self.vertices,
            colours: self.colours,
        }
    }
}

/// Transforms and lights the vertices of `meshlet` that are `used` into `out`. Gives the rows of
/// the viewport between them, unless some have to be clipped.
#[inline(never)]
pub fn transform_meshlet(
    scene: &Scene<'_>,
    view: &ActorView,
    meshlet: &Meshlet,
    used: &Used,
    out: &mut Room<'_>,
) -> Option<Range<u16>> {
    let rows = MeshletRows::new(view, meshlet);
    let gouraud = cfg!(feature = "gouraud") && view.material.shading == Shading::Gouraud;
    let full = cfg!(feature = "light") && view.material.full;
    let lit = gouraud && !full;
    let vertices = scene.meshlet_vertices(meshlet);
    let fine = scene.meshlet_fine(meshlet, &view.mesh);
    let perspective = Perspective::of(view).filter(|_| inside(view, meshlet, &rows));
    if let Some(perspective) = perspective {
        // Each in a loop of its own: together they would not fit into registers.
        if fine.is_empty() {
            for ((out, vertex), used) in out.vertices.iter_mut().zip(vertices).zip(used.iter()) {
                if *used != 0 {
                    let [x, y, z, _] = vertex.map(i16::from_le);
                    *out = on_the_way(&perspective, rows.apply([x, y, z]));
                }
            }
        } else {
            let stored = vertices.iter().zip(fine).zip(used.iter());
            for (out, ((vertex, fine), used)) in out.vertices.iter_mut().zip(stored) {
                if *used != 0 {
                    let place = rows.apply_fine(meshlet.steps(*vertex, *fine));
                    *out = on_the_way(&perspective, place);
                }
            }
        }
        if cfg!(narrow_multiply) {
            for ((out, _), used) in out.vertices.iter_mut().zip(vertices).zip(used.iter()) {
                if *used != 0 {
                    *out = perspective.project_inside(out.in_clip());
                }
            }
        }
    } else {
        let all = out.vertices.iter_mut().zip(vertices).zip(used.iter());
        for (i, ((out, vertex), _)) in all.enumerate().filter(|(_, (_, used))| **used != 0) {
            let [x, y, distance] = clip_place(&rows, meshlet, *vertex, fine.get(i));
            let vertex = ClipVertex {
                x,
                y,
                distance,
                level: 0,
            };
            *out = project(view, &vertex);
        }
    }
    if lit && fine.is_empty() {
        for ((out, vertex), used) in out.vertices.iter_mut().zip(vertices).zip(used.iter()) {
            if *used != 0 {
                *out = out.lit(view.lights.level(normal(vertex)));
            }
        }
    } else if lit {
        let stored = vertices.iter().zip(fine).zip(used.iter());
        for (out, ((vertex, [.., low]), used)) in out.vertices.iter_mut().zip(stored) {
            if *used != 0 {
                *out = out.lit(view.lights.fine_level(normal(vertex), *low));
            }
        }
    }
    if full && gouraud {
        light_vertices(scene, view, meshlet, used, out);
    }
    let mut heights = Heights::NONE;
    for ((vertex, _), used) in out.vertices.iter().zip(vertices).zip(used.iter()) {
        if *used != 0 {
            heights.add(vertex);
        }
    }
    rows_between(&heights)
}

/// A vertex within all planes, projected; where registers are few, that is left to a loop of
/// its own.
#[inline(always)]
fn on_the_way(perspective: &Perspective<'_>, clip: [i32; 3]) -> ScreenVertex {
    if cfg!(narrow_multiply) {
        ScreenVertex::to_be_projected(clip)
    } else {
        perspective.project_inside(clip)
    }
}

/// Whether a meshlet's sphere is within all planes, so far that no vertex has to be
/// clipped.
#[inline(never)]
fn inside(view: &ActorView, meshlet: &Meshlet, rows: &MeshletRows) -> bool {
    let [x, y, distance] = rows.base().map(i64::from);
    // Rounded up, and 2 for the coordinate's own rounding.
    let radius = i64::from(meshlet.radius_steps());
    let [reach_x, reach_y, reach_d] = view
        .row_lengths
        .map(|length| ((radius * i64::from(length)) >> view.row_fraction) + 2);
    let (nearest, farthest) = (distance - reach_d, distance + reach_d);
    if nearest < i64::from(view.near) || farthest > i64::from(view.far) {
        return false;
    }
    let guard = i64::from(guard(view, nearest.min(i32::MAX.into()) as i32));
    x.abs() + reach_x <= guard && y.abs() + reach_y <= guard
}

/// The rows whose centres are between vertices.
fn rows_between(heights: &Heights) -> Option<Range<u16>> {
    let (least, most) = heights.ends()?;
    let row = |y: SubPx| {
        let row = (y.to_bits().saturating_add(HALF_PX - 1)) >> SUBPX_BITS;
        row.clamp(0, u16::MAX.into()) as u16
    };
    Some(row(least)..row(most))
}

/// Lights all vertices with everything that the light model has.
#[inline(never)]
fn light_vertices(
    scene: &Scene<'_>,
    view: &ActorView,
    meshlet: &Meshlet,
    used: &Used,
    out: &mut Room<'_>,
) {
    let patch = Patch::new(meshlet, &view.mesh);
    let mut lights = SurfaceLights::NONE;
    lights.set(scene, view, &patch);
    let tints = scene.meshlet_colours(meshlet, &view.mesh);
    let fine = scene.meshlet_fine(meshlet, &view.mesh);
    let vertices = scene.meshlet_vertices(meshlet).iter().enumerate();
    for (((i, vertex), out_vertex), used) in vertices.zip(&mut *out.vertices).zip(used.iter()) {
        if *used == 0 {
            continue;
        }
        let (place, normal) = surface_point(&patch, *vertex, fine.get(i));
        let tint = tints.get(i).map(|[r, g, b, _]| [*r, *g, *b]);
        let lit = lights.shine(normal, place, tint);
        let [level, ..] = lit;
        *out_vertex = out_vertex.lit(FineLevel::from_bits(level));
        if let Some(colours) = out.colours.get_mut(i / COLOURS) {
            let [r, g, b] = lit.map(|c| (u32::from(c) + 8) >> 4);
            colours.set_word(i % COLOURS, r | g << 10 | b << 20);
        }
    }
}

/// Place (in the units of the patch) and normal of a vertex as the meshlet has it.
pub fn surface_point(
    patch: &Patch,
    vertex: [i16; 4],
    fine: Option<&[u8; 4]>,
) -> ([i32; 3], ShortUnit) {
    let [x, y, z, code] = vertex.map(i16::from_le);
    let [lx, ly, lz, low] = fine.copied().unwrap_or_default();
    let place = patch.place([x, y, z], [lx, ly, lz]);
    (place, vertex_normal(code, fine.map(|_| low)))
}

/// One vertex of a meshlet in clip space, for clipping; not lit.
#[inline(never)]
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
    let fine = scene.meshlet_fine(meshlet, &view.mesh).get(index);
    let [x, y, distance] = clip_place(rows, meshlet, vertex, fine);
    ClipVertex {
        x,
        y,
        distance,
        level: 0,
    }
}

/// A vertex's clip coordinates x, y and distance, wherever there is no hurry.
#[inline(never)]
fn clip_place(
    rows: &MeshletRows,
    meshlet: &Meshlet,
    vertex: [i16; 4],
    fine: Option<&[u8; 4]>,
) -> [i32; 3] {
    let [x, y, z, _] = vertex.map(i16::from_le);
    match fine {
        Some(fine) => rows.apply_fine(meshlet.steps(vertex, *fine)),
        None => rows.apply([x, y, z]),
    }
}

/// The two bytes of a vertex's normal.
#[inline(always)]
fn normal(vertex: &[i16; 4]) -> [i8; 2] {
    let [.., normal] = vertex.map(i16::from_le);
    normal.to_le_bytes().map(|b| b as i8)
}
