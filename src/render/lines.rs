//! Actors that are not drawn as surfaces: their edges, their vertices as marks, and
//! the faces that hide what is behind them.

use super::corner_source::weighted;
use super::draw::Part;
use super::paint::{Ids, Paint};
use super::stats::FrameStats;
use super::triangles::{Done, Draw, Triangle, clip_vertices, corner, triangles};
use crate::clip::clip_line;
use crate::frame::{Stored, Target};
use crate::light::Lit;
use crate::line::{DepthRule, Line, Mark, draw_coloured_line, draw_line, draw_mark};
use crate::math::{FineDepth, SUBPX_BITS};
use crate::raster::{Drawn, Fill, How, Sides, draw_depth, draw_triangle};
use crate::scene::layout::CHAINED;
use crate::scene::{Look, Representation, Scene};
use crate::shade::{Lookup, Pixel};
use crate::vertex::ScreenVertex;

/// When in a viewport something is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Pass {
    /// Faces of hidden-line actors, in the background's colour: their depth hides edges.
    Hidden,
    /// Surfaces.
    Surface,
    /// Lines and marks that may be hidden.
    Tested,
    /// Surfaces that mix with what is behind them, lines too: far ones first.
    Blended,
    /// Lines and marks over everything, in the order of actors.
    Over,
}

impl Pass {
    /// All, in order.
    pub(super) const ALL: [Self; 5] = [
        Self::Hidden,
        Self::Surface,
        Self::Tested,
        Self::Blended,
        Self::Over,
    ];

    /// Those in which an actor with `look` is drawn.
    pub(super) fn of(look: Option<&Look>, blended: bool) -> &'static [Self] {
        match look {
            None if blended => &[Self::Blended],
            None => &[Self::Surface],
            Some(look) => match (look.representation, look.depth_test) {
                (Representation::HiddenLine, true) => &[Self::Hidden, Self::Tested],
                (Representation::HiddenLine, false) => &[Self::Hidden, Self::Over],
                (_, true) => &[Self::Tested],
                (_, false) => &[Self::Over],
            },
        }
    }
}

/// How an actor is drawn; `None`: as a surface.
pub(super) fn look(scene: &Scene<'_>, actor: u16) -> Option<Look> {
    if cfg!(feature = "lines") {
        scene.look(actor)
    } else {
        None
    }
}

/// Draws a meshlet's edges or vertices.
#[inline(never)]
pub(super) fn draw_look<P: Paint>(
    paint: &P,
    part: &Part<'_>,
    look: &Look,
    target: &mut Target<'_, P::Stored>,
    stats: &mut FrameStats,
) {
    if look.representation == Representation::Points {
        draw_points(paint, part, look, target, stats);
    } else {
        draw_edges(paint, part, look, target, stats);
    }
}

fn rule(look: &Look) -> DepthRule {
    DepthRule {
        test: look.depth_test,
        bias: look.bias,
    }
}

/// Whether light is a colour; without the feature no scene has such a material.
fn is_coloured(part: &Part<'_>) -> bool {
    cfg!(feature = "light") && part.view.material.coloured
}

/// A pixel by its colour.
#[inline(always)]
fn coloured<P: Paint>(
    paint: &P,
    part: &Part<'_>,
    lit: Lit,
    place: [i32; 2],
    ids: Ids,
) -> P::Stored {
    let pixel = Pixel {
        lookup: Lookup::Colours(part.scene.colours()),
        lit,
        place,
        texel: [0; 2],
    };
    paint.surface(&pixel, ids)
}

fn draw_points<P: Paint>(
    paint: &P,
    part: &Part<'_>,
    look: &Look,
    target: &mut Target<'_, P::Stored>,
    stats: &mut FrameStats,
) {
    let shades = part.scene.shade(&part.view.material);
    let [width, height] = look.mark_size;
    let mark = Mark {
        width,
        height,
        offset: look.mark_offset,
        bits: part.scene.mark(look),
    };
    stats.marks += u32::from(part.meshlet.vertices);
    for number in 0..part.meshlet.vertices {
        let point = corner(&part.transformed, number);
        if point.is_outside() {
            continue;
        }
        let ids = Ids {
            actor: part.actor,
            triangle: Ids::POINT | (part.meshlet.first_vertex + u32::from(number)),
        };
        if is_coloured(part) {
            let lit = part.transformed.colour(number).map(|c| c as u16);
            let index = |place| Some(coloured(paint, part, lit, place, ids));
            draw_mark(target, point, &mark, &rule(look), index);
        } else if let Some(target) = P::Stored::indices(target) {
            let level = || (usize::from(point.level().to_bits()) + 32) >> 6;
            let index = paint.fill(shades, None, ids).index(level);
            draw_mark(target, point, &mark, &rule(look), |_| index);
        }
    }
}

