//! Random tilings hit each pixel once, and random triangles cover what exact
//! edge functions say.

use proptest::prelude::*;

use super::{draw, hits, levels, raw};
use fixel::math::{HALF_PX, SUBPX_BITS};
use fixel::raster::Fill;
use fixel::vertex::ScreenVertex;

const SIZE: (u16, u16) = (24, 18);

/// Whether the top-left rule gives a pixel centre to the triangle, in i128.
fn covered(corners: [(i32, i32); 3], px: i32, py: i32) -> bool {
    let centre = |p: i32| i128::from((p << SUBPX_BITS) + HALF_PX);
    let (x, y) = (centre(px), centre(py));
    let wide = corners.map(|(x, y)| (i128::from(x), i128::from(y)));
    let edge = |(ax, ay): (i128, i128), (bx, by): (i128, i128)| {
        (bx - ax) * (y - ay) - (by - ay) * (x - ax)
    };
    let [a, b, c] = wide;
    let area = (b.0 - a.0) * (c.1 - a.1) - (b.1 - a.1) * (c.0 - a.0);
    if area == 0 {
        return false;
    }
    // y points down: with a positive area the inside is where all are positive.
    let [a, b, c] = if area > 0 { wide } else { [a, c, b] };
    [(a, b), (b, c), (c, a)].iter().all(|(p, q)| {
        let e = edge(*p, *q);
        let (dx, dy) = (q.0 - p.0, q.1 - p.1);
        let top_or_left = (dy == 0 && dx > 0) || dy < 0;
        e > 0 || (e == 0 && top_or_left)
    })
}

/// Coordinates near and far, on pixel centres and off.
fn coordinate(pixels: i32) -> impl Strategy<Value = i32> {
    let one = 1 << SUBPX_BITS;
    prop_oneof![
        4 => -one..(pixels + 1) * one,
        2 => (-1..=pixels).prop_map(move |p| p * one + HALF_PX),
        1 => (-1..=pixels * 2).prop_map(move |p| p * one / 2),
        1 => -2000 * one..2000 * one,
    ]
}

fn corner() -> impl Strategy<Value = (i32, i32)> {
    (coordinate(SIZE.0.into()), coordinate(SIZE.1.into()))
}

fn corners() -> impl Strategy<Value = [(i32, i32); 3]> {
    prop_oneof![
        2 => prop::array::uniform3(corner()),
        1 => super::tiny((SIZE.0.into(), SIZE.1.into())),
    ]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(5000))]

    #[test]
    fn coverage_is_that_of_exact_edge_functions([a, b, c] in corners()) {
        let corners = [a, b, c].map(|(x, y)| raw(x, y, 1000, 0));
        let (depths, _) = draw(corners.each_ref(), SIZE, SIZE.1, Fill::Flat(1));
        for (i, depth) in depths.iter().enumerate() {
            let (x, y) = ((i % usize::from(SIZE.0)) as i32, (i / usize::from(SIZE.0)) as i32);
            prop_assert_eq!(*depth != 0, covered([a, b, c], x, y), "pixel {} {}", x, y);
        }
    }

    #[test]
    fn bands_of_any_height_give_the_same_bytes(
        [a, b, c] in corners(), z in super::depths(), rows in 1u16..18,
    ) {
        let depths = z.map(|z| u32::from(z.clamp(1, 65535)) << 4);
        let corners = [
            raw(a.0, a.1, depths[0], 0),
            raw(b.0, b.1, depths[1], 255 << 6),
            raw(c.0, c.1, depths[2], 100 << 6),
        ];
        let table = levels();
        let whole = draw(corners.each_ref(), SIZE, SIZE.1, Fill::Gouraud(&table));
        let bands = draw(corners.each_ref(), SIZE, rows, Fill::Gouraud(&table));
        prop_assert_eq!(whole, bands);
    }

    /// The screen's rectangle, cut again and again at random points: a triangle
    /// with a point inside becomes three, an edge with a point on it is cut in
    /// both triangles that have it.
    #[test]
    fn a_random_tiling_hits_each_pixel_once(
        cuts in prop::collection::vec((any::<prop::sample::Index>(), 1i64..1000, 1i64..1000), 1..40),
    ) {
        let (right, bottom) = (i32::from(SIZE.0) << SUBPX_BITS, i32::from(SIZE.1) << SUBPX_BITS);
        let mut points = vec![(-5000, -5000), (right + 7, -5000), (right + 7, bottom + 3), (-5000, bottom + 3)];
        let mut triangles: Vec<[usize; 3]> = vec![[0, 1, 2], [0, 2, 3]];
        for (which, u, v) in cuts {
            let at = which.index(triangles.len());
            let [a, b, c] = triangles[at];
            let w = 1000 + 1000 - u - v;
            let mix = |f: fn(&(i32, i32)) -> i32| {
                let value = |i: usize| i64::from(f(&points[i]));
                ((value(a) * u + value(b) * v + value(c) * w) / 2000) as i32
            };
            let new = (mix(|p| p.0), mix(|p| p.1));
            // Rounding may take it out of a sliver: such a cut is not made.
            let side = |p: usize, q: usize| {
                let ((px, py), (qx, qy)) = (points[p], points[q]);
                i64::from(qx - px) * i64::from(new.1 - py) - i64::from(qy - py) * i64::from(new.0 - px)
            };
            if [side(a, b), side(b, c), side(c, a)].iter().any(|s| *s <= 0) {
                continue;
            }
            points.push(new);
            let n = points.len() - 1;
            triangles[at] = [a, b, n];
            triangles.extend([[b, c, n], [c, a, n]]);
        }
        let vertices: Vec<ScreenVertex> = points.iter().map(|(x, y)| raw(*x, *y, 9, 0)).collect();
        let drawn: Vec<[&ScreenVertex; 3]> =
            triangles.iter().map(|t| t.map(|i| &vertices[i])).collect();
        let counts = hits(&drawn, SIZE, 5);
        prop_assert!(counts.iter().all(|n| *n == 1), "{:?}", counts);
    }
}
