//! Depth and level at each pixel against the exact plane, and never outside the
//! vertices' range: nothing wraps, slivers included.

use proptest::prelude::*;

use super::{draw, is_tiny, levels, raw};
use fixel::math::{HALF_PX, SUBPX_BITS};
use fixel::raster::Fill;

const SIZE: (u16, u16) = (40, 30);

/// The plane through three values, at a pixel's centre.
fn plane(corners: [(i32, i32); 3], values: [f64; 3], x: usize, y: usize) -> f64 {
    let centre = |p: usize| f64::from(((p as i32) << SUBPX_BITS) + HALF_PX);
    let (px, py) = (centre(x), centre(y));
    let [(ax, ay), (bx, by), (cx, cy)] = corners.map(|(x, y)| (f64::from(x), f64::from(y)));
    let area = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax);
    let b = ((px - ax) * (cy - ay) - (py - ay) * (cx - ax)) / area;
    let c = ((bx - ax) * (py - ay) - (by - ay) * (px - ax)) / area;
    let [va, vb, vc] = values;
    va + (vb - va) * b + (vc - va) * c
}

fn corner() -> impl Strategy<Value = (i32, i32)> {
    let one = 1 << SUBPX_BITS;
    let x = prop_oneof![3 => -one..41 * one, 1 => -1900 * one..1900 * one];
    let y = prop_oneof![3 => -one..31 * one, 1 => -1900 * one..1900 * one];
    (x, y)
}

/// A third corner close to the line through the first two: slivers.
fn triangle() -> impl Strategy<Value = [(i32, i32); 3]> {
    let any = (corner(), corner(), corner()).prop_map(|(a, b, c)| [a, b, c]);
    let sliver = (corner(), corner(), 0i64..=1000, -600i32..600).prop_map(|(a, b, t, off)| {
        let mix = |a: i32, b: i32| (i64::from(a) + (i64::from(b) - i64::from(a)) * t / 1000) as i32;
        [a, b, (mix(a.0, b.0) + off, mix(a.1, b.1))]
    });
    prop_oneof![any, sliver, super::tiny((40, 30))]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(4000))]

    #[test]
    fn depth_and_level_are_those_of_the_plane(
        corners in triangle(),
        depths in super::depths(),
        // In steps of 1/16, as a vertex on the screen has it.
        level_bits in prop::array::uniform3((0u16..=255 << 4).prop_map(|level| level << 2)),
    ) {
        let raw_depths = depths.map(|z| (u32::from(z) << 4).clamp(16, 65535 << 4));
        let vertices: [_; 3] = core::array::from_fn(|i| {
            raw(corners[i].0, corners[i].1, raw_depths[i], level_bits[i])
        });
        let table = levels();
        let (depth, level) = draw(vertices.each_ref(), SIZE, SIZE.1, Fill::Gouraud(&table));
        let z = raw_depths.map(|z| f64::from(z) / 16.0);
        let l = level_bits.map(|l| f64::from(l) / 64.0);
        let range = |v: [f64; 3]| {
            (v.iter().copied().fold(f64::MAX, f64::min), v.iter().copied().fold(0.0, f64::max))
        };
        let ((z_low, z_high), (l_low, l_high)) = (range(z), range(l));
        for (i, (d, v)) in depth.iter().zip(&level).enumerate() {
            if *d == 0 {
                continue;
            }
            let (x, y) = (i % usize::from(SIZE.0), i / usize::from(SIZE.0));
            let (got_z, got_l) = (f64::from(*d), f64::from(*v));
            prop_assert!(got_z >= z_low - 1.0 && got_z <= z_high + 1.0, "depth {} leaves {}..{}", got_z, z_low, z_high);
            prop_assert!(got_l >= l_low - 1.0 && got_l <= l_high + 1.0, "level {} leaves {}..{}", got_l, l_low, l_high);
            // Half a unit is the rounding. The rest: 2^-17 a pixel over 2000
            // pixels, the reciprocal's 2^-28 of what the plane spans, and for
            // slivers a weight's 2^-20 of the range; where pixels go by weights, both
            // together are off by 3.3 times 2^-16 of the range, of depths 2048 at most.
            let exact_z = plane(corners, z, x, y);
            let exact_l = plane(corners, l, x, y);
            let weight = if is_tiny(&vertices) { 3.3 / 65536.0 } else { 0.0 };
            let tolerance = 0.5 + 0.02 + (z_high - z_low) / 65536.0 * 0.3
                + weight * 2048f64.min(z_high - z_low);
            let level_tolerance = 0.53 + weight * (l_high - l_low);
            prop_assert!((got_z - exact_z).abs() <= tolerance, "depth {} instead of {}", got_z, exact_z);
            prop_assert!((got_l - exact_l).abs() <= level_tolerance, "level {} instead of {}", got_l, exact_l);
        }
    }
}
