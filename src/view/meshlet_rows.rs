//! Grid point to clip coordinates.

use super::{ActorView, ROW_FRACTION};
use crate::scene::Meshlet;

/// An actor's rows with a meshlet's base folded into the constants. The sum is
/// exact until its one rounding, so that a vertex comes out the same from every
/// meshlet that has it.
#[derive(Clone, Copy, Debug)]
pub struct MeshletRows {
    rows: [[i32; 3]; 3],
    constants: [i64; 3],
}

impl MeshletRows {
    /// For the vertices of `meshlet`.
    pub fn new(view: &ActorView, meshlet: &Meshlet) -> Self {
        let [x, y, z] = meshlet.base.map(i64::from);
        let mut constants = view.constants;
        for (constant, row) in constants.iter_mut().zip(view.rows) {
            let [a, b, c] = row.map(i64::from);
            *constant += a * x + b * y + c * z;
        }
        // Vertices of a fine mesh come in grid steps.
        let shifts = if view.mesh.fine.is_some() {
            [0; 3]
        } else {
            meshlet.shifts
        };
        let [sx, sy, sz] = shifts.map(u32::from);
        // A coefficient times a vertex's distance is within the mesh's reach,
        // whichever of the two has the power of two.
        let rows = view
            .rows
            .map(|[a, b, c]| [a.wrapping_shl(sx), b.wrapping_shl(sy), c.wrapping_shl(sz)]);
        Self { rows, constants }
    }

    /// Clip coordinates x, y and distance of a point near the base, in units of the
    /// meshlet's shifts, or in grid steps for a fine mesh.
    #[inline(always)]
    pub fn apply(&self, [x, y, z]: [i32; 3]) -> [i32; 3] {
        let (x, y, z) = (i64::from(x), i64::from(y), i64::from(z));
        let [rx, ry, rd] = self.rows;
        let [cx, cy, cd] = self.constants;
        let sum = |[a, b, c]: [i32; 3], constant: i64| {
            let sum = constant + i64::from(a) * x + i64::from(b) * y + i64::from(c) * z;
            (sum >> ROW_FRACTION) as i32
        };
        [sum(rx, cx), sum(ry, cy), sum(rd, cd)]
    }

    /// Clip coordinates of the meshlet's base.
    pub fn base(&self) -> [i32; 3] {
        self.apply([0; 3])
    }
}
