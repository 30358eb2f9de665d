use fixel::line::{DepthRule, Mark, draw_mark};

use super::{TESTED, at, in_bands, raw};

/// A picture in text as rows of bits.
fn bits(drawing: &[&str]) -> Vec<u8> {
    drawing
        .iter()
        .flat_map(|row| {
            row.as_bytes().chunks(8).map(|eight| {
                let bit = |(i, c): (usize, &u8)| u8::from(*c == b'#') << (7 - i);
                eight.iter().enumerate().map(bit).sum()
            })
        })
        .collect()
}

#[test]
fn a_mark_is_where_its_offset_says_in_every_band_height() {
    let bits = bits(&["#.......##", "..........", ".########."]);
    let mark = Mark {
        width: 10,
        height: 3,
        offset: [-4, 2],
        bits: &bits,
    };
    for rows in [1, 2, 6] {
        let (depths, indices) = in_bands((12, 6), rows, |target| {
            draw_mark(target, &at((3.2, 1.9)), &mark, &TESTED, |_| Some(7));
        });
        let rows: Vec<String> = indices
            .chunks(12)
            .map(|row| {
                row.iter()
                    .map(|i| if *i == 7 { '#' } else { '.' })
                    .collect()
            })
            .collect();
        // Two pixels left of column 3, one below row 1.
        assert_eq!(
            rows,
            [
                "............",
                "............",
                ".#.......##.",
                "............",
                "..########..",
                "............"
            ]
        );
        assert!(
            depths
                .iter()
                .zip(&indices)
                .all(|(d, i)| (*d == 32768) == (*i == 7))
        );
    }
}

#[test]
fn half_pixels_centre_a_mark_of_even_size() {
    let bits = bits(&["##", "##"]);
    let mark = Mark {
        width: 2,
        height: 2,
        offset: [-1, -1],
        bits: &bits,
    };
    for (x, first) in [(2.0, 1), (2.4, 1), (2.5, 2), (2.9, 2)] {
        let (_, indices) = in_bands((6, 2), 2, |target| {
            draw_mark(target, &at((x, 1.0)), &mark, &TESTED, |_| Some(1));
        });
        let row: Vec<usize> = (0..6).filter(|i| indices[*i] == 1).collect();
        assert_eq!(row, [first, first + 1], "at {x}");
    }
}

#[test]
fn off_every_side_and_far_away_a_mark_is_cut() {
    let bits = bits(&["####", "####"]);
    let mark = Mark {
        width: 4,
        height: 2,
        offset: [0, 0],
        bits: &bits,
    };
    let count = |x: f64, y: f64| {
        let (_, indices) = in_bands((4, 4), 3, |target| {
            draw_mark(target, &at((x, y)), &mark, &TESTED, |_| Some(1));
        });
        indices.iter().filter(|i| **i == 1).count()
    };
    assert_eq!(count(0.5, 0.5), 8);
    assert_eq!(count(-2.5, 0.5), 2);
    assert_eq!(count(2.5, 3.5), 2);
    assert_eq!(count(0.5, -0.5), 4);
    assert_eq!(count(-2000.0, 2000.0), 0);
}

#[test]
fn a_mark_has_the_depth_of_its_point() {
    let bits = bits(&["#"]);
    let mark = Mark {
        width: 1,
        height: 1,
        offset: [0, 0],
        bits: &bits,
    };
    let draw = |first: u32, second: u32, rule: DepthRule| {
        in_bands((1, 1), 1, |target| {
            draw_mark(target, &raw(0, 0, first << 4, 0), &mark, &TESTED, |_| {
                Some(1)
            });
            draw_mark(target, &raw(0, 0, second << 4, 0), &mark, &rule, |_| {
                Some(2)
            });
        })
    };
    assert_eq!(draw(100, 99, TESTED), (vec![100], vec![1]));
    assert_eq!(draw(100, 101, TESTED), (vec![101], vec![2]));
    let lifted = DepthRule {
        test: true,
        bias: 2,
    };
    assert_eq!(draw(100, 99, lifted), (vec![101], vec![2]));
}
