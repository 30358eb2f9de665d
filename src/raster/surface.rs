//! Triangles of surfaces that need more than a light level: any few attributes,
//! interpolated in perspective and handed on in runs of pixels. Those for which that is more
//! than is seen go pixel by pixel: see [`draw_shaded`](super::draw_shaded).
//!
//! Each attribute times 1 / distance, and 1 / distance itself, are linear on the
//! screen. They are held in 64 bits, exact to 2^-28 of their largest value, and
//! divided at the ends of runs so short that a parabola between does not show (after
//! Heckbert and Moreton, "Interpolation for polygon texture mapping and shading",
//! 1991), or a cubic where a texel is all that is asked for.

use super::corners::{Corner, Corners, SurfaceKind};
use super::footprint::Footprint;
use super::gradient::places;
use super::run::{Path, Run, Shade};
use super::scan::{Shape, Span, scan};
use super::sliver::{mix, weights};
use super::surface_planes::Surface;
use super::triangle::{Drawn, Sides, shown, sort};
use crate::frame::{Stored, Target};
use crate::math::SUBPX_BITS;
use crate::vertex::ScreenVertex;

/// Draws a triangle if it shows one of `sides`, run by run; `corners` is asked for
/// only then, in the order of the vertices.
#[inline(never)]
pub fn draw_surface<const A: usize, C: Stored>(
    target: &mut Target<'_, C>,
    triangle: [&ScreenVertex; 3],
    sides: Sides,
    kind: SurfaceKind,
    corners: &mut dyn FnMut() -> [Corner<A>; 3],
    shade: &impl Shade<A, C>,
) -> Drawn {
    let seen = match shown(target, triangle, sides) {
        Ok(seen) => seen,
        Err(drawn) => return drawn,
    };
    let [a, b, c] = triangle;
    let [ka, kb, kc] = corners();
    let (sorted, flipped) = sort([(a, ka), (b, kb), (c, kc)]);
    let corners = Corners::new(sorted.each_ref().map(|(_, corner)| corner), kind);
    let shape = Shape {
        sorted: sorted.map(|(v, _)| v),
        area: if flipped { -seen.area } else { seen.area },
        rows: seen.rows,
        perspective: corners.perspective,
    };
    let [top, ..] = shape.sorted;
    let column = top.x().to_bits() >> SUBPX_BITS;
    scan(
        target,
        &shape,
        |row| Surface::new(&shape, &corners, row),
        |span, surface| surface.runs(span, column, shade),
        |span| sliver(span, &shape, &corners, shade),
    );
    seen.filled()
}

/// Hands on a span of a sliver, pixel by pixel.
#[cold]
#[inline(never)]
fn sliver<const A: usize, C>(
    span: Span<'_, C>,
    shape: &Shape<'_>,
    corners: &Corners<A>,
    shade: &impl Shade<A, C>,
) {
    let (places, area) = places(shape.sorted, shape.area);
    let depths = shape.sorted.map(|v| i64::from(v.z().to_bits()));
    let Span {
        indices,
        depths: stored,
        place: [left, row],
    } = span;
    let pixels = indices.chunks_mut(1).zip(stored.chunks_mut(1));
    for ((index, depth), column) in pixels.zip(left..) {
        let weights = weights(places, area, [column, row]);
        let z = mix(depths, weights);
        let weights = corners.in_space(weights);
        let mut from = [0; A];
        for (which, value) in from.iter_mut().enumerate().take(corners.kind.attributes) {
            let all = corners.attributes.each_ref();
            let all = all.map(|all| i64::from(all.get(which).copied().unwrap_or(0)));
            *value = mix(all, weights) as i32;
        }
        shade.run(Run {
            indices: index,
            depths: depth,
            place: [column, row],
            depth: (((z as u32) << 12).wrapping_add(1 << 15), 0),
            seen: 0,
            path: Path {
                from,
                step: [0; A],
                bend: [0; A],
            },
            footprint: Footprint::default(),
            footprint_step: Footprint::default(),
        });
    }
}
