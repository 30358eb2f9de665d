//! The triangles of a transformed meshlet, those that need it clipped.

use super::draw::Part;
use super::stats::FrameStats;
use crate::clip::{Cut, clip};
use crate::raster::{Drawn, How};
use crate::scene::layout::{CONE_TRIANGLES, MESHLET_TRIANGLES, MESHLET_VERTICES};
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

    /// Tells the paint of one that it has drawn.
    fn drawn(&self, triangle: &Triangle<'_>, how: How);
}

/// The triangles of a meshlet that have no more pixels: a bit each. In a band are many
/// that earlier ones are through with, most of them because they face away.
#[derive(Clone, Copy, Debug)]
pub(super) struct Done([u8; MESHLET_TRIANGLES / CONE_TRIANGLES]);

const _: () = assert!(CONE_TRIANGLES == u8::BITS as usize);

impl Done {
    pub const NONE: Self = Self([0; MESHLET_TRIANGLES / CONE_TRIANGLES]);
    /// All triangles of a byte.
    pub const GROUP: u8 = u8::MAX;

    /// The bytes.
    pub fn groups(&mut self) -> &mut [u8] {
        &mut self.0
    }
}

/// Hands each triangle that may be seen, of those that are not `done`, to `to`.
#[inline(always)]
pub(super) fn triangles(
    part: &Part<'_>,
    done: &mut Done,
    stats: &mut FrameStats,
    to: &mut impl Draw,
) {
    let mut first = 0;
    let triangles = part.scene.meshlet_triangles(part.meshlet);
    let groups = done.groups().iter_mut();
    for (done, triangles) in groups.zip(triangles.chunks(CONE_TRIANGLES)) {
        if *done != Done::GROUP {
            let mut now_done = u32::from(*done);
            let mut bit = 1;
            for (number, indices) in (first..).zip(triangles) {
                if now_done & bit == 0 && !triangle(part, (number, indices), stats, to) {
                    now_done |= bit;
                }
                bit <<= 1;
            }
            *done = now_done as u8;
        }
        first += CONE_TRIANGLES;
    }
}

/// Hands on a triangle, or the parts of it that are not clipped; gives whether rows below
/// may have pixels of it.
#[inline(always)]
fn triangle(
    part: &Part<'_>,
    (number, indices): (usize, &[u8; 3]),
    stats: &mut FrameStats,
    to: &mut impl Draw,
) -> bool {
    let corners = indices.map(|index| corner(&part.transformed, index));
    if part.inside || !ScreenVertex::any_outside(corners) {
        if let Some(below) = part.below {
            // Not looked at where it is not asked for, though it costs little.
            core::hint::black_box(());
            if corners.iter().all(|corner| corner.y() >= below) {
                stats.triangles_missed += 1;
                return true;
            }
        }
        let triangle = Triangle {
            number,
            indices,
            corners,
            cuts: None,
        };
        let Drawn { how, more } = to.draw(&triangle);
        to.drawn(&triangle, how);
        stats.count(how);
        return more;
    }
    if ScreenVertex::all_outside(corners) {
        stats.triangles_outside += 1;
        return false;
    }
    clipped(part, (number, indices, corners), stats, to)
}

/// Hands on the parts of a triangle that are not clipped. Kept out of its caller, whose stack
/// it would take in frames that clip nothing.
#[cold]
#[inline(never)]
fn clipped(
    part: &Part<'_>,
    (number, indices, corners): (usize, &[u8; 3], [&ScreenVertex; 3]),
    stats: &mut FrameStats,
    to: &mut impl Draw,
) -> bool {
    stats.triangles_clipped += 1;
    // Its parts are counted by what becomes of them.
    stats.triangles = stats.triangles.wrapping_add(1);
    let Part {
        scene,
        view,
        meshlet,
        ..
    } = *part;
    let polygon = clip(view, clip_vertices(scene, view, meshlet, *indices, corners));
    let all = polygon.vertices().iter().zip(polygon.cuts());
    let mut all = all.clone().zip(all.skip(1));
    let Some((first, _)) = all.next() else {
        return false;
    };
    let mut more_of_any = false;
    for (b, c) in all {
        let triangle = Triangle {
            number,
            indices,
            corners: [first.0, b.0, c.0],
            cuts: Some([first.1, b.1, c.1]),
        };
        let Drawn { how, more } = to.draw(&triangle);
        to.drawn(&triangle, how);
        stats.count(how);
        stats.triangles = stats.triangles.wrapping_sub(1);
        more_of_any |= more;
    }
    more_of_any
}

/// A meshlet's vertex by index.
#[inline(always)]
pub(super) fn corner<'a>(transformed: &TransformedMeshlet<'a>, index: u8) -> &'a ScreenVertex {
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
