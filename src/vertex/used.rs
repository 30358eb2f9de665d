//! Which vertices of a meshlet are needed.

use crate::scene::layout::MESHLET_VERTICES;

/// The vertices of a meshlet that are to be transformed: a byte each, 1 or 0, which is asked
/// and set with fewer instructions than a bit.
#[derive(Clone, Copy, Debug)]
pub struct Used([u8; MESHLET_VERTICES]);

impl Used {
    /// All.
    pub const ALL: Self = Self([1; MESHLET_VERTICES]);
    /// None.
    pub const NONE: Self = Self([0; MESHLET_VERTICES]);

    /// The corners of some triangles too.
    #[inline(always)]
    pub fn add(&mut self, triangles: &[[u8; 3]]) {
        for index in triangles.as_flattened() {
            #[expect(clippy::indexing_slicing, reason = "held below the array's length")]
            {
                self.0[usize::from(*index) % MESHLET_VERTICES] = 1;
            }
        }
    }

    /// Each vertex's byte.
    #[inline(always)]
    pub(super) fn iter(&self) -> core::slice::Iter<'_, u8> {
        self.0.iter()
    }

    /// How many are needed of a meshlet with so many `vertices`.
    pub fn count(&self, vertices: u8) -> u8 {
        // By fours: no byte's sum is more than 64.
        let (fours, _) = self.0.as_chunks::<4>();
        let sums = fours
            .iter()
            .map(|four| u32::from_le_bytes(*four))
            .sum::<u32>();
        vertices.min((sums.wrapping_mul(0x0101_0101) >> 24) as u8)
    }
}
