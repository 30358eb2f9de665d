//! From a place in a picture to the number of a texel.

use crate::raster::FINE;

/// Fractional bits of a place in a texture.
pub(super) const PLACE_BITS: i32 = 16;

/// `log2` of the texels of the largest picture whose places have [`FINE`] bits more in the kernel,
/// which long runs need: columns stand below the rows.
pub(super) const LARGEST: u8 = 32 - PLACE_BITS as u8 - FINE as u8;

/// From places in the picture to a number that has a texel's in its highest bits. Rows
/// wrap above, columns are cut out below them, so what repeats does so by itself.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Cut {
    /// What places are multiplied by: texels of the picture to 2^32 a picture.
    times: [u32; 2],
    /// A right shift of columns to below the rows.
    pub(super) rows: u32,
    /// The bits of the column and of what is below it.
    pub(super) columns: u32,
    /// A right shift to a texel's number.
    pub(super) down: u32,
}

impl Cut {
    /// For a copy of a picture, both with `log2` of their sizes.
    pub fn new([w, h]: [u32; 2], [width, height]: [u32; 2]) -> Self {
        let whole = 32 - PLACE_BITS as u32;
        // A shift by 32, for a copy of one texel, does not exist: its places are all 0.
        let some = u32::from(w + h != 0);
        Self {
            times: [width, height].map(|size| some << (whole - size)),
            rows: h,
            columns: u32::MAX >> h,
            down: (32 - w - h).min(31),
        }
    }

    /// From a place, or a change of one, to numbers that a texel's is made of.
    #[inline(always)]
    pub(super) fn both(&self, place: [i32; 2]) -> [u32; 2] {
        self.times(place, self.times)
    }

    /// The same of what has [`FINE`] fractional bits more, for which there is room in those numbers
    /// if pictures are no larger than [`LARGEST`].
    #[inline(always)]
    pub(super) fn both_fine(&self, place: [i32; 2]) -> [u32; 2] {
        self.times(place, self.times.map(|times| times >> FINE))
    }

    #[inline(always)]
    fn times(&self, [x, y]: [i32; 2], [across, along]: [u32; 2]) -> [u32; 2] {
        let x = (x as u32).wrapping_mul(across) >> (self.rows & 31);
        [x, (y as u32).wrapping_mul(along)]
    }

    /// The number of the texel at a place.
    #[inline(always)]
    pub(super) fn texel(&self, place: [i32; 2]) -> usize {
        let [x, y] = self.both(place);
        (((x ^ y) & self.columns ^ y) >> (self.down & 31)) as usize
    }
}
