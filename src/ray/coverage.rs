//! Which pixels of a tile a triangle may cover: a screen's edge functions, with a margin
//! for all that roundings take. What is exact follows for those pixels only.

use super::faces::Faces;
use super::screen::Projection;
use crate::math::{Rect, mul_high, reciprocal};

/// Columns and rows of a tile.
pub(super) const TILE: usize = 8;
/// Fractional bits of a pixel.
pub(super) const FINE: i32 = 5;
/// What a corner may be off: three products rounded down and one more, and once more
/// where it is halved.
const OFF: i32 = 2;
/// Bits of a corner's place, so that edge functions fit 30.
const PLACE_BITS: u32 = 13;

/// A pixel's triangles, a bit each, row by row.
pub(super) type Bits = [u32; TILE * TILE];

/// Sets a triangle's bit in all pixels that it may cover, in a tile that is `size` wide
/// and high; says whether there are any.
#[inline(never)]
pub(super) fn cover(
    screen: &Projection,
    corners: &[[i32; 3]; 3],
    faces: Faces,
    size: [u16; 2],
    bits: &mut Bits,
    bit: u32,
) -> bool {
    let [Some(a), Some(b), Some(c)] = corners.map(|corner| on_screen(screen, corner)) else {
        return all(bits, bit);
    };
    cover_places(&[a, b, c], faces, (size, 0), bits, bit)
}

/// The same of corners that are given in `2^-FINE` pixels from the tile's middle, off by 2
/// at most; of pixels that reach `around` their middles.
#[inline(always)]
pub(super) fn cover_places(
    &[a, b, c]: &[[i32; 2]; 3],
    faces: Faces,
    (size, around): ([u16; 2], i32),
    bits: &mut Bits,
    bit: u32,
) -> bool {
    let [width, height] = size.map(i32::from);
    let spread = |c: i32| (c ^ (c >> 31)) as u32;
    let most = a.into_iter().chain(b).chain(c);
    let most = most.fold(0, |m, c| m | spread(c));
    let down = (32 - PLACE_BITS).saturating_sub(most.leading_zeros());
    if down + 1 > FINE as u32 {
        return all(bits, bit);
    }
    let ([ax, ay], [mut bx, mut by], [mut cx, mut cy]) = (
        a.map(|c| c >> down),
        b.map(|c| c >> down),
        c.map(|c| c >> down),
    );
    let off = OFF + (around >> down);
    // Twice the area: below 0 of a face that is seen from its front.
    let area = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax);
    let slack = |dx: i32, dy: i32| off * (dx.abs() + dy.abs());
    let slacks = [
        slack(cx - bx, cy - by),
        slack(ax - cx, ay - cy),
        slack(bx - ax, by - ay),
    ];
    let [sa, sb, sc] = slacks;
    let unsure = 2 * (sa + sb + sc) + 64;
    if (area > unsure && !faces.back) || (area < -unsure && !faces.front) {
        return false;
    }
    let [sa, mut sb, mut sc] = slacks;
    if area < 0 {
        (bx, by, cx, cy) = (cx, cy, bx, by);
        (sb, sc) = (sc, sb);
    }
    // Pixels whose middles are in the box around it.
    let step = FINE - down as i32;
    let first = |low: i32, size: i32| {
        let start = (1 - size) << (step - 1);
        ((low - off - start + (1 << step) - 1) >> step).max(0)
    };
    let last = |high: i32, size: i32| {
        let start = (1 - size) << (step - 1);
        ((high + off - start) >> step).min(size - 1)
    };
    let (left, right) = (
        first(ax.min(bx).min(cx), width),
        last(ax.max(bx).max(cx), width),
    );
    let (top, bottom) = (
        first(ay.min(by).min(cy), height),
        last(ay.max(by).max(cy), height),
    );
    if left > right || top > bottom {
        return false;
    }
    let x = ((1 - width) << (step - 1)) + (left << step);
    let y = ((1 - height) << (step - 1)) + (top << step);
    // Not below 0 inside.
    let edge = |px: i32, py: i32, qx: i32, qy: i32, slack: i32| {
        let (dx, dy) = (qx - px, qy - py);
        (
            dx * (y - py) - dy * (x - px) + slack,
            -(dy << step),
            dx << step,
        )
    };
    let (mut u, u_across, u_down) = edge(bx, by, cx, cy, sa);
    let (mut v, v_across, v_down) = edge(cx, cy, ax, ay, sb);
    let (mut w, w_across, w_down) = edge(ax, ay, bx, by, sc);
    let mut any = false;
    let rows = bits.chunks_exact_mut(TILE).skip(top as usize);
    for row in rows.take((bottom - top + 1) as usize) {
        let (mut u_now, mut v_now, mut w_now) = (u, v, w);
        let pixels = row.iter_mut().skip(left as usize);
        for pixel in pixels.take((right - left + 1) as usize) {
            if u_now | v_now | w_now >= 0 {
                *pixel |= bit;
                any = true;
            }
            u_now += u_across;
            v_now += v_across;
            w_now += w_across;
        }
        u += u_down;
        v += v_down;
        w += w_down;
    }
    any
}

/// Sets a bit in all pixels of a tile that lie within bounds.
#[inline(never)]
pub(super) fn cover_bounds(bounds: &Rect, tile: &Rect, bits: &mut Bits, bit: u32) -> bool {
    let from = |low: u16, tile: u16| usize::from(low.saturating_sub(tile));
    let (left, top) = (from(bounds.left, tile.left), from(bounds.top, tile.top));
    let (right, bottom) = (
        from(bounds.right.min(tile.right), tile.left),
        from(bounds.bottom.min(tile.bottom), tile.top),
    );
    let rows = bits.chunks_exact_mut(TILE).take(bottom).skip(top);
    for row in rows {
        for pixel in row.iter_mut().take(right).skip(left) {
            *pixel |= bit;
        }
    }
    left < right && top < bottom
}

/// The first and the last of a tile's columns or rows, of which there are `size`, whose middles are
/// between two places, in `2^-FINE` pixels from the tile's middle; `None` if there is none.
#[inline(always)]
pub(super) fn pixels(low: i32, high: i32, size: i32) -> Option<[u32; 2]> {
    let start = (1 - size) << (FINE - 1);
    let first = (low.saturating_add((1 << FINE) - 1 - start) >> FINE).max(0);
    let last = (high.saturating_sub(start) >> FINE).min(size - 1);
    (first <= last).then_some([first as u32, last as u32])
}

/// Sets a bit in all pixels.
pub(super) fn all(bits: &mut Bits, bit: u32) -> bool {
    for pixel in bits {
        *pixel |= bit;
    }
    true
}

/// Where something that is `v` off the eye is seen, in `2^-FINE` pixels from the tile's
/// middle, off by 2 at most; `None` if it is not far enough ahead to tell.
#[inline(always)]
fn on_screen(beam: &Projection, [vx, vy, vz]: [i32; 3]) -> Option<[i32; 2]> {
    let along = |[x, y, z]: [i32; 3]| mul_high(x, vx) + mul_high(y, vy) + mul_high(z, vz);
    let z = along(beam.z);
    if z >> (beam.up.max(0) + 8) <= 0 {
        return None;
    }
    let recip = reciprocal(z as u32);
    // The reciprocal has 62 - shift fractional bits.
    let down = 30 - recip.shift as i32 - beam.up - FINE;
    Some([beam.x, beam.y].map(|axis| mul_high(along(axis), recip.mantissa) >> down.clamp(0, 31)))
}
