use fixel::line::{DepthRule, Line};
use fixel::raster::Fill;
use proptest::prelude::*;

use super::{TESTED, at, draw, line, raw};

#[test]
fn nearer_stays_and_a_bias_lifts() {
    let (a, b) = (at((0.5, 0.5)), at((3.5, 0.5)));
    let (c, d) = (
        raw(0, 2048, 32766 << 4, 0),
        raw(4 << 12, 2048, 32766 << 4, 0),
    );
    let lines = [line(&a, &b), line(&c, &d)];
    let both = |rule: &DepthRule| {
        let (mut index, mut depth) = ([0; 4], [0; 4]);
        let mut band = fixel::Band::new(4, &mut index, &mut depth).expect("a band");
        let mut target = band.target(0, 1);
        target.clear(|_| 0);
        for (line, fill, rule) in [(&lines[0], 1, &TESTED), (&lines[1], 2, rule)] {
            fixel::line::draw_line(&mut target, line, rule, Fill::Flat(fill));
        }
        (index, depth)
    };
    assert_eq!(both(&TESTED), ([1; 4], [32768; 4]));
    let bias = |bias| DepthRule { test: true, bias };
    // Equal is not nearer.
    assert_eq!(both(&bias(2)).0, [1; 4]);
    assert_eq!(both(&bias(3)), ([2; 4], [32769; 4]));
    let over = DepthRule {
        test: false,
        bias: 0,
    };
    assert_eq!(both(&over), ([2; 4], [32766; 4]));
}

#[test]
fn a_bias_never_leaves_the_range() {
    let (a, b) = (raw(2048, 2048, 65535 << 4, 0), raw(3 << 12, 2048, 9, 0));
    let rule = DepthRule {
        test: true,
        bias: 1000,
    };
    let (depth, _) = draw(&[line(&a, &b)], &rule, (3, 1), 1, Fill::Flat(1));
    assert_eq!(depth[0], 65535);
    assert!(depth[2] >= 1001);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]

    /// Depth against the straight line through the ends, level against the line in
    /// space; neither depends on bands or direction.
    #[test]
    fn depth_and_level_are_those_of_the_line(
        a in (-(100i32 << 12)..300 << 12, -(100i32 << 12)..200 << 12, 9u32..=65535 << 4, 0u16..=255 << 6),
        b in (-(100i32 << 12)..300 << 12, -(100i32 << 12)..200 << 12, 9u32..=65535 << 4, 0u16..=255 << 6),
        perspective: bool,
        rows in 1u16..60,
    ) {
        let levels: [u8; 256] = std::array::from_fn(|i| i as u8);
        let fill = Fill::Gouraud(&levels);
        let size = (160u16, 100u16);
        let [va, vb] = [a, b].map(|(x, y, z, level)| raw(x, y, z, level));
        let both = Line { perspective, ..line(&va, &vb) };
        let (depth, level) = draw(&[both], &TESTED, size, rows, fill);
        let back = Line { perspective, ..line(&vb, &va) };
        let other = draw(&[back], &TESTED, size, 100, fill);
        prop_assert_eq!((&depth, &level), (&other.0, &other.1));

        let steep = (b.1 - a.1).abs() > (b.0 - a.0).abs();
        let major = |x: i32, y: i32| f64::from(if steep { y } else { x });
        let (from, to) = (major(a.0, a.1), major(b.0, b.1));
        let far_apart = (to - from).abs() > 4096.0;
        let [za, zb] = [a.2, b.2].map(|z| f64::from(z) / 16.0);
        let [la, lb] = [a.3, b.3].map(|l| f64::from(l) / 64.0);
        for i in (0..depth.len()).filter(|i| depth[*i] != 0) {
            let centre = [i % 160, i / 160].map(|c| ((c as i32) << 12) + 2048);
            let t = ((major(centre[0], centre[1]) - from) / (to - from)).clamp(0.0, 1.0);
            let z = za + (zb - za) * t;
            if far_apart {
                prop_assert!((f64::from(depth[i]) - z).abs() < 0.75, "{} for {}", depth[i], z);
            }
            let space = if perspective { t * zb / z } else { t };
            let want = la + (lb - la) * space;
            // Linear over 8 pixels: where depth hardly changes over so many.
            let change = (zb - za).abs() / (to - from).abs() * 8.0 * 4096.0;
            if !perspective || (za.min(zb) > 2000.0 && change < 0.1 * za.min(zb)) {
                prop_assert!((f64::from(level[i]) - want).abs() < 2.0, "{} for {}", level[i], want);
            }
        }
    }
}
