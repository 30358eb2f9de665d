//! A beam: the rays of a camera's tile, which all start at the eye, on their way through
//! a mesh's hierarchy at once. A box is left out if it is outside of one of the tile's
//! four sides (Assarsson and Möller, "Optimized view frustum culling algorithms for
//! bounding boxes", 2000), so it is never left out if a ray of the tile meets it.

use super::actor::{GridPlace, RayActor};
use super::hierarchy::Hierarchy;
use crate::math::{mul_high, product};
use crate::scene::layout::RAY_STACK;
use crate::scene::{Child, Leaf};

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

/// See the module.
#[derive(Clone, Copy, Debug)]
pub(super) struct Beam {
    /// The eye.
    pub from: GridPlace,
    pub screen: Projection,
    /// The sides' normals, which point inward, 30 bits.
    sides: [[i32; 3]; 4],
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

impl Beam {
    /// The rays of a tile of so many pixels; `None` if they are too narrow or too wide
    /// for its numbers.
    #[inline(never)]
    pub(super) fn new(
        actor: &RayActor,
        from: GridPlace,
        rays: &TileRays,
        [width, height]: [u16; 2],
    ) -> Option<Self> {
        let ways = [rays.middle, rays.across, rays.down].map(|v| actor.direction(v));
        let screen = Projection::new(ways, rays.up)?;
        let Projection { x, y, z, up } = screen;
        let side = |v: [i32; 3], size: u16, sign: i64| {
            let mut normal = [0; 3];
            for ((n, v), z) in normal.iter_mut().zip(v).zip(z) {
                // In 2^-13 pixels, so that there are no fractions.
                *n = (i64::from(v) << (up + 12)) * sign + i64::from(z) * (i64::from(size) << 11);
            }
            narrowed(normal, 0).map(|(normal, _)| normal)
        };
        Some(Self {
            from,
            screen,
            sides: [
                side(x, width, 1)?,
                side(x, width, -1)?,
                side(y, height, 1)?,
                side(y, height, -1)?,
            ],
        })
    }

    /// Goes through a hierarchy; `false` if `leaf` said so, and then ended there.
    #[inline(always)]
    pub(super) fn walk(
        &self,
        tree: &Hierarchy<'_>,
        left: &mut [u32; RAY_STACK],
        mut leaf: impl FnMut(Leaf) -> bool,
    ) -> bool {
        let mut count = 0usize;
        let mut word = 0u32;
        loop {
            if word >> 31 == 0 {
                if let Some((met, children)) = self.boxes(tree, word) {
                    for (child, word) in children.into_iter().enumerate() {
                        // The parser made sure that there is room.
                        if met >> child & 1 != 0
                            && let Some(slot) = left.get_mut(count)
                        {
                            *slot = word;
                            count += 1;
                        }
                    }
                }
            } else if let Child::Leaf(found) = Child::from_word(word.to_le())
                && !leaf(found)
            {
                return false;
            }
            let Some(next) = count.checked_sub(1).and_then(|last| left.get(last)) else {
                return true;
            };
            count -= 1;
            word = *next;
        }
    }

    /// Which boxes of a node are not outside, a bit each, and what they are around.
    #[inline(always)]
    fn boxes(&self, tree: &Hierarchy<'_>, number: u32) -> Option<(u32, [u32; 4])> {
        let [o0, o1, o2, rest @ ..] = tree.node_words(number)?;
        let origin = [*o0, *o1, *o2].map(|word| u32::from_le(word) as i32);
        let [s0, s1, s2, s3, s4, s5, children @ ..] = rest;
        let sides = [[*s0, *s1], [*s2, *s3], [*s4, *s5]].map(|pair| pair.map(u32::from_le));
        let children = children.map(u32::from_le);
        let [_, c1, c2, c3] = children;
        let mut met = 1 | u32::from(c1 != 0) << 1 | u32::from(c2 != 0) << 2;
        met |= u32::from(c3 != 0) << 3;
        // A unit of the boxes in units of a place.
        let exponent = (origin[0] & 31) + self.from.fraction;
        let [x, y, z] = self.from.off(origin.map(|c| c >> 5));
        if exponent < 0 {
            // Too small to tell.
            return Some((met, children));
        }
        let exponent = exponent.min(22);
        for &[nx, ny, nz] in &self.sides {
            let inside = mul_high(nx, x) + mul_high(ny, y) + mul_high(nz, z);
            // All boxes together reach 2^24 of the units below.
            let reach = 1 << (exponent + 8);
            if inside >= reach {
                continue;
            }
            if inside < -reach - 4 {
                return None;
            }
            let short = |n: i32| (n >> 16) + ((n >> 15) & 1);
            let (nx, ny, nz) = (short(nx), short(ny), short(nz));
            let units = if exponent <= 16 {
                inside.wrapping_shl((16 - exponent) as u32)
            } else {
                inside >> (exponent - 16)
            };
            // What the normal's lost bits are on 255 units, and the products' roundings.
            let margin = 384 + (4 << 16 >> exponent);
            let units = units.wrapping_add(margin);
            // Of each axis the sides that are farther inside.
            let [[x_low, x_high], [y_low, y_high], [z_low, z_high]] = sides;
            let x = if nx >= 0 { x_high } else { x_low };
            let y = if ny >= 0 { y_high } else { y_low };
            let z = if nz >= 0 { z_high } else { z_low };
            for child in 0..4 {
                let byte = |all: u32| (all >> (8 * child) & 255) as i32;
                let far = nx * byte(x) + ny * byte(y) + nz * byte(z);
                if far.wrapping_add(units) < 0 {
                    met &= !(1 << child);
                }
            }
            if met == 0 {
                return None;
            }
        }
        Some((met, children))
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
fn bits(v: &[i64; 3]) -> u32 {
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
