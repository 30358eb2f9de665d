//! Which pixels of a camera's tile a rectangle may cover: those that are on the inner side of
//! four planes through the eye and a side each. Nothing is projected, so it does not matter
//! where corners are, behind the eye or far beside the picture (Olano and Greer, "Triangle scan
//! conversion using 2D homogeneous coordinates", 1997).

use super::coverage::{Bits, TILE, all};
use super::ray::between;
use super::screen::TileRays;
use crate::math::{mul_high, product};

/// What a corner, and a place that is held against a side, may be off: raw world bits.
const OFF: i32 = 32;
/// Bits of a corner's place.
const PLACE_BITS: i32 = 29;
/// What products rounded down take, and a bit that is shifted out.
const ROUNDINGS: i32 = 8;

/// A plane through the eye and a side.
struct Side {
    /// Across it, [`PLACE_BITS`].
    normal: [i32; 3],
    /// What its components may be off.
    off: i32,
}

impl Side {
    /// Through two places, which are off by so much; `None` where it cannot be told.
    fn through(from: [i32; 3], to: [i32; 3], off: i32) -> Option<Self> {
        let ([ax, ay, az], [bx, by, bz]) = (from, to);
        let area = |p: i32, q: i32, r: i32, s: i32| product(p, q) - product(r, s);
        let wide = [
            area(ay, bz, az, by),
            area(az, bx, ax, bz),
            area(ax, by, ay, bx),
        ];
        let most = wide.iter().fold(0, |m, c| m | c.unsigned_abs());
        let down = (64 - PLACE_BITS as u32).checked_sub(most.leading_zeros())?;
        let size = |v: [i32; 3]| v.into_iter().fold(0, |m, c| m | c.unsigned_abs());
        let off = product(off, ((size(from) | size(to)) << 2) as i32) >> down;
        Some(Self {
            normal: wide.map(|c| (c >> down) as i32),
            off: i32::try_from(off).ok().filter(|off| *off < 1 << 24)? + 1,
        })
    }

    /// How far off it a direction goes.
    fn off(&self, direction: [i32; 3]) -> i32 {
        let parts = self.normal.into_iter().zip(direction);
        parts.map(|(n, d)| mul_high(n, d)).sum()
    }
}

/// Sets a rectangle's bit in all pixels of a tile that it may cover, and says whether there are
/// any; its corners are raw world bits, one after the other around it.
#[inline(never)]
pub(super) fn cover_rectangle(
    rays: &TileRays,
    eye: [i32; 3],
    corners: [[i32; 3]; 4],
    size: [u16; 2],
    bits: &mut Bits,
    bit: u32,
) -> bool {
    let Some(rows) = inside(rays, eye, corners, size) else {
        return all(bits, bit);
    };
    let mut any = false;
    for (pixels, row) in bits.chunks_exact_mut(TILE).zip(rows) {
        let mut left = row;
        for pixel in pixels {
            if left & 1 != 0 {
                *pixel |= bit;
            }
            left >>= 1;
        }
        any |= row != 0;
    }
    any
}

/// The pixels inside of all sides, a bit each, row by row; `None` if it cannot be told.
fn inside(
    rays: &TileRays,
    eye: [i32; 3],
    corners: [[i32; 3]; 4],
    [width, height]: [u16; 2],
) -> Option<[u8; TILE]> {
    // Changes from pixel to pixel are far smaller than directions, but not nothing.
    if !(3..=24).contains(&rays.up) {
        return None;
    }
    let offs = corners.map(|corner| between(corner, eye));
    let most = offs.as_flattened().iter();
    let most = most.fold(0, |m, c| m | c.unsigned_abs());
    let up = most.leading_zeros() as i32 - (32 - PLACE_BITS);
    // So near that what corners are off by would show, or as far as differences go.
    if up >= PLACE_BITS - 14 || most >= i32::MAX as u32 {
        return None;
    }
    // Those far away are shortened, which rounds.
    let scaled = |c: i32| if up < 0 { c >> -up } else { c << up };
    let [a, b, c, d] = offs.map(|off| off.map(scaled));
    let off = scaled(OFF) + 1;
    let far_side = Side::through(b, c, off)?;
    // On which side of its plane the eye is.
    let volume = far_side.off(a);
    if volume.unsigned_abs() <= far_side.off.max(off) as u32 + ROUNDINGS as u32 {
        return None;
    }
    let mut rows = [u8::MAX; TILE];
    let sides = [
        Side::through(a, b, off)?,
        far_side,
        Side::through(c, d, off)?,
        Side::through(d, a, off)?,
    ];
    for side in sides {
        // Halved, so that sums fit.
        let steps = [rays.across, rays.down].map(|step| side.off(step) >> (rays.up + 1));
        let turned = |c: i32| if volume < 0 { -c } else { c };
        let [across, down] = steps.map(turned);
        let [half_across, half_down] = [across, down].map(|step| step / 2);
        let margin = (half_across.abs() + half_down.abs()) / 2 + side.off + ROUNDINGS;
        let middle = (turned(side.off(rays.middle)) >> 1) + margin;
        let (x, y) = (i32::from(width) - 1, i32::from(height) - 1);
        let reach = x * half_across.abs() + y * half_down.abs() + x + y;
        if middle < -reach {
            return Some([0; TILE]);
        }
        if middle >= reach {
            continue;
        }
        let mut start = middle - x * half_across - y * half_down;
        for row in &mut rows {
            let mut now = start;
            for column in 0..TILE {
                if now < 0 {
                    *row &= !(1 << column);
                }
                now += across;
            }
            start += down;
        }
    }
    Some(rows)
}

#[cfg(test)]
mod tests {
    use super::*;

    const TILE_SIZE: [u16; 2] = [TILE as u16; 2];

    /// A tile that looks along `middle`, some 30 bits, a 128th of it wide.
    fn tile(middle: [i32; 3]) -> TileRays {
        TileRays {
            middle,
            across: [1 << 30, 0, 0],
            down: [0, -(1 << 30), 0],
            up: 10,
        }
    }

    /// A floor below the eye, `half` to each side and `low` below, turned a bit.
    fn floor(half: i32, low: i32) -> [[i32; 3]; 4] {
        let part = |c: i32, sixteenths: i32| (i64::from(c) * i64::from(sixteenths) / 16) as i32;
        let (long, short) = (part(half, 14), part(half, 3));
        [
            [-long, -low, -short],
            [short, -low, -long],
            [long, -low, short],
            [-short, -low, long],
        ]
    }

    #[test]
    fn the_sky_is_left_out_and_the_floor_is_not_at_any_distance() {
        let (sky, ground) = (
            tile([0, 1 << 28, -(1 << 30)]),
            tile([0, -(1 << 28), -(1 << 30)]),
        );
        for half in (22..31).map(|bits| 1 << bits) {
            let corners = floor(half, half / 8);
            let rows = |rays: &TileRays| inside(rays, [0; 3], corners, TILE_SIZE);
            assert_eq!(rows(&sky), Some([0; TILE]), "{half}");
            assert_eq!(rows(&ground), Some([u8::MAX; TILE]), "{half}");
        }
    }

    #[test]
    fn nothing_is_told_of_corners_as_far_as_differences_go() {
        let corners = floor(i32::MAX, i32::MAX / 8).map(|c| c.map(|c| c.saturating_mul(2)));
        assert_eq!(
            inside(&tile([0, 0, -(1 << 30)]), [0; 3], corners, TILE_SIZE),
            None
        );
    }
}