fn draw_edges<P: Paint>(
    paint: &P,
    part: &Part<'_>,
    look: &Look,
    target: &mut Target<'_, P::Stored>,
    stats: &mut FrameStats,
) {
    let shades = part.scene.shade(&part.view.material);
    let (edges, first) = part.scene.meshlet_edges(part.number);
    stats.lines += edges.len() as u32;
    for (number, [from, to]) in (first..).zip(edges) {
        let indices = [*from, *to & !CHAINED];
        let ends = indices.map(|index| corner(&part.transformed, index));
        let [_, last] = ends;
        let any = ScreenVertex::any_outside(ends);
        let all = any && ScreenVertex::all_outside(ends);
        if all {
            continue;
        }
        let mut clipped = None;
        if any {
            let ends = clip_vertices(part.scene, part.view, part.meshlet, indices, ends);
            clipped = clip_line(part.view, ends);
            if clipped.is_none() {
                continue;
            }
        }
        let vertices = match &clipped {
            Some(line) => line.each_ref().map(|(vertex, _)| vertex),
            None => ends,
        };
        let line = Line {
            vertices,
            // What is left of a clipped line ends nowhere else.
            ends: [true, last.is_outside() || to & CHAINED == 0],
            width: look.line_width,
            perspective: part.view.perspective,
        };
        let ids = Ids {
            actor: part.actor,
            triangle: Ids::EDGE | number,
        };
        paint.line(target, vertices, ids);
        if is_coloured(part) {
            let [from, to] = indices.map(|index| part.transformed.colour(index));
            let colours = match &clipped {
                Some(line) => line
                    .each_ref()
                    .map(|(_, weights)| weighted(&[from, to, [0; 3]], *weights)),
                None => [from, to],
            };
            draw_coloured_line(target, &line, &rule(look), colours, |lit, place| {
                coloured(paint, part, lit, place, ids)
            });
        } else if let Some(target) = P::Stored::indices(target) {
            draw_line(target, &line, &rule(look), paint.fill(shades, None, ids));
        }
    }
}

/// Draws the faces of a hidden-line actor: they hide what is behind them, and lie
/// deeper than they are so that they do not hide their own edges.
#[inline(never)]
pub(super) fn draw_hidden<P: Paint>(
    paint: &P,
    part: &Part<'_>,
    look: &Look,
    target: &mut Target<'_, P::Stored>,
    stats: &mut FrameStats,
) {
    let mut done = Done::NONE;
    let mut hidden = Hidden {
        paint,
        part,
        target,
        width: look.line_width.into(),
    };
    triangles(part, &mut done, stats, &mut hidden);
}

/// What the faces of a hidden-line meshlet have in common.
struct Hidden<'a, 't, P: Paint> {
    paint: &'a P,
    part: &'a Part<'a>,
    target: &'a mut Target<'t, P::Stored>,
    /// Of its lines, as the look has it.
    width: i64,
}

impl<P: Paint> Draw for Hidden<'_, '_, P> {
    fn draw(&mut self, triangle: &Triangle<'_>) -> Drawn {
        const BOTH: Sides = Sides {
            front: true,
            back: true,
        };
        let corners = sunk(triangle, self.width);
        let fill = self.paint.hidden(self.part.ids(triangle.number));
        if let Fill::Depth = fill {
            return draw_depth(self.target, corners.each_ref(), BOTH);
        }
        match P::Stored::indices(self.target) {
            Some(target) => draw_triangle(target, corners.each_ref(), BOTH, false, || fill),
            None => Drawn::NOTHING,
        }
    }

    #[inline(always)]
    fn drawn(&self, triangle: &Triangle<'_>, how: How) {
        let ids = self.part.ids(triangle.number);
        self.paint.drawn(self.target, triangle.corners, how, ids);
    }
}

/// A triangle's corners, all deeper by `(|dz/dx| + |dz/dy|) * width / 2`, at most the
/// range of their depths, and 1.
fn sunk(triangle: &Triangle<'_>, width: i64) -> [ScreenVertex; 3] {
    let [a, b, c] = triangle.corners;
    let [za, zb, zc] = triangle.corners.map(|v| i64::from(v.z().to_bits()));
    let range = za.max(zb).max(zc) - za.min(zb).min(zc);
    let from_a = |v: &ScreenVertex| {
        [
            i64::from(v.x().to_bits()) - i64::from(a.x().to_bits()),
            i64::from(v.y().to_bits()) - i64::from(a.y().to_bits()),
        ]
    };
    let ([x1, y1], [x2, y2]) = (from_a(b), from_a(c));
    let (z1, z2) = (zb - za, zc - za);
    let area = (x1 * y2 - x2 * y1).abs();
    // 25 bits and 21, twice; 12 bits a pixel, 4 of the width.
    let across = (z1 * y2 - z2 * y1).abs() + (x1 * z2 - x2 * z1).abs();
    let slope = (across * (width << (SUBPX_BITS - 1))).checked_div(area);
    let deeper = slope.unwrap_or(range).min(range) + (1 << 4);
    triangle.corners.map(|v| {
        // What just rounds to 1 is the least depth.
        let z = (i64::from(v.z().to_bits()) - deeper).max(9);
        v.with_depth(FineDepth::from_bits(z as u32))
    })
}
