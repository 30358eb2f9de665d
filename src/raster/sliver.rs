//! Triangles whose attributes change by more than the format's range a pixel
//! (thinner than two pixels, however long), and steep ones that reach an end of
//! the range of depths. Each pixel is worked out by itself, by
//! barycentric weights from exact edge functions (Pineda, "A parallel algorithm
//! for polygon rasterization", 1988), and held within the vertices' range.

use super::gradient::{Place, UNROUNDED_BITS, places};
use super::scan::{Shape, Span};
use super::span::Fill;
use crate::math::{Depth, keep_rolled};

/// Fractional bits of a weight.
pub(super) const WEIGHT_BITS: u32 = 20;

/// Fills a span.
#[cold]
#[inline(never)]
pub(super) fn span(span: Span<'_>, shape: &Shape<'_>, fill: Fill<'_>) {
    let depth_values = shape.sorted.map(|v| i64::from(v.z().to_bits()));
    let levels = shape.sorted.map(|v| i64::from(v.level().to_bits()));
    nearer(span, shape, |pixel, weights, fine_depth| {
        *pixel = match fill {
            Fill::Depth => return,
            Fill::Flat(index) => index,
            Fill::Gouraud(shades) => {
                let weights = if shape.perspective {
                    in_space(depth_values, weights, fine_depth)
                } else {
                    weights
                };
                let level = (mix(levels, weights) + (1 << 5)) >> 6;
                shades.get(level as usize).copied().unwrap_or(0)
            }
        };
    });
}

/// Fills a span's depths alone.
#[cold]
#[inline(never)]
pub(super) fn depth<C>(span: Span<'_, C>, shape: &Shape<'_>) {
    nearer(span, shape, |_, _, _| {});
}

/// Hands on the pixels that are nearer than what stands there, with their weights and fine
/// depths, after their depths are written.
#[inline(always)]
fn nearer<C>(span: Span<'_, C>, shape: &Shape<'_>, mut draw: impl FnMut(&mut C, [i64; 2], i64)) {
    let Span {
        indices,
        depths,
        place: [column, row],
    } = span;
    let (places, area) = places(shape.sorted, shape.area);
    let depth_values = shape.sorted.map(|v| i64::from(v.z().to_bits()));
    for ((pixel, depth), column) in indices.iter_mut().zip(depths).zip(column..) {
        let weights = weights(places, area, [column, row]);
        let fine_depth = mix(depth_values, weights);
        let here = (fine_depth + (1 << 3)) >> 4;
        if here <= i64::from(*depth) {
            continue;
        }
        *depth = here as Depth;
        draw(pixel, weights, fine_depth);
    }
}

/// Weights of the second and the third vertex at a pixel's centre.
#[inline(never)]
pub(super) fn weights([a, b, c]: [Place; 3], area: i64, pixel: [i32; 2]) -> [i64; 2] {
    const HALF: i64 = 1 << (UNROUNDED_BITS - 1);
    let [px, py] = pixel.map(|p| (i64::from(p) << UNROUNDED_BITS) + HALF);
    let edge = |p: Place, q: Place| {
        let ([ax, ay], [bx, by]) = (p.map(i64::from), q.map(i64::from));
        (bx - ax) * (py - ay) - (px - ax) * (by - ay)
    };
    // An edge's value is at most the area, or, of a pixel that only rounding put
    // inside, 33 bits. With the weight's fraction it has to fit 60: the rest is
    // dropped on both sides of the quotient.
    let down = (64 - area.unsigned_abs().leading_zeros()).saturating_sub(40);
    let part = |e: i64| {
        let quotient = ((e >> down) << WEIGHT_BITS)
            .checked_div(area >> down)
            .unwrap_or(0);
        // Beyond an edge where only rounding put the pixel inside: the mean is
        // held within the vertices' range.
        quotient.clamp(-1 << WEIGHT_BITS, 2 << WEIGHT_BITS)
    };
    let mut weights = [0; 2];
    for (weight, (p, q)) in weights.iter_mut().zip([(c, a), (a, b)]) {
        *weight = part(edge(p, q));
        keep_rolled();
    }
    weights
}

/// Weights in space from those on the screen: each times the vertex's depth, over
/// the depth here.
#[inline(never)]
fn in_space([_, b, c]: [i64; 3], [wb, wc]: [i64; 2], here: i64) -> [i64; 2] {
    let mut weights = [wb * b, wc * c];
    for weight in &mut weights {
        let in_space = weight.checked_div(here).unwrap_or(0);
        *weight = in_space.clamp(-1 << WEIGHT_BITS, 2 << WEIGHT_BITS);
        keep_rolled();
    }
    weights
}

/// The weighted mean, held within the three values.
#[inline(never)]
pub(super) fn mix([a, b, c]: [i64; 3], [wb, wc]: [i64; 2]) -> i64 {
    let mean = a + (((b - a) * wb + (c - a) * wc) >> WEIGHT_BITS);
    mean.max(a.min(b).min(c)).min(a.max(b).max(c))
}
