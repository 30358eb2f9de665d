use proptest::prelude::*;

use super::{Line, at, hits, line, raw};

/// Draws a chain of points, each line leaving its last end to the next, and
/// compares how often each pixel is hit with a drawing; so do its mirror image
/// about the diagonal, the same backwards, and all of them in bands.
fn assert_chain(points: &[(f64, f64)], closed: bool, drawing: &[&str]) {
    let turned: Vec<_> = points.iter().map(|(x, y)| (*y, *x)).collect();
    let wanted: Vec<u8> = drawing
        .iter()
        .flat_map(|row| row.bytes())
        .map(|b| b - b'0')
        .collect();
    let (w, h) = (drawing[0].len(), drawing.len());
    let transposed: Vec<u8> = (0..w * h).map(|i| wanted[i % h * w + i / h]).collect();
    let size = (w as u16, h as u16);
    for (points, size, wanted) in [
        (points, size, &wanted),
        (&turned, (size.1, size.0), &transposed),
    ] {
        for backwards in [false, true] {
            let mut vertices: Vec<_> = points.iter().map(|p| at(*p)).collect();
            if backwards {
                vertices.reverse();
            }
            if closed {
                vertices.push(vertices[0]);
            }
            let last = vertices.len() - 2;
            let chain: Vec<Line<'_>> = vertices
                .windows(2)
                .enumerate()
                .map(|(i, v)| Line {
                    ends: [true, i == last && !closed],
                    ..line(&v[0], &v[1])
                })
                .collect();
            for rows in [1, 2, size.1] {
                let found = hits(&chain, size, rows);
                let picture: Vec<String> = found
                    .chunks(size.0.into())
                    .map(|row| row.iter().map(u8::to_string).collect())
                    .collect();
                assert_eq!(
                    &found, wanted,
                    "{points:?} backwards {backwards}, bands of {rows}: {picture:#?}"
                );
            }
        }
    }
}

#[test]
fn level_and_slanting_lines() {
    assert_chain(
        &[(0.5, 1.5), (4.5, 1.5)],
        false,
        &["00000", "11111", "00000"],
    );
    assert_chain(
        &[(0.5, 0.5), (3.5, 3.5)],
        false,
        &["1000", "0100", "0010", "0001"],
    );
    assert_chain(
        &[(0.5, 0.5), (4.5, 2.5)],
        false,
        &["10000", "01100", "00011"],
    );
}

#[test]
fn an_end_counts_if_it_is_in_the_pixels_diamond() {
    // Just past the centre of column 1, but in its diamond; before the centre of
    // column 4 and not in it.
    assert_chain(
        &[(1.8, 1.5), (4.4, 1.5)],
        false,
        &["000000", "011110", "000000"],
    );
    // Outside of any diamond: the centre lines decide.
    assert_chain(
        &[(1.9, 1.05), (3.95, 1.05)],
        false,
        &["000000", "001100", "000000"],
    );
}

#[test]
fn a_point_is_a_pixel_if_it_is_in_a_diamond() {
    assert_chain(&[(1.6, 1.4), (1.6, 1.4)], false, &["000", "010", "000"]);
    assert_chain(&[(1.95, 1.95), (1.95, 1.95)], false, &["000", "000", "000"]);
}

#[test]
fn the_corners_of_an_outline_are_hit_once() {
    let square = [(1.5, 1.5), (4.5, 1.5), (4.5, 3.5), (1.5, 3.5)];
    assert_chain(
        &square,
        true,
        &["000000", "011110", "010010", "011110", "000000"],
    );
    // On any sub-pixel place.
    let square = [(1.7, 1.4), (4.7, 1.4), (4.7, 3.4), (1.7, 3.4)];
    assert_chain(
        &square,
        true,
        &["000000", "011110", "010010", "011110", "000000"],
    );
}

#[test]
fn what_is_off_the_screen_leaves_the_rest_as_it_is() {
    assert_chain(
        &[(-900.0, 1.5), (900.0, 1.5)],
        false,
        &["000", "111", "000"],
    );
    assert_chain(
        &[(-1000.5, -1000.5), (1000.5, 1000.5)],
        false,
        &["100", "010", "001"],
    );
    assert_chain(&[(-100.0, 50.0), (-50.0, 900.0)], false, &["000", "000"]);
}

