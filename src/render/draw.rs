//! One meshlet into one band.

use core::ops::Range;

use super::entry::Entry;
use super::facing::leave_out_backs;
use super::lines::{self, Pass, draw_hidden, draw_look};
use super::meshlet_cache::{Held, MeshletCache};
use super::paint::{Ids, Paint};
use super::stats::FrameStats;
use super::surface::draw_surface_meshlet;
use super::triangles::{Done, Draw, Triangle, triangles};
use crate::fog::Haze;
use crate::frame::{Stored, Target};
use crate::math::{HALF_PX, Rect, SUBPX_BITS, SubPx};
use crate::raster::{Drawn, How, Sides, draw_triangle};
use crate::scene::{Cull, Meshlet, Scene, Shading};
use crate::vertex::{TransformedMeshlet, Used, transform_meshlet};
use crate::view::{ActorView, round_level};

/// Where a meshlet is drawn.
pub(super) struct Place<'a> {
    pub view: &'a ActorView,
    /// The viewport's fog, if it has one.
    pub haze: Option<&'a Haze>,
    /// Its viewport.
    pub rect: &'a Rect,
    /// The band's rows of the frame.
    pub rows: &'a Range<u16>,
}

/// Draws what a listed meshlet has in its pass, into its viewport's rows. When its
/// vertices are known, so are its rows, and the entry is told.
#[inline(never)]
pub(super) fn draw_meshlet<P: Paint>(
    paint: &P,
    scene: &Scene<'_>,
    Place {
        view,
        haze,
        rect,
        rows,
    }: Place<'_>,
    entry: &mut Entry,
    cache: &mut MeshletCache<'_>,
    target: &mut Target<'_, P::Stored>,
    stats: &mut FrameStats,
) {
    let Some(meshlet) = scene.meshlet(entry.meshlet()) else {
        return;
    };
    let key = (entry.actor, entry.cache_key());
    let held = cache.get(key, entry.end_row, |out, done| {
        // Lines and points are drawn whatever the side, and more than lies between vertices.
        let surface = lines::look(scene, entry.actor).is_none();
        let used = if surface {
            leave_out_backs(scene, view, (entry.meshlet(), &meshlet), done, stats)
        } else {
            Used::ALL
        };
        let vertices = used.count(meshlet.vertices);
        stats.meshlets_transformed += 1;
        stats.vertices += u32::from(vertices);
        paint.transformed(entry.actor, vertices);
        let rows = transform_meshlet(scene, view, &meshlet, &used, out);
        let inside = rows.is_some();
        if let (Some(rows), true) = (rows, surface) {
            entry.narrow(rows, rect);
        }
        (entry.end_row, inside)
    });
    let (Some(held), true) = (held, entry.touches(rows)) else {
        return;
    };
    let Held {
        vertices: transformed,
        inside,
        done,
    } = held;
    // The first sub-pixel whose row, if it is a vertex's, is not above the band's end.
    let below = SubPx::from_bits((i32::from(target.end) << SUBPX_BITS) - (HALF_PX - 1));
    let part = Part {
        scene,
        view,
        actor: entry.actor,
        number: entry.meshlet(),
        meshlet: &meshlet,
        transformed,
        inside,
        below: (entry.end_row > rows.end).then_some(below),
        haze,
    };
    if !matches!(entry.pass(), Pass::Surface | Pass::Blended) {
        // Without the feature there is no such pass.
        if let Some(look) = lines::look(scene, entry.actor) {
            if entry.pass() == Pass::Hidden {
                draw_hidden(paint, &part, &look, target, stats);
            } else {
                draw_look(paint, &part, &look, target, stats);
            }
        }
    } else if cfg!(feature = "light") && view.material.is_surface() {
        draw_surface_meshlet(paint, &part, done, target, stats);
    } else if let Some(target) = P::Stored::indices(target) {
        draw_plain_meshlet(paint, &part, done, target, stats);
    }
}

/// A meshlet of an actor, ready to be drawn.
pub(super) struct Part<'a> {
    pub scene: &'a Scene<'a>,
    pub view: &'a ActorView,
    pub actor: u16,
    /// The meshlet's place in the scene's list.
    pub number: u32,
    pub meshlet: &'a Meshlet,
    pub transformed: TransformedMeshlet<'a>,
    /// Whether none of its vertices has to be clipped.
    pub inside: bool,
    /// If it may have pixels below the band: where those have vertices.
    pub below: Option<SubPx>,
    /// Of a blended one, the fog before it.
    pub haze: Option<&'a Haze>,
}

impl Part<'_> {
    /// Whose pixels those of a triangle are.
    #[inline(always)]
    pub(super) fn ids(&self, triangle: usize) -> Ids {
        Ids {
            actor: self.actor,
            triangle: self.meshlet.first_triangle + triangle as u32,
        }
    }

    pub(super) fn sides(&self) -> Sides {
        let cull = self.view.material.cull;
        Sides {
            front: cull != Cull::Front,
            back: cull != Cull::Back,
        }
    }
}

/// A meshlet whose triangles have one light level, or one at each corner. Kept out of
/// its caller, whose other branches would take registers from it.
#[inline(never)]
fn draw_plain_meshlet<P: Paint>(
    paint: &P,
    part: &Part<'_>,
    done: &mut Done,
    target: &mut Target<'_>,
    stats: &mut FrameStats,
) {
    let (scene, view, meshlet) = (part.scene, part.view, part.meshlet);
    let mut plain = Plain {
        paint,
        part,
        target,
        shades: scene.shade(&view.material),
        flat: view.material.shading == Shading::Flat,
        normals: scene.meshlet_face_normals(meshlet, &view.mesh),
        sides: part.sides(),
    };
    triangles(part, done, stats, &mut plain);
}

/// What the triangles of a plain meshlet have in common.
struct Plain<'a, 't, P> {
    paint: &'a P,
    part: &'a Part<'a>,
    target: &'a mut Target<'t>,
    shades: &'a [u8; 256],
    flat: bool,
    normals: &'a [u32],
    sides: Sides,
}

impl<P: Paint> Draw for Plain<'_, '_, P> {
    #[inline(always)]
    fn draw(&mut self, triangle: &Triangle<'_>) -> Drawn {
        let (part, view) = (self.part, self.part.view);
        let fill = || {
            let level = self.flat.then(|| {
                let normal = self.normals.get(triangle.number).copied();
                round_level(
                    view.lights
                        .face_level(u32::from_le(normal.unwrap_or_default())),
                )
            });
            self.paint
                .fill(self.shades, level, part.ids(triangle.number))
        };
        let corners = triangle.corners;
        draw_triangle(self.target, corners, self.sides, view.perspective, fill)
    }

    #[inline(always)]
    fn drawn(&self, triangle: &Triangle<'_>, how: How) {
        let ids = self.part.ids(triangle.number);
        self.paint.drawn(self.target, triangle.corners, how, ids);
    }
}
