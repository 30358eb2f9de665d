//! What light is worked out with, against f64: roots, directions, powers, numbers of
//! any size.

use fixel::math::{Scaled, direction, power, reciprocal_root, root, scaled_reciprocal, unit};
use proptest::prelude::*;

#[test]
fn reciprocal_root_over_its_whole_range() {
    let mut worst: f64 = 0.0;
    let mut check = |value: u32| {
        let (mantissa, exponent) = reciprocal_root(value);
        let root = f64::from(mantissa) * 2f64.powi(-(exponent as i32));
        worst = worst.max((root * f64::from(value).sqrt() - 1.0).abs());
    };
    (1..1u64 << 32)
        .step_by(1009)
        .for_each(|value| check(value as u32));
    (1..10_000).for_each(&mut check);
    assert!(worst < 2f64.powi(-15), "2^{}", worst.log2());
}

#[test]
fn powers_over_bases_and_exponents() {
    let mut worst: f64 = 0.0;
    for exponent in [0, 1, 64, 256, 300, 512, 2560, 8192, 32768, 65535] {
        for base in (0..=1u32 << 28).step_by(100_003) {
            let exact = (f64::from(base) / 2f64.powi(28)).powf(f64::from(exponent) / 256.0);
            let found = f64::from(power(base, exponent)) / 2f64.powi(14);
            worst = worst.max((found - exact).abs());
        }
        assert_eq!(power(1 << 28, exponent), 1 << 14, "{exponent}");
    }
    assert!(worst < 2f64.powi(-9), "2^{}", worst.log2());
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(20_000))]

    #[test]
    fn directions_have_length_one(v in any::<[i32; 3]>(), down in 0..31u32) {
        let v = v.map(|c| c >> down);
        let length = v.map(|c| f64::from(c).powi(2)).iter().sum::<f64>().sqrt();
        let Some((unit, found)) = direction(v) else {
            prop_assert_eq!(v, [0; 3]);
            return Ok(());
        };
        for (c, u) in v.into_iter().zip(unit) {
            let off = f64::from(u) / 2f64.powi(14) - f64::from(c) / length;
            // Half a unit each of rounding to 15 bits, of the root and of the result.
            prop_assert!(off.abs() < 2f64.powi(-14) * 1.5, "{unit:?} of {v:?}");
        }
        let found = f64::from(found.mantissa()) * 2f64.powi(found.exponent());
        prop_assert!((found / length - 1.0).abs() < 2f64.powi(-13), "{found} of {length}");
    }

    #[test]
    fn unit_vectors_are_exact_to_28_bits(v in any::<[i32; 3]>(), down in 0..31u32) {
        let v = v.map(|c| c >> down);
        let length = v.map(|c| f64::from(c).powi(2)).iter().sum::<f64>().sqrt();
        let Some((unit, per_length)) = unit(v) else {
            prop_assert_eq!(v, [0; 3]);
            return Ok(());
        };
        for (c, u) in v.into_iter().zip(unit) {
            let off = f64::from(u) / 2f64.powi(30) - f64::from(c) / length;
            prop_assert!(off.abs() < 2f64.powi(-28), "{unit:?} of {v:?}: 2^{}", off.abs().log2());
        }
        let found = f64::from(per_length.mantissa()) * 2f64.powi(per_length.exponent());
        prop_assert!((found * length - 1.0).abs() < 2f64.powi(-26), "{found} of {length}");
    }

    #[test]
    fn square_roots_are_exact_to_26_bits(square in 0u64..1 << 62, down in 0..62u32) {
        let square = square >> down;
        let exact = (square as f64).sqrt();
        let off = f64::from(root(square)) - exact;
        // Rounded down, so that small ones are off by what they have no bits for.
        prop_assert!(off < 1e-9 + exact * 2f64.powi(-26), "root of {square} off by {off}");
        prop_assert!(off > -1.0 - exact * 2f64.powi(-26), "root of {square} off by {off}");
    }

    #[test]
    fn scaled_numbers_calculate(a in any::<u32>(), b in any::<u32>(), ea in -60..60i32, eb in -60..60i32) {
        let value = |s: Scaled| f64::from(s.mantissa()) * 2f64.powi(s.exponent());
        let (x, y) = (Scaled::new(a, ea), Scaled::new(b, eb));
        let (exact_x, exact_y) = (f64::from(a) * 2f64.powi(ea), f64::from(b) * 2f64.powi(eb));
        prop_assert_eq!(value(x).to_bits(), exact_x.to_bits());
        let near = |found: Scaled, exact: f64| (value(found) - exact).abs() <= exact * 2f64.powi(-29);
        prop_assert!(near(x.times(y), exact_x * exact_y));
        prop_assert!(near(x.plus(y), exact_x + exact_y), "{} {}", value(x.plus(y)), exact_x + exact_y);
        if a > 0 {
            let one_over = scaled_reciprocal(x);
            prop_assert!((value(one_over) * exact_x - 1.0).abs() < 2f64.powi(-27));
        }
        let fixed = (exact_x * 65536.0).floor().min(u32::MAX.into());
        prop_assert_eq!(x.fixed(16), fixed as u32);
    }
}
