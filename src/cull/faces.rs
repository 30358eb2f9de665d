//! Back faces, a few at a time, before their vertices are known.

use crate::math::short_square_root;
use crate::scene::{FaceCone, Meshlet};
use crate::view::{ActorView, EyeInGrid};

/// Bits that a distance is brought to: products with a cone's numbers have 20.
const BITS: i32 = 14;
/// What roundings take, in these products: the way from the eye is off by at most 3 in each
/// component, the eye's own rounding with it.
const MARGIN: i32 = 384;

/// A meshlet as the eye sees it.
#[derive(Clone, Copy, Debug)]
pub struct Sight {
    /// From the eye to its base.
    way: [i32; 3],
    /// How long that is.
    distance: i32,
    /// Of the meshlet's sphere, twice.
    radius_twice: i32,
}

impl Sight {
    /// Of a meshlet of an actor.
    #[inline(never)]
    pub fn new(view: &ActorView, meshlet: &Meshlet) -> Self {
        let (way, radius) = match view.eye {
            EyeInGrid::Point([ex, ey, ez]) => {
                let [bx, by, bz] = meshlet.base.map(i64::from);
                let radius = i64::from(meshlet.radius_steps());
                ([bx - ex, by - ey, bz - ez], radius)
            }
            EyeInGrid::Direction(direction) => (direction.map(i64::from), 0),
        };
        let largest = way.iter().fold(radius, |m: i64, c| m.max(c.abs()));
        let down = (64 - largest.leading_zeros() as i32 - BITS).max(0);
        let way = way.map(|c| (c >> down) as i32);
        let squared = way.iter().fold(0, |sum, c| sum + (c * c) as u32);
        Self {
            way,
            distance: short_square_root(squared) as i32 + 1,
            radius_twice: (radius >> down) as i32 * 2,
        }
    }

    /// Whether all triangles of a cone are seen from behind.
    #[inline(always)]
    pub fn is_behind(&self, cone: [u8; 3]) -> bool {
        let cone = FaceCone::from_bytes(cone);
        let ([x, y, z], [ax, ay, az]) = (self.way, cone.axis.map(i32::from));
        let (spread, offset) = (i32::from(cone.spread), i32::from(cone.offset));
        let along = x * ax + y * ay + z * az;
        along - spread * self.distance - offset * self.radius_twice >= MARGIN
    }
}
