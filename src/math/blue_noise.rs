//! Thresholds without a visible pattern: void and cluster (Ulichney, "The
//! void-and-cluster method for dither array generation", 1993).

/// Columns and rows of the pattern.
const SIDE: usize = 32;

/// Made by the tests' `void_and_cluster`; each threshold four times.
static PATTERN: [u8; SIDE * SIDE] = *include_bytes!("blue_noise.bin");

/// The threshold at a column and a row, 0..=255, of a pattern of 32 by 32 pixels. 1 KB
/// of flash where it is used.
#[inline]
pub fn blue_noise([column, row]: [i32; 2]) -> i32 {
    let place = (row & 31) << 5 | (column & 31);
    PATTERN.get(place as usize).copied().unwrap_or(0).into()
}

#[cfg(test)]
mod tests;
