//! Back-face culling of a whole meshlet by its cone of normals (the test of
//! Kapoulkine's meshoptimizer: a sphere that lies inside the cone's dual).

use crate::scene::Meshlet;
use crate::view::{ActorView, EyeInGrid};

/// Bits that a distance is brought to before it is squared.
const BITS: i32 = 24;

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
    let [x, y, z] = to_meshlet.map(|c| c >> down);
    let [ax, ay, az] = meshlet
        .cone_axis
        .map(|c| if front { -i64::from(c) } else { i64::from(c) });
    // Rounding down costs at most 1 in each of x, y, z and the margin.
    let margin = (margin >> down) + 4;
    let along = x * ax + y * ay + z * az - margin * 127;
    let distance = (x * x + y * y + z * z).unsigned_abs().isqrt() as i64 + 3;
    along >= i64::from(meshlet.cone_cutoff) * distance
}
