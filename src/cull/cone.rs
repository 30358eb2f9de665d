//! Back-face culling of a whole meshlet by its cone of normals (the test of
//! Kapoulkine's meshoptimizer: a sphere that lies inside the cone's dual).

use crate::scene::Meshlet;
use crate::view::{ActorView, EyeInGrid};

/// Bits that a distance is brought to before it is squared.
const BITS: i32 = 20;

/// Whether every face of the meshlet is seen from behind (`front`: from the
/// front).
pub(super) fn faces_away(view: &ActorView, meshlet: &Meshlet, front: bool) -> bool {
    if meshlet.cone_cutoff == 127 {
        return false;
    }
    // From the eye to the meshlet, and how far it may be off: the meshlet's
    // size and the eye's rounding.
    let (to_meshlet, margin) = match view.eye {
        EyeInGrid::Point([ex, ey, ez]) => {
            let [bx, by, bz] = meshlet.base.map(i64::from);
            let largest = ex.abs().max(ey.abs()).max(ez.abs());
            (
                [bx - ex, by - ey, bz - ez],
                i64::from(meshlet.radius_steps()) + (largest >> 13),
            )
        }
        EyeInGrid::Direction(direction) => (direction.map(i64::from), 0),
    };
    let largest = to_meshlet.iter().fold(0, |m: i64, c| m.max(c.abs()));
    let down = (64 - largest.leading_zeros() as i32 - BITS).max(0);
    let [x, y, z] = to_meshlet.map(|c| (c >> down) as i32);
    let [ax, ay, az] = meshlet.cone_axis.map(i32::from);
    let along = x * ax + y * ay + z * az;
    let along = if front { along.wrapping_neg() } else { along };
    // Rounding down costs at most 1 in each of x, y, z and the margin.
    let margin = (margin >> down).min(2 << BITS) as i32 + 4;
    let along = along - margin * 127;
    // `along >= cutoff * (distance + 3)`, squared; a distance is at most this sum.
    let sum = x.abs() + y.abs() + z.abs();
    let squared = |v: i32| i64::from(v) * i64::from(v);
    let distance = squared(x) + squared(y) + squared(z) + i64::from(6 * sum + 9);
    let cutoff = i32::from(meshlet.cone_cutoff);
    along > 0 && squared(along) >= i64::from(cutoff * cutoff) * distance
}
