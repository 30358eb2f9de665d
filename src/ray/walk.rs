//! A ray's way through a mesh's hierarchy of boxes.
//!
//! A box is met if neither of the sheared space's first two axes separates it from the
//! ray: a product each for the two sides that count, of a slope in 16 bits and a place
//! in 8. Nothing is divided, nothing overflows, and what roundings may take is added:
//! a box around something that is met is met.

use super::box_test::{BoxTest, SLOPE_BITS};
use super::candidates::Candidates;
use super::faces::Faces;
use super::grid_ray::{AXES, GridRay};
use super::hierarchy::{Hierarchy, Later, Left, Stack, depth_first};
use super::leaves::{Wanted, Way};
use super::triangle::TriangleHit;
use crate::math::mul_high;
use crate::scene::layout::RAY_STACK;
use crate::scene::{Child, Leaf};

impl Hierarchy<'_> {
    /// The nearest triangle that a ray meets within a range, in units of its third axis, of what
    /// is in some parts of the hierarchy. `left` is memory for what is left for later.
    #[inline(never)]
    pub(super) fn nearest(
        &self,
        ray: &GridRay,
        faces: Faces,
        range: (i32, i32),
        parts: Candidates<'_>,
        left: &mut Stack,
    ) -> Option<TriangleHit> {
        let way = Way::new(faces, range);
        match ray.axes {
            [.., 0] => self.along::<0>(ray, way, parts, left),
            [.., 1] => self.along::<1>(ray, way, parts, left),
            _ => self.along::<2>(ray, way, parts, left),
        }
    }

    /// Whether a ray meets any triangle.
    #[inline(never)]
    pub(super) fn any(&self, ray: &GridRay, range: (i32, i32), left: &mut Stack) -> bool {
        match ray.axes {
            [.., 0] => self.any_along::<0>(ray, range, left),
            [.., 1] => self.any_along::<1>(ray, range, left),
            _ => self.any_along::<2>(ray, range, left),
        }
    }

    /// The same of a ray whose third axis is known to the compiler.
    #[inline(always)]
    fn any_along<const THIRD: usize>(
        &self,
        ray: &GridRay,
        range: (i32, i32),
        left: &mut Stack,
    ) -> bool {
        let axes = AXES.get(THIRD).copied().unwrap_or(ray.axes);
        let ray = &GridRay { axes, ..*ray };
        self.count_up_to(ray, range, Wanted::Any, left) != 0
    }

    /// How many triangles a ray meets.
    #[inline(never)]
    pub(super) fn count(&self, ray: &GridRay, range: (i32, i32), left: &mut Stack) -> u32 {
        self.count_up_to(ray, range, Wanted::Count, left)
    }

    /// How many triangles a ray meets, or whether any: in no order.
    #[inline(always)]
    fn count_up_to(
        &self,
        ray: &GridRay,
        range: (i32, i32),
        wanted: Wanted,
        left: &mut Stack,
    ) -> u32 {
        let mut way = Way::new(Faces::BOTH, range);
        self.walk_window(ray, [0; 2], range, left, |leaf| {
            self.leaf(ray, leaf, wanted, &mut way);
            wanted != Wanted::Any || way.count == 0
        });
        way.count
    }

    /// The way of a ray whose third axis is known to the compiler, which then knows
    /// where everything is.
    #[inline(always)]
    fn along<const THIRD: usize>(
        &self,
        ray: &GridRay,
        way: Way,
        parts: Candidates<'_>,
        left: &mut Stack,
    ) -> Option<TriangleHit> {
        let axes = AXES.get(THIRD).copied().unwrap_or(ray.axes);
        self.walk(&GridRay { axes, ..*ray }, way, parts, left)
    }

    /// The way to the nearest triangle.
    #[inline(always)]
    fn walk(
        &self,
        ray: &GridRay,
        mut way: Way,
        parts: Candidates<'_>,
        left: &mut Stack,
    ) -> Option<TriangleHit> {
        for part in parts {
            let (mut count, mut word) = (0, part);
            loop {
                if word >> 31 == 0 {
                    let first = count;
                    self.node((ray, [0; 2]), word, way.range, |word, ahead| {
                        count = leave(left, first, count, Left { word, ahead });
                    });
                } else if let Child::Leaf(leaf) = Child::from_word(word.to_le()) {
                    self.leaf(ray, leaf, Wanted::Nearest, &mut way);
                }
                // What comes after the nearest triangle so far is not looked at.
                let farthest = way.range.1;
                let Some(next) = next_of(left, &mut count, farthest) else {
                    break;
                };
                word = next;
            }
        }
        way.nearest
    }

    /// Goes through all leaves that parallel rays may meet, which are up to `thick` to the
    /// sides of this one along both axes, within a range along them; `false` if `leaf` said
    /// so, and then ended there. `left` is for what is left for later.
    #[inline(always)]
    pub(super) fn walk_window(
        &self,
        ray: &GridRay,
        thick: [i32; 2],
        range: (i32, i32),
        left: &mut Stack,
        leaf: impl FnMut(Leaf) -> bool,
    ) -> bool {
        let node = |word, later: &mut Later<'_>| {
            self.node((ray, thick), word, range, |word, _| later.leave(word));
        };
        depth_first(left, node, leaf)
    }

    /// Hands on the boxes of a node that a ray meets, or one that is up to `thick` to its
    /// sides: their words, and how far ahead they are.
    #[inline(always)]
    fn node(
        &self,
        (ray, thick): (&GridRay, [i32; 2]),
        number: u32,
        (nearest, farthest): (i32, i32),
        mut met: impl FnMut(u32, i32),
    ) {
        let Some(words) = self.nodes.get(number as usize) else {
            return;
        };
        let [o0, o1, o2, rest @ ..] = words;
        let origin = [*o0, *o1, *o2].map(|word| u32::from_le(word) as i32);
        let exponent = (origin[0] & 31) + ray.from.fraction;
        let [nx, ny, nz] = ray.in_order(ray.off(origin.map(|c| c >> 5)));
        let [sx, sy] = ray.slopes;
        let x = (nx >> 1).wrapping_sub(mul_high(sx, nz));
        let y = (ny >> 1).wrapping_sub(mul_high(sy, nz));
        let Some((sides, children)) = rest.split_first_chunk::<6>() else {
            return;
        };
        // Of all four boxes, the lower and the upper sides along an axis.
        let [s0, s1, s2, s3, s4, s5]: &[[u8; 4]; 6] = bytemuck::cast_ref(sides);
        let sides = [[s0, s1], [s2, s3], [s4, s5]];
        let [[x_low, x_high], [y_low, y_high], [z_low, z_high]] = ray.in_order(sides);

        // A node is 255 units wide at most, and as wide again by its depth times a slope
        // of 1: farther off than 512 units it is missed.
        let small = exponent < 1;
        let exponent = exponent.clamp(1, 23);
        let reach = 1i32 << (exponent + 8).min(30);
        let missed = |c: i32, thick: i32| {
            let reach = reach + thick;
            (c.wrapping_add(reach) as u32) > 2 * reach as u32
        };
        let [thick_x, thick_y] = thick;
        if small {
            // Too small to tell: all of it.
            let some = children.iter().take_while(|word| **word != 0);
            some.for_each(|word| met(u32::from_le(*word), i32::MIN));
            return;
        }
        if missed(x, thick_x) || missed(y, thick_y) {
            return;
        }
        let down = exponent - 1 - SLOPE_BITS as i32;
        let in_units = |c: i32| {
            if down >= 0 {
                c >> down
            } else {
                c.wrapping_shl(down.unsigned_abs())
            }
        };
        // What the slopes' lost bits are on 255 units, and three roundings of a place.
        let margin = 258 + (3 << (SLOPE_BITS + 1) >> exponent);
        let beside = |c: i32, thick: i32| {
            if thick > reach {
                // All boxes of a node that is small beside a window.
                (0, 1 << (SLOPE_BITS + 9))
            } else {
                (in_units(c), margin + in_units(thick))
            }
        };
        let (x, margin_x) = beside(x, thick_x);
        let (y, margin_y) = beside(y, thick_y);
        let short = |slope: i32| (slope >> 16) + ((slope >> 15) & 1);
        let (sx, sy) = (short(sx), short(sy));
        let steps = |ahead: i32| {
            let z = ray.ahead(ahead).wrapping_sub(nz);
            z >> exponent
        };
        // The range on the third axis.
        let (from, to) = if ray.up {
            (
                steps(nearest),
                if farthest == i32::MAX {
                    256
                } else {
                    steps(farthest)
                },
            )
        } else {
            (
                if farthest == i32::MAX {
                    -1
                } else {
                    steps(farthest)
                },
                steps(nearest),
            )
        };
        let (from, to) = (from - 1, to + 1);
        let test = BoxTest {
            x: [x_low, x_high],
            y: [y_low, y_high],
            z: [z_low, z_high],
            twice: [x << 1, y << 1],
            slopes: [sx, sy],
            steep: [sx.abs(), sy.abs()],
            margins: [margin_x << 1, margin_y << 1],
            range: (from, to),
        };
        // How far ahead a box is: its side that is met first.
        let (unit, base) = if ray.up {
            (1 << exponent, nz)
        } else {
            (-1 << exponent, nz.wrapping_neg())
        };
        for (child, word) in children.iter().enumerate() {
            let word = u32::from_le(*word);
            if word == 0 {
                break;
            }
            let Some((low, high)) = test.meets(child) else {
                continue;
            };
            let side = if ray.up { low } else { high };
            met(word, base.wrapping_add(side.wrapping_mul(unit)));
        }
    }
}

/// Takes back what was left last, if it is not beyond `farthest`.
#[inline(always)]
fn next_of(left: &Stack, count: &mut usize, farthest: i32) -> Option<u32> {
    loop {
        let next = left.get(count.checked_sub(1)?)?;
        *count -= 1;
        if next.ahead <= farthest {
            return Some(next.word);
        }
    }
}

/// Adds what is left for later to what a node has left since `first`, the nearest last.
#[inline(always)]
fn leave(left: &mut Stack, first: usize, count: usize, new: Left) -> usize {
    // The parser made sure that there is room.
    let mut at = count.min(RAY_STACK - 1);
    let end = at + 1;
    while at > first {
        let Some(before) = left.get(at - 1).copied() else {
            break;
        };
        if before.ahead >= new.ahead {
            break;
        }
        if let Some(slot) = left.get_mut(at) {
            *slot = before;
        }
        at -= 1;
    }
    if let Some(slot) = left.get_mut(at) {
        *slot = new;
    }
    end
}
