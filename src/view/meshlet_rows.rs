//! Grid point to clip coordinates.

use super::ActorView;
use super::row::Row;
use crate::math::product;
use crate::scene::Meshlet;

/// An actor's rows with a meshlet's base folded into the constants. The sum is
/// exact until its one rounding, so that a vertex comes out the same from every
/// meshlet that has it.
#[derive(Clone, Copy, Debug)]
pub struct MeshletRows {
    rows: [Row; 3],
    fine: bool,
}

impl MeshletRows {
    /// For the vertices of `meshlet`.
    #[inline(never)] // once a meshlet, in two places
    pub fn new(view: &ActorView, meshlet: &Meshlet) -> Self {
        // Vertices of a fine mesh come in grid steps.
        let fine = view.mesh.fine.is_some();
        let shifts = if fine { [0; 3] } else { meshlet.shifts };
        let [sx, sy, sz] = shifts.map(u32::from);
        let [x, y, z] = meshlet.base;
        let ([rx, ry, rd], [cx, cy, cd]) = (view.rows, view.constants);
        let row = |[a, b, c]: [i32; 3], constant: i64| {
            let base = product(a, x) + product(b, y) + product(c, z);
            // An entry times a vertex's distance is within the mesh's reach,
            // whichever of the two has the power of two.
            let entries = [a.wrapping_shl(sx), b.wrapping_shl(sy), c.wrapping_shl(sz)];
            Row::new(entries, constant + base, fine)
        };
        Self {
            rows: [row(rx, cx), row(ry, cy), row(rd, cd)],
            fine,
        }
    }

    /// Clip coordinates x, y and distance of a vertex, in units of the meshlet's
    /// shifts from its base.
    #[inline(always)]
    pub fn apply(&self, place: [i16; 3]) -> [i32; 3] {
        let [x, y, distance] = &self.rows;
        [x.apply(place), y.apply(place), distance.apply(place)]
    }

    /// The same for a vertex of a fine mesh, in grid steps from the base.
    pub fn apply_fine(&self, place: [i32; 3]) -> [i32; 3] {
        let [x, y, distance] = &self.rows;
        [
            x.apply_fine(place),
            y.apply_fine(place),
            distance.apply_fine(place),
        ]
    }

    /// Clip coordinates of the meshlet's base.
    pub fn base(&self) -> [i32; 3] {
        if self.fine {
            self.apply_fine([0; 3])
        } else {
            self.apply([0; 3])
        }
    }
}
