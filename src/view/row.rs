//! One row of a matrix with its constant, applied to 16-bit places: exact until
//! the one rounding at the end.

use super::{FINE_ROW_FRACTION, ROW_FRACTION};

/// A row for cores that multiply and add 64 bits.
#[derive(Clone, Copy, Debug)]
pub(super) struct WideRow {
    entries: [i32; 3],
    constant: i64,
}

impl WideRow {
    pub(super) fn new(entries: [i32; 3], constant: i64) -> Self {
        Self { entries, constant }
    }

    /// `(entries . place + constant) >> ROW_FRACTION`.
    #[cfg(any(not(narrow_multiply), test))]
    #[inline(always)]
    pub(super) fn apply(&self, place: [i16; 3]) -> i32 {
        (self.sum(place.map(i32::from)) >> ROW_FRACTION) as i32
    }

    /// The same for a place of a fine mesh: more than 16 bits, and
    /// [`FINE_ROW_FRACTION`].
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
#[cfg(any(narrow_multiply, test))]
const LOW: i32 = (1 << LOW_BITS) - 1;

/// A row for cores that multiply 32 bits only: entries in two parts. The sum of
/// the high parts is within 31 bits because the whole sum, a clip coordinate, is
/// within 28 beyond its fraction.
#[derive(Clone, Copy, Debug)]
#[cfg(any(narrow_multiply, test))]
pub(super) struct SplitRow {
    high: [i32; 3],
    low: [i32; 3],
    constant_high: i32,
    constant_low: i32,
    wide: WideRow,
}

#[cfg(any(narrow_multiply, test))]
impl SplitRow {
    pub(super) fn new(entries: [i32; 3], constant: i64) -> Self {
        Self {
            high: entries.map(|e| e >> LOW_BITS),
            low: entries.map(|e| e & LOW),
            constant_high: (constant >> LOW_BITS) as i32,
            constant_low: constant as i32 & LOW,
            wide: WideRow::new(entries, constant),
        }
    }

    /// As [`WideRow::apply`], to the bit.
    #[inline(always)]
    pub(super) fn apply(&self, place: [i16; 3]) -> i32 {
        let [x, y, z] = place.map(i32::from);
        let ([ha, hb, hc], [la, lb, lc]) = (self.high, self.low);
        // Twice 32767 * 32768 and 32767 more are below 2^31.
        let first = la * x + lb * y + self.constant_low;
        let second = lc * z + (first & LOW);
        let high = (ha.wrapping_mul(x))
            .wrapping_add(hb.wrapping_mul(y))
            .wrapping_add(hc.wrapping_mul(z))
            .wrapping_add(self.constant_high)
            .wrapping_add(first >> LOW_BITS)
            .wrapping_add(second >> LOW_BITS);
        high >> (ROW_FRACTION - LOW_BITS)
    }

    /// As [`WideRow::apply_fine`].
    pub(super) fn apply_fine(&self, place: [i32; 3]) -> i32 {
        self.wide.apply_fine(place)
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
            let wide = WideRow::new(entries, constant).apply(place);
            let split = SplitRow::new(entries, constant);
            prop_assert_eq!(split.apply(place), wide);
            let place = place.map(i32::from);
            let wide = WideRow::new(entries, constant).apply_fine(place);
            prop_assert_eq!(split.apply_fine(place), wide);
        }
    }
}
