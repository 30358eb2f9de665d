//! Square roots in little code: `core`'s take six times as much, with tables.

/// The square root, rounded down: that of the upper half, and as many bits again by one
/// division (Zimmermann, "Karatsuba Square Root", 1999).
#[inline(never)]
pub(crate) fn square_root(of: u64) -> u32 {
    // By an even number of places, so that one of the two highest bits is set.
    let up = of.leading_zeros() & !1;
    let raised = of.wrapping_shl(up);
    let upper = (raised >> 32) as u32;
    let next = raised as u32 >> 16;
    let root = short_square_root(upper);
    // At most twice the root: 17 bits.
    let rest = upper.wrapping_sub(root.wrapping_mul(root));
    // `(rest * 2^16 + next) / (2 * root)`, both halved. 0 only for 0.
    let halved = rest << 15 | next >> 1;
    let quotient = halved.checked_div(root).unwrap_or(0);
    let left = halved.wrapping_sub(quotient.wrapping_mul(root)) << 1 | next & 1;
    let below = u64::from(left) << 16 | raised & 0xffff;
    // At most 2^16.
    let squared = u64::from(quotient) * u64::from(quotient);
    let found = (u64::from(root) << 16) + u64::from(quotient);
    ((found - u64::from(below < squared)) >> (up / 2)) as u32
}

/// [`square_root`] in 32 bits: by bits on cores without a divide, else by Newton's method.
#[inline(never)]
pub(crate) fn short_square_root(of: u32) -> u32 {
    if cfg!(narrow_multiply) {
        by_bits(of)
    } else {
        by_quotients(of)
    }
}

/// A bit at a time (Woo's abacus algorithm; see Warren, "Hacker's Delight", section 11-1).
#[inline(always)]
fn by_bits(of: u32) -> u32 {
    let (mut rest, mut root) = (of, 0);
    // The highest power of 4 in it.
    let mut bit: u32 = 1 << 30;
    bit = bit.wrapping_shr(of.leading_zeros() & !1);
    while bit != 0 {
        let with = root + bit;
        root >>= 1;
        if rest >= with {
            rest -= with;
            root += bit;
        }
        bit >>= 2;
    }
    root
}

/// Newton's method from a power of two that is not below the root, from where it falls.
#[inline(always)]
fn by_quotients(of: u32) -> u32 {
    let mut root = 1 << ((33 - of.leading_zeros()) / 2);
    loop {
        // 0 only for 0.
        let quotient = of.checked_div(root).unwrap_or(0);
        let next = (root + quotient) >> 1;
        if next >= root {
            return root;
        }
        root = next;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn ends_and_squares() {
        for of in [0, 1, 2, 3, 4, u32::MAX.into(), u64::MAX, u64::MAX - 1] {
            assert_eq!(u64::from(square_root(of)), of.isqrt(), "{of}");
            let of = of as u32;
            assert_eq!([by_bits(of), by_quotients(of)], [of.isqrt(); 2], "{of}");
        }
        for of in 0..70_000u32 {
            assert_eq!(by_bits(of), of.isqrt(), "{of}");
            assert_eq!(by_quotients(of), of.isqrt(), "{of}");
        }
        for root in [1u64, 2, 255, 65_535, 65_536, 0xffff_ffff] {
            for of in [root * root - 1, root * root] {
                assert_eq!(u64::from(square_root(of)), of.isqrt(), "{of}");
            }
        }
    }

    proptest! {
        #[test]
        fn as_the_language_has_them(of in any::<u64>(), down in 0u32..64) {
            let of = of >> down;
            prop_assert_eq!(u64::from(square_root(of)), of.isqrt());
            let of = of as u32;
            prop_assert_eq!(by_bits(of), of.isqrt());
            prop_assert_eq!(by_quotients(of), of.isqrt());
        }
    }
}
