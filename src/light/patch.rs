//! The places of one meshlet in 16 bits.

use crate::scene::{Mesh, Meshlet};

/// Places of a meshlet are held in `2^shift` grid steps from its base: 15 bits and a
/// sign.
#[derive(Clone, Copy, Debug)]
pub struct Patch {
    /// The meshlet's base in grid steps.
    pub base: [i32; 3],
    /// Grid steps of one unit, as a power of two.
    pub shift: u32,
    /// Those of its vertices, which may be finer on some axes.
    shifts: [u8; 3],
    fine: bool,
}

impl Patch {
    /// For the vertices of `meshlet`.
    pub fn new(meshlet: &Meshlet, mesh: &Mesh) -> Self {
        Self {
            base: meshlet.base,
            shift: meshlet.shifts.iter().fold(0, |m, s| m.max(u32::from(*s))),
            shifts: meshlet.shifts,
            fine: mesh.fine.is_some(),
        }
    }

    /// A vertex, given as the meshlet has it, in units of this patch; `low` are a
    /// fine vertex's low bits.
    pub fn place(&self, vertex: [i16; 3], low: [u8; 3]) -> [i32; 3] {
        let mut place = vertex.map(i32::from);
        for ((c, shift), low) in place.iter_mut().zip(self.shifts).zip(low) {
            let low = if self.fine { i32::from(low) } else { 0 };
            *c = ((*c << shift.min(15)) + low) >> self.shift.min(31);
        }
        place
    }
}
