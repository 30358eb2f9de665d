//! One row of a matrix with its constant, applied to 16-bit places: exact until
//! the one rounding at the end.

use super::{FINE_ROW_FRACTION, ROW_FRACTION};

/// A row for cores that multiply and add 64 bits.
#[derive(Clone, Copy, Debug)]
#[cfg(any(not(narrow_multiply), test))]
pub(super) struct WideRow {
    entries: [i32; 3],
    constant: i64,
}

#[cfg(any(not(narrow_multiply), test))]
impl WideRow {
    pub(super) fn new(entries: [i32; 3], constant: i64, _fine: bool) -> Self {
        Self { entries, constant }
    }

    /// `(entries . place + constant) >> ROW_FRACTION`.
    #[inline(always)]
    pub(super) fn apply(&self, place: [i16; 3]) -> i32 {
        (self.sum(place.map(i32::from)) >> ROW_FRACTION) as i32
    }

    /// The same for a place of a fine mesh: 24 bits, and [`FINE_ROW_FRACTION`].
    pub(super) fn apply_fine(&self, place: [i32; 3]) -> i32 {
        (self.sum(place) >> FINE_ROW_FRACTION) as i32
    }

    #[inline(always)]
    fn sum(&self, [x, y, z]: [i32; 3]) -> i64 {
        let [a, b, c] = self.entries.map(i64::from);
        self.constant + a * i64::from(x) + b * i64::from(y) + c * i64::from(z)
    }
}

/// Bits of the low part of an entry: a product with 16 bits, twice, and a low
/// part of the constant stay within 31.
#[cfg(any(narrow_multiply, test))]
const LOW_BITS: u32 = 15;
/// Bits of a fine place below its 16 high ones.
#[cfg(any(narrow_multiply, test))]
const FINE_BITS: u32 = 8;

/// The low `bits` of `v`, and what is above them.
#[cfg(any(narrow_multiply, test))]
#[inline(always)]
fn split(v: i32, bits: u32) -> [i32; 2] {
    [v & ((1 << bits) - 1), v >> bits]
}

/// A row for cores that multiply 32 bits only: entries in two parts. The sum of
/// the high parts is within 31 bits because the whole sum, a clip coordinate, is
/// within 28 beyond its fraction.
#[derive(Clone, Copy, Debug)]
#[cfg(any(narrow_multiply, test))]
pub(super) struct SplitRow {
    high: [i32; 3],
    low: [i32; 3],
    /// The constant's lowest [`FINE_BITS`], 0 unless the mesh is fine, and the rest.
    constant_fine: i32,
    constant_low: i32,
    constant_high: i32,
}

#[cfg(any(narrow_multiply, test))]
impl SplitRow {
    /// Of a `fine` mesh or not.
    pub(super) fn new(entries: [i32; 3], constant: i64, fine: bool) -> Self {
        let below = if fine { FINE_BITS } else { 0 };
        let [low, high] = [0, 1].map(|part| entries.map(|e| split(e, LOW_BITS)[part]));
        let constant_fine = constant as i32 & ((1 << below) - 1);
        let constant = constant >> below;
        Self {
            high,
            low,
            constant_fine,
            constant_low: constant as i32 & ((1 << LOW_BITS) - 1),
            constant_high: (constant >> LOW_BITS) as i32,
        }
    }

    /// As [`WideRow::apply`], to the bit.
    #[inline(always)]
    pub(super) fn apply(&self, place: [i16; 3]) -> i32 {
        let [_, high] = self.sum(place.map(i32::from));
        high >> (ROW_FRACTION - LOW_BITS)
    }

    /// `entries . place + constant`: [`LOW_BITS`], and what is above them.
    #[inline(always)]
    fn sum(&self, [x, y, z]: [i32; 3]) -> [i32; 2] {
        let ([ha, hb, hc], [la, lb, lc]) = (self.high, self.low);
        // Twice 32767 * 32768 and 32767 more are below 2^31.
        let [first, first_carry] = split(la * x + lb * y + self.constant_low, LOW_BITS);
        let [low, carry] = split(lc * z + first, LOW_BITS);
        let high = (ha.wrapping_mul(x))
            .wrapping_add(hb.wrapping_mul(y))
            .wrapping_add(hc.wrapping_mul(z))
            .wrapping_add(self.constant_high)
            .wrapping_add(first_carry)
            .wrapping_add(carry);
        [low, high]
    }

    /// As [`WideRow::apply_fine`], to the bit.
    #[inline(always)]
    pub(super) fn apply_fine(&self, place: [i32; 3]) -> i32 {
        let [fine, coarse] = [0, 1].map(|part| place.map(|c| split(c, FINE_BITS)[part]));
        let [low, high] = self.sum(coarse);
        let ([ha, hb, hc], [la, lb, lc], [x, y, z]) = (self.high, self.low, fine);
        // Three times 32767 * 255, and 23 bits, are below 2^25.
        let fine_low = la * x + lb * y + lc * z + self.constant_fine + (low << FINE_BITS);
        let fine_high = ha * x + hb * y + hc * z + (fine_low >> LOW_BITS);
        // The whole is (high << FINE_BITS + fine_high) << LOW_BITS.
        const DOWN: u32 = FINE_ROW_FRACTION - LOW_BITS;
        (high << (FINE_BITS - DOWN)).wrapping_add(fine_high >> DOWN)
    }
}

#[cfg(narrow_multiply)]
pub(super) type Row = SplitRow;
#[cfg(not(narrow_multiply))]
pub(super) type Row = WideRow;

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(20_000))]

        /// Rows and places as they come: the sum has 28 bits beyond its fraction.
        #[test]
        fn split_rows_are_exact(
            entries in prop::array::uniform3(-(1i32 << 29)..1 << 29),
            constant in -(1i64 << 44)..1 << 44,
            place in any::<[i16; 3]>(),
        ) {
            let wide = WideRow::new(entries, constant, false).apply(place);
            let split = SplitRow::new(entries, constant, false);
            prop_assert_eq!(split.apply(place), wide);
        }

        /// The same of fine meshes, with places of 24 bits.
        #[test]
        fn split_rows_of_fine_meshes_are_exact(
            entries in prop::array::uniform3(-(1i32 << 29)..1 << 29),
            constant in -(1i64 << 50)..1 << 50,
            place in prop::array::uniform3(-(1i32 << 23)..1 << 23),
        ) {
            let wide = WideRow::new(entries, constant, true).apply_fine(place);
            let split = SplitRow::new(entries, constant, true);
            prop_assert_eq!(split.apply_fine(place), wide);
        }
    }
}
