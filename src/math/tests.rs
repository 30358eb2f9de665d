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

/// FEATURES of a graphics course, worked by hand.
mod worked_examples {
    use super::super::*;

    fn point(x: i16, y: i16, z: i16) -> Vec3 {
        Vec3::from_ints(x, y, z)
    }

    type Map = Transform<WorldSpace, WorldSpace>;

    #[test]
    fn moved_by_five_in_y_then_turned_a_quarter_about_x() {
        let up = Map::translation(point(0, 5, 0));
        let turn = Map::rotation(&Rotation::about_x(Angle::QUARTER));
        assert_eq!(up.then(&turn).apply(point(0, 0, 1)), point(0, -1, 5));
    }

    #[test]
    fn turned_a_quarter_about_an_axis_parallel_to_x() {
        let turn = Map::rotation_about_x_through(point(0, 3, 2), Angle::QUARTER);
        assert_eq!(turn.apply(point(0, 0, 1)), point(0, 4, -1));
    }

    #[test]
    fn a_viewing_frame_along_x() {
        // Origin at the view-site, z towards the viewpoint.
        let (site, viewpoint) = (point(0, 0, 1), point(-10, 0, 1));
        let rotation = Transform::<WorldSpace, View>::look_at(viewpoint, site, point(0, 0, 1));
        let to_eye = rotation.unwrap().apply(point(5, 0, 1));
        // The eye is 10 behind the view-site.
        assert_eq!(to_eye, point(0, 0, -15));
    }

    #[test]
    fn a_viewing_frame_along_the_diagonal() {
        let view =
            Transform::<WorldSpace, View>::look_at(point(5, 5, 5), Vec3::ZERO, point(0, 0, 1));
        let [x, y, z] = view.unwrap().apply(point(0, 0, 5)).to_bits().map(f64::from);
        let one = 65536.0;
        let from_site = z / one + 75f64.sqrt();
        assert!((x / one).abs() < 2.0 / one);
        assert!((y / one - 5.0 * 6f64.sqrt() / 3.0).abs() < 2.0 / one);
        assert!((from_site - 5.0 / 3f64.sqrt()).abs() < 2.0 / one);
    }

    #[test]
    fn an_orientation_is_three_turns_to_the_last_bit() {
        let angles = [0u32, 1, 0x1234_5678, 1 << 30, 0xcafe_babe, u32::MAX];
        for number in 0..angles.len().pow(3) {
            let angle = |i: u32| {
                let which = number / angles.len().pow(i) % angles.len();
                Angle::from_bits(angles[which])
            };
            let [x, y, z] = [0, 1, 2].map(angle);
            let turns = Rotation::about_y(y).then(&Rotation::about_x(x));
            let turns = turns.then(&Rotation::about_z(z));
            assert_eq!(Rotation::from_orientation([x, y, z]), turns);
        }
    }

    #[test]
    fn composition_is_application_in_turn() {
        let a = Map::rotation(&Rotation::about_z(Angle::from_turns16(7000)));
        let b = Map::translation(point(3, -2, 9));
        let c = Map::scale(
            World::from_num(3),
            World::from_num(-1) / 2,
            World::from_num(7),
        );
        let p = point(11, -4, 6);
        let at_once = a.then(&b).then(&c).apply(p).to_bits();
        let in_turn = c.apply(b.apply(a.apply(p))).to_bits();
        for (one, other) in at_once.iter().zip(in_turn) {
            // Three roundings of half a bit, the last two scaled by up to 7.
            assert!((one - other).abs() <= 8, "{one} {other}");
        }
    }
}

mod quotients {
    use super::super::quotient::floor_by_reciprocal;
    use super::super::recip::leading_zeros_by_parts;
    use super::super::wide::{
        mul_high_by_halves, mul_high_u, mul_high_u_by_halves, product_by_halves,
    };
    use super::super::*;
    use proptest::prelude::*;

    fn factor() -> impl Strategy<Value = i32> {
        prop_oneof![
            any::<i32>(),
            -3..3i32,
            Just(i32::MIN),
            Just(i32::MAX),
            Just(0xffff),
            Just(-0x10000)
        ]
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(20_000))]

        #[test]
        fn leading_zeros_are_the_same_by_parts(value in 1u32.., shift in 0u32..32) {
            let value = (value >> shift).max(1);
            prop_assert_eq!(leading_zeros_by_parts(value), value.leading_zeros());
        }

        #[test]
        fn high_halves_are_the_same_by_either_way(a in factor(), b in factor()) {
            prop_assert_eq!(mul_high_by_halves(a, b), mul_high(a, b));
            prop_assert_eq!(product_by_halves(a, b), product(a, b));
            let (a, b) = (a as u32, b as u32);
            prop_assert_eq!(mul_high_u_by_halves(a, b), mul_high_u(a, b));
        }

        /// Without counting zeros, numbers of any size are what they are with it.
        #[test]
        fn scaled_numbers_stay_normal(a in any::<u32>(), b in any::<u32>(), e in -40..40i32) {
            let (a, b) = (Scaled::new(a, e), Scaled::new(b, -3));
            for made in [a.times(b), a.plus(b), scaled_reciprocal(a)] {
                prop_assert_eq!(made, Scaled::new(made.mantissa(), made.exponent()));
            }
            let recip = reciprocal(a.mantissa());
            let expected = Scaled::new(
                recip.mantissa as u32,
                recip.shift as i32 - 62 - a.exponent(),
            );
            prop_assert_eq!(scaled_reciprocal(a), expected);
        }

        #[test]
        fn quotients_by_reciprocal_are_exact(n in factor(), d in 1i32..1 << 26, small in 1i32..5000) {
            for d in [d, small] {
                let n = n.max(-i32::MAX);
                let by_divide = Divider::new(d).floor(n);
                prop_assert_eq!(floor_by_reciprocal(n, d, reciprocal(d as u32)), by_divide);
                let (q, r) = by_divide;
                prop_assert_eq!(i64::from(q) * i64::from(d) + i64::from(r), i64::from(n));
                prop_assert!((0..d).contains(&r));
            }
        }

        #[test]
        fn wide_floor_and_ceiling_are_exact(n in -(1i64 << 50)..1 << 50, d in 1i32..) {
            let d = d.max((n.unsigned_abs() >> 30) as i32 + 1);
            let divider = Divider::new(d);
            let (q, r) = divider.floor_wide(n);
            prop_assert_eq!(i64::from(q) * i64::from(d) + i64::from(r), n);
            prop_assert!((0..d).contains(&r));
            let (q, r) = divider.ceil_wide(n);
            prop_assert_eq!(i64::from(q) * i64::from(d) - i64::from(r), n);
            prop_assert!((0..d).contains(&r));
        }
    }
}

#[test]
fn angles_and_their_tangents() {
    for bits in (1u32..1 << 30).step_by(99_991) {
        let angle = Angle::from_bits(bits);
        let exact = (f64::from(bits) / 2f64.powi(32) * TAU).tan();
        let tangent = f64::from(angle.tangent()) / 2f64.powi(24);
        if exact > 250.0 {
            continue;
        }
        // Half a step, and what the sine and the cosine are off.
        let most = 2f64.powi(-24) + 2f64.powi(-27) * (1.0 + exact * exact);
        assert!((tangent - exact).abs() < most, "{bits}: {tangent} {exact}");
        let again = Angle::of_tangent(angle.tangent()).to_bits();
        let off = f64::from(again.abs_diff(bits)) / 2f64.powi(32);
        assert!(off < 2f64.powi(-25), "{bits} {again}: {off:e}");
    }
}
