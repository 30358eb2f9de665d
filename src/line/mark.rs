//! Marks: markers, points of a mesh and texts, as a few rows of bits.

use super::DepthRule;
use crate::frame::Target;
use crate::math::SUBPX_BITS;
use crate::vertex::ScreenVertex;

/// A picture of single bits and where it stands against its point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Mark<'a> {
    /// Pixels in a row.
    pub width: u16,
    /// Rows.
    pub height: u16,
    /// Its first column is in the pixel that is this many half pixels from the
    /// point, and its first row the same.
    pub offset: [i16; 2],
    /// Rows from the top, each starting with a byte's highest bit.
    pub bits: &'a [u8],
}

/// Bytes of a row.
pub(super) fn row_bytes(width: u16) -> usize {
    usize::from(width).div_ceil(8)
}

/// Draws a mark at a point, all of it at the point's depth; `index` gets a pixel's column
/// and row.
pub fn draw_mark<C>(
    target: &mut Target<'_, C>,
    point: &ScreenVertex,
    mark: &Mark<'_>,
    rule: &DepthRule,
    mut index: impl FnMut([i32; 2]) -> Option<C>,
) {
    const HALF_PIXEL_BITS: u32 = SUBPX_BITS - 1;
    let [ox, oy] = mark.offset.map(i32::from);
    let left = (point.x().to_bits() + (ox << HALF_PIXEL_BITS)) >> SUBPX_BITS;
    let top = (point.y().to_bits() + (oy << HALF_PIXEL_BITS)) >> SUBPX_BITS;
    let depth = rule.depth(point.z().to_bits() as i32, 4);
    let rows = mark.bits.chunks_exact(row_bytes(mark.width).max(1));
    for (y, row) in (top..top + i32::from(mark.height)).zip(rows) {
        if y < i32::from(target.top) {
            continue;
        }
        if y >= i32::from(target.end) {
            break;
        }
        for (x, byte) in (left..).step_by(8).zip(row) {
            let mut bits = *byte;
            while bits != 0 {
                let ahead = bits.leading_zeros();
                let place = [x + ahead as i32, y];
                rule.put(target, place, depth, || index(place));
                bits &= !(0x80 >> ahead);
            }
        }
    }
}
