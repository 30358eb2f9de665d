//! Levels in perspective: exact at both ends of each run of 16 pixels and
//! straight between, for every triangle that is inclined enough to show it.

use proptest::prelude::*;

use super::{BOTH, levels, raw};
use fixel::frame::Band;
use fixel::math::SUBPX_BITS;
use fixel::raster::{Fill, draw_triangle};
use fixel::vertex::ScreenVertex;

const SIZE: (u16, u16) = (60, 24);
const RUN: usize = 16;

/// Depths and levels of one triangle on a cleared screen.
fn draw(vertices: &[ScreenVertex; 3]) -> (Vec<u16>, Vec<u8>) {
    let pixels = usize::from(SIZE.0) * usize::from(SIZE.1);
    let (mut index, mut depth) = (vec![0; pixels], vec![0; pixels]);
    let mut band = Band::new(SIZE.0, &mut index, &mut depth).expect("a band");
    let mut target = band.target(0, SIZE.1);
    target.clear(|_| 0);
    let table = levels();
    let fill = || Fill::Gouraud(&table);
    draw_triangle(&mut target, vertices.each_ref(), BOTH, true, fill);
    (target.depths.to_vec(), target.indices.to_vec())
}

/// What the three values' plane has at a pixel's centre.
fn plane(vertices: &[ScreenVertex; 3], values: [f64; 3], x: usize, y: usize) -> f64 {
    let (px, py) = (x as f64 + 0.5, y as f64 + 0.5);
    let [(ax, ay), (bx, by), (cx, cy)] = vertices
        .each_ref()
        .map(|v| (v.x().to_num::<f64>(), v.y().to_num::<f64>()));
    let area = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax);
    let b = ((px - ax) * (cy - ay) - (py - ay) * (cx - ax)) / area;
    let c = ((bx - ax) * (py - ay) - (by - ay) * (px - ax)) / area;
    let [va, vb, vc] = values;
    va + (vb - va) * b + (vc - va) * c
}

fn span(values: [f64; 3]) -> (f64, f64) {
    let high = values.iter().copied().fold(0.0, f64::max);
    (values.iter().copied().fold(f64::MAX, f64::min), high)
}

fn corner() -> impl Strategy<Value = (i32, i32)> {
    let one = 1 << SUBPX_BITS;
    let x = prop_oneof![3 => -one..61 * one, 1 => -1900 * one..1900 * one];
    let y = prop_oneof![3 => -one..25 * one, 1 => -1900 * one..1900 * one];
    (x, y)
}

/// Depths of two units and more, near and far.
fn depth() -> impl Strategy<Value = u32> {
    prop_oneof![32u32..=65535 << 4, 32u32..3000 << 4, Just(65535 << 4)]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(8_000))]

    #[test]
    fn levels_are_right_at_the_ends_of_each_run(
        corners in prop::array::uniform3(corner()),
        depths in prop::array::uniform3(depth()),
        level_bits in prop::array::uniform3(0u16..=255 << 6),
    ) {
        let vertices: [ScreenVertex; 3] = core::array::from_fn(|i| {
            raw(corners[i].0, corners[i].1, depths[i], level_bits[i])
        });
        let (z, level) = (depths.map(|z| f64::from(z) / 16.0), level_bits.map(|l| f64::from(l) / 64.0));
        let ((far, near), (low, high)) = (span(z), span(level));
        let (left, right) = span(corners.map(|(x, _)| f64::from(x >> SUBPX_BITS)));
        let (top, bottom) = span(corners.map(|(_, y)| f64::from(y >> SUBPX_BITS)));
        let (pixels, drawn) = draw(&vertices);
        let exact = |x: usize, y: usize| {
            let products = [0, 1, 2].map(|i| z[i] * level[i]);
            plane(&vertices, products, x, y) / plane(&vertices, z, x, y)
        };
        let width = usize::from(SIZE.0);
        for (y, (row, levels)) in pixels.chunks(width).zip(drawn.chunks(width)).enumerate() {
            let Some(start) = row.iter().position(|z| *z != 0) else {
                continue;
            };
            let end = row.iter().rposition(|z| *z != 0).map_or(start, |last| last + 1);
            for (x, got) in levels.iter().enumerate().take(end).skip(start) {
                let got = f64::from(*got);
                prop_assert!(got >= low - 1.0 && got <= high + 1.0, "level {} leaves {}..{}", got, low, high);
                let from = start + (x - start) / RUN * RUN;
                let to = (from + RUN).min(end) - 1;
                let part = (x - from) as f64 / (to - from).max(1) as f64;
                let along = exact(from, y) + part * (exact(to, y) - exact(from, y));
                // Rounding, and a run's steps, which are off by a 2000th of its
                // difference. Then, for each pixel from the triangle's top: 2^-16 of
                // a unit of depth, and a 64th of a level times a unit of depth.
                let here = plane(&vertices, z, x, y);
                let ends = plane(&vertices, z, from, y).min(plane(&vertices, z, to, y));
                let (way, least) = ((right - left) + (bottom - top), here.min(ends));
                let most = 0.53 + 0.13 + way * (255.0 / 65536.0 + 1.0 / 64.0) / least;
                let straight = plane(&vertices, level, x, y);
                let curved = (high - low) * (near - far) > 4.0 * far * 1.01 + 1.0;
                let wide = right - left > 8.0;
                let near_to = |level: f64| (got - level).abs() <= most;
                // Steep faces go pixel by pixel. Those not inclined enough, or too
                // narrow, go along the screen.
                let fits = near_to(along)
                    || near_to(exact(x, y))
                    || (!(curved && wide) && near_to(straight));
                prop_assert!(fits, "{} {}: {} instead of {} or {}, at most {}, depth {}", x, y, got, along, straight, most, here);
            }
        }
    }
}