#[test]
fn a_wide_line_is_so_many_pixels_across() {
    let (a, b) = (at((1.5, 3.5)), at((4.5, 3.5)));
    for (width, drawing) in [
        (
            2,
            ["000000", "000000", "000000", "011110", "011110", "000000"],
        ),
        (
            3,
            ["000000", "000000", "011110", "011110", "011110", "000000"],
        ),
        (
            4,
            ["000000", "000000", "011110", "011110", "011110", "011110"],
        ),
    ] {
        let wide = Line {
            width,
            ..line(&a, &b)
        };
        let wanted: Vec<u8> = drawing
            .iter()
            .flat_map(|row| row.bytes())
            .map(|b| b - b'0')
            .collect();
        for rows in [1, 4, 6] {
            assert_eq!(hits(&[wide], (6, 6), rows), wanted, "width {width}");
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]

    /// Chains that do not turn back have each pixel once and hang together.
    #[test]
    fn a_chain_that_goes_on_has_no_gap_and_no_pixel_twice(
        start in (0..20 << 12, 0..60 << 12),
        steps in prop::collection::vec((0..30 << 12, 0..30 << 12), 1..6),
        upwards: bool,
    ) {
        let (mut x, mut y) = start;
        let mut vertices = vec![raw(x, y, 9999, 0)];
        for (dx, dy) in steps {
            (x, y) = (x + dx, if upwards { y - dy } else { y + dy });
            vertices.push(raw(x, y, 9999, 0));
        }
        let last = vertices.len() - 2;
        let chain: Vec<Line<'_>> = vertices
            .windows(2)
            .enumerate()
            .map(|(i, v)| Line { ends: [true, i == last], ..line(&v[0], &v[1]) })
            .collect();
        let size = (200u16, 80u16);
        let found = hits(&chain, size, 80);
        // A bend may come back into a diamond that it has left.
        for (i, _) in found.iter().enumerate().filter(|(_, n)| **n > 1) {
            let centre = [i % 200, i / 200].map(|c| ((c as i32) << 12) + 2048);
            let bent = vertices[1..=last].iter().any(|v| {
                let off = [v.x().to_bits() - centre[0], v.y().to_bits() - centre[1]];
                off.iter().all(|c| c.abs() <= 4096)
            });
            prop_assert!(bent, "pixel {} {} twice", i % 200, i / 200);
        }
        prop_assert_eq!(&found, &hits(&chain, size, 7));
        // Each pixel has a neighbour, if there are others on the screen.
        let on = |x: i32, y: i32| (0..200).contains(&x) && (0..80).contains(&y) && found[(y * 200 + x) as usize] > 0;
        let all: Vec<(i32, i32)> = (0..80).flat_map(|y| (0..200).map(move |x| (x, y))).filter(|(x, y)| on(*x, *y)).collect();
        let inside = vertices.iter().all(|v| {
            let (x, y) = (v.x().to_bits() >> 12, v.y().to_bits() >> 12);
            (1..199).contains(&x) && (1..79).contains(&y)
        });
        if inside && !all.is_empty() {
            // One piece: fill it from its first pixel.
            let mut seen = std::collections::HashSet::from([all[0]]);
            let mut waiting = vec![all[0]];
            while let Some((x, y)) = waiting.pop() {
                for (nx, ny) in (-1..=1).flat_map(|dx| (-1..=1).map(move |dy| (x + dx, y + dy))) {
                    if on(nx, ny) && seen.insert((nx, ny)) {
                        waiting.push((nx, ny));
                    }
                }
            }
            prop_assert_eq!(seen.len(), all.len(), "the chain falls apart");
        }
    }

    /// Against the rule as it is stated, in wide integers.
    #[test]
    fn a_line_has_the_pixels_of_the_rule(
        a in (-(30i64 << 12)..60 << 12, -(30i64 << 12)..60 << 12),
        b in (-(30i64 << 12)..60 << 12, -(30i64 << 12)..60 << 12),
        ends in any::<[bool; 2]>(),
        rows in 1u16..30,
    ) {
        let size = (31u16, 29u16);
        let (from, to) = (raw(a.0 as i32, a.1 as i32, 999, 0), raw(b.0 as i32, b.1 as i32, 999, 0));
        let found = hits(&[Line { ends, ..line(&from, &to) }], size, rows);
        let steep = (b.1 - a.1).abs() > (b.0 - a.0).abs();
        let flip = |(x, y): (i64, i64)| if steep { (y, x) } else { (x, y) };
        let (mut p, mut q, mut ends) = (flip(a), flip(b), ends);
        if q.0 < p.0 {
            (p, q) = (q, p);
            ends.reverse();
        }
        let mid = |pixel: i64| (pixel << 12) + 2048;
        let in_diamond = |(x, y): (i64, i64), pixel: i64| {
            x >> 12 == pixel && (x - mid(pixel)).abs() + (y - mid(y >> 12)).abs() < 2048
        };
        let mut wanted = vec![0; found.len()];
        for pixel in -40..100i64 {
            let crossed = (p.0..q.0).contains(&mid(pixel));
            let mut has = crossed;
            for (end, own) in [(p, ends[0]), (q, ends[1])] {
                if in_diamond(end, pixel) {
                    has = own;
                }
            }
            // An end that is left out wins over one that is not.
            if [(p, ends[0]), (q, ends[1])].iter().any(|(end, own)| in_diamond(*end, pixel) && !own) {
                has = false;
            }
            if !has {
                continue;
            }
            let length = (q.0 - p.0).max(1);
            let across = (p.1 * length + (q.1 - p.1) * (mid(pixel) - p.0)).div_euclid(length) >> 12;
            let (x, y) = flip((pixel, across));
            if (0..31).contains(&x) && (0..29).contains(&y) {
                wanted[(y * 31 + x) as usize] = 1;
            }
        }
        prop_assert_eq!(found, wanted);
    }
}
