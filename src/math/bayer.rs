//! Bayer's patterns of thresholds ("An optimum method for two-level rendition of
//! continuous-tone pictures", 1973).

/// The threshold at a column and a row, 0..=15, of a pattern of 4 by 4 pixels: the bits
/// of x ^ y and y from the lowest to the highest, in turn.
#[inline(always)]
pub fn bayer4([column, row]: [i32; 2]) -> i32 {
    let (a, b) = (column ^ row, row);
    (a & 1) << 3 | (b & 1) << 2 | (a & 2) | (b & 2) >> 1
}

/// The threshold at a column and a row, 0..=63, of a pattern of 8 by 8 pixels.
#[inline(always)]
pub fn bayer8([column, row]: [i32; 2]) -> i32 {
    let (a, b) = (column ^ row, row);
    bayer4([column, row]) << 2 | (a & 4) >> 1 | (b & 4) >> 2
}
