extern crate std;

use super::*;
use std::f64::consts::TAU;

#[test]
fn sine_and_cosine_over_a_whole_turn() {
    let mut worst: f64 = 0.0;
    // A step that is no divisor of a turn: all table intervals, all offsets.
    let mut bits = 0u64;
    while bits < 1 << 32 {
        let angle = Angle::from_bits(bits as u32);
        let (sin, cos) = angle.sin_cos();
        let exact = bits as f64 / 2f64.powi(32) * TAU;
        let one = 2f64.powi(30);
        worst = worst.max((f64::from(sin) / one - exact.sin()).abs());
        worst = worst.max((f64::from(cos) / one - exact.cos()).abs());
        bits += 10_007;
    }
    assert!(
        worst < 2f64.powi(-28),
        "worst error {worst:e}, 2^{}",
        worst.log2()
    );
}

#[test]
fn reciprocal_over_its_whole_range() {
    let mut worst: f64 = 0.0;
    let mut check = |value: u32| {
        let Reciprocal { mantissa, shift } = reciprocal(value);
        let approximate = f64::from(mantissa) * 2f64.powi(shift as i32 - 62);
        worst = worst.max((approximate * f64::from(value) - 1.0).abs());
    };
    // Every seed with fine steps, every power of two with its neighbours.
    (0..1u64 << 31)
        .step_by(1009)
        .for_each(|i| check((1 << 31) + i as u32));
    for bit in 0..32 {
        let power = 1u32 << bit;
        check(power);
        check(power.saturating_sub(1).max(1));
        check(power.saturating_add(1));
    }
    check(u32::MAX);
    assert!(
        worst < 2f64.powi(-28),
        "worst error {worst:e}, 2^{}",
        worst.log2()
    );
}

#[test]
fn one_over_a_normals_length_for_every_squared_length() {
    let mut worst: f64 = 0.0;
    for squared in 5376..=16129 {
        let exact = 2f64.powi(22) / f64::from(squared).sqrt();
        worst = worst.max((f64::from(normal_length_recip(squared)) / exact - 1.0).abs());
    }
    assert!(
        worst < 2f64.powi(-12),
        "worst error {worst:e}, 2^{}",
        worst.log2()
    );
}

#[test]
fn normalise_is_exact_to_28_bits_at_any_scale() {
    for shift in [0, 10, 30, 31, 45, 60] {
        for v in [
            [1i64, 0, 0],
            [3, -4, 0],
            [1, 2, -2],
            [-1, -1, -1],
            [1, 1000, 7],
        ] {
            let v = v.map(|c| {
                if shift > 50 {
                    c.signum() << shift
                } else {
                    c << shift
                }
            });
            let length = v.iter().map(|c| (*c as f64).powi(2)).sum::<f64>().sqrt();
            let unit = normalise(v).unwrap();
            for (got, want) in unit.iter().zip(v) {
                let error = f64::from(*got) / 2f64.powi(30) - want as f64 / length;
                assert!(error.abs() < 2f64.powi(-28), "{v:?}: error {error:e}");
            }
        }
    }
    assert_eq!(normalise([0; 3]), None);
}
