//! A tile's rays, and where they see places.

use crate::math::product;

/// Directions that make up a tile, in the world, of any one scale each: the way to its
/// middle, and the changes from pixel to pixel, 31 bits; and how many bits the changes
/// are scaled up against the way.
#[derive(Clone, Copy, Debug)]
pub(super) struct TileRays {
    pub middle: [i32; 3],
    pub across: [i32; 3],
    pub down: [i32; 3],
    pub up: i32,
}

/// Where places are seen: one that is `v` off the eye is `x.v / z.v * 2^up` pixels to the
/// right of the tile's middle, and `y.v / z.v * 2^up` below.
#[derive(Clone, Copy, Debug)]
pub(super) struct Projection {
    /// 30 bits, `x` and `y` of one scale.
    pub x: [i32; 3],
    pub y: [i32; 3],
    pub z: [i32; 3],
    pub up: i32,
}

impl Projection {
    /// Of a tile whose rays are given as [`TileRays`] has them, in any space; `None` if they
    /// are too narrow or too wide for its numbers.
    #[inline(never)]
    pub(super) fn new([middle, across, down]: [[i32; 3]; 3], rays_up: i32) -> Option<Self> {
        // A place is a sum of the three: the parts are by Cramer's rule, whose divisor
        // is the same for all.
        let (z, z_up) = narrowed(cross(across, down), 0)?;
        let (x, y) = (cross(down, middle), cross(middle, across));
        let most = bits(&x).max(bits(&y));
        let (x, x_up) = narrowed(x, most)?;
        let (y, _) = narrowed(y, most)?;
        let up = x_up - z_up + rays_up;
        (-12..=16).contains(&up).then_some(Self { x, y, z, up })
    }
}

/// The cross product of two vectors of 29 bits.
fn cross([ax, ay, az]: [i32; 3], [bx, by, bz]: [i32; 3]) -> [i64; 3] {
    let area = |p: i32, q: i32, r: i32, s: i32| product(p, q) - product(r, s);
    [
        area(ay, bz, az, by),
        area(az, bx, ax, bz),
        area(ax, by, ay, bx),
    ]
}

/// Bits of a vector's largest component.
pub(super) fn bits(v: &[i64; 3]) -> u32 {
    64 - v
        .iter()
        .fold(1, |m, c| m | c.unsigned_abs())
        .leading_zeros()
}

/// A vector of which `of` bits (or if it is more, its own) become 30, and how many powers
/// of two it lost; `None` of nothing.
fn narrowed(v: [i64; 3], of: u32) -> Option<([i32; 3], i32)> {
    let down = bits(&v).max(of) as i32 - 29;
    if v == [0; 3] {
        return None;
    }
    let narrow = |c: i64| {
        if down >= 0 {
            (c >> down.min(63)) as i32
        } else {
            (c << down.wrapping_neg().min(63)) as i32
        }
    };
    Some((v.map(narrow), down))
}
