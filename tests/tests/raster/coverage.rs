//! Drawings whose digits are hit counts: a gap shows as 0, a pixel drawn twice
//! as 2.

use super::{at, hits};
use fixel::vertex::ScreenVertex;

/// Draws triangles given by corners in pixels and compares with a drawing, in
/// one band and in bands of one and of two rows.
macro_rules! assert_coverage {
    ($triangles:expr, $drawing:expr) => {{
        let wanted: Vec<&str> = $drawing.iter().copied().collect();
        let size = (wanted[0].len() as u16, wanted.len() as u16);
        let corners: Vec<[ScreenVertex; 3]> = $triangles
            .iter()
            .map(|t| t.map(|(x, y)| at(x, y)))
            .collect();
        let triangles: Vec<[&ScreenVertex; 3]> = corners.iter().map(|t| t.each_ref()).collect();
        for rows in [size.1, 1, 2] {
            let counts = hits(&triangles, size, rows);
            let got: Vec<String> = counts
                .chunks(wanted[0].len())
                .map(|row| row.iter().map(|n| char::from(b'0' + n)).collect())
                .collect();
            assert_eq!(got, wanted, "in bands of {rows} rows");
        }
    }};
}

#[test]
fn corners_on_pixel_centres_keep_top_and_left() {
    // A right angle: the top row and the left column belong to it, the
    // hypotenuse from top right to bottom left is a right edge.
    assert_coverage!(
        [[(0.5, 0.5), (0.5, 4.5), (4.5, 0.5)]],
        ["11110", "11100", "11000", "10000", "00000"]
    );
    // Its mirror image: the hypotenuse is a left edge, the vertical a right one.
    assert_coverage!(
        [[(4.5, 0.5), (4.5, 4.5), (0.5, 4.5)]],
        ["00000", "00010", "00110", "01110", "00000"]
    );
}

#[test]
fn winding_does_not_change_coverage() {
    for order in [
        [0, 1, 2],
        [1, 2, 0],
        [2, 0, 1],
        [2, 1, 0],
        [1, 0, 2],
        [0, 2, 1],
    ] {
        let corners = [(0.5, 0.5), (3.5, 2.5), (1.5, 4.5)];
        assert_coverage!(
            [order.map(|i: usize| corners[i])],
            ["0000", "0100", "0110", "0100"]
        );
    }
}

#[test]
fn a_square_of_two_triangles_hits_each_pixel_once() {
    for (a, b) in [(0.0, 4.0), (0.5, 4.5), (0.25, 3.9)] {
        let (p, q, r, s) = ((a, a), (b, a), (b, b), (a, b));
        let inside = ["1111", "1111", "1111", "1111"];
        assert_coverage!([[p, q, r], [p, r, s]], inside);
        assert_coverage!([[p, q, s], [q, r, s]], inside);
    }
}

#[test]
fn a_fan_around_a_pixel_centre_hits_each_pixel_once() {
    let rim = [
        (3.5, -1.0),
        (6.1, -0.7),
        (8.0, 3.5),
        (6.0, 6.0),
        (3.5, 8.0),
        (1.0, 6.0),
        (-1.0, 3.5),
        (0.0, 0.0),
    ];
    let fan: Vec<_> = (0..8)
        .map(|i| [(3.5, 3.5), rim[i], rim[(i + 1) % 8]])
        .collect();
    let (mut zeros, mut ones) = (0, 0);
    let corners: Vec<[ScreenVertex; 3]> = fan.iter().map(|t| t.map(|(x, y)| at(x, y))).collect();
    let triangles: Vec<[&ScreenVertex; 3]> = corners.iter().map(|t| t.each_ref()).collect();
    for n in hits(&triangles, (7, 7), 3) {
        assert!(n < 2, "a pixel drawn {n} times");
        (zeros, ones) = (zeros + u8::from(n == 0), ones + n);
    }
    // All but what the rim leaves out at the bottom corners, three each.
    assert_eq!((zeros, ones), (6, 43));
}

#[test]
fn what_has_no_pixel_centre_draws_nothing() {
    assert_coverage!([[(0.6, 0.6), (1.4, 0.6), (1.0, 1.4)]], ["00", "00"]);
    assert_coverage!(
        [[(0.51, 0.0), (0.53, 0.0), (0.52, 4.0)]],
        ["00", "00", "00", "00"]
    );
    assert_coverage!(
        [[(1.0, 1.0), (1.0, 1.0), (3.0, 3.0)]],
        ["0000", "0000", "0000"]
    );
}

#[test]
fn off_screen_parts_leave_the_rest_as_it_is() {
    assert_coverage!(
        [
            [(-900.0, -900.0), (900.0, -900.0), (-900.0, 900.0)],
            [(900.0, -900.0), (900.0, 900.0), (-900.0, 900.0)]
        ],
        ["11111", "11111", "11111"]
    );
    assert_coverage!(
        [[(1.5, 1.5), (1.5, 900.0), (900.0, 1.5)]],
        ["0000", "0111", "0111"]
    );
}
