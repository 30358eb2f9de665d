//! Colour models against the usual formulas.

use super::*;

fn colours() -> impl Iterator<Item = [u8; 3]> {
    let steps = || (0..=255u8).step_by(5).chain([1, 2, 127, 128, 254]);
    steps().flat_map(move |r| steps().flat_map(move |g| steps().map(move |b| [r, g, b])))
}

#[test]
fn inks_give_their_colour_back() {
    for colour in colours() {
        assert_eq!(cmy(cmy(colour)), colour);
        let inks = cmyk_of(colour);
        let exact = |c: u8| {
            let white = f64::from(255 - inks[3]);
            255.0 * (1.0 - f64::from(c) / white)
        };
        for i in 0..3 {
            let off = f64::from(inks[i]) - exact(colour[i]);
            assert!(
                inks[3] == 255 || off.abs() <= 0.5 + 1e-9,
                "{colour:?} {inks:?}"
            );
        }
        assert_eq!(cmyk(inks), colour, "{inks:?}");
    }
}

#[test]
fn hues_are_nearest() {
    let named = [
        ([255, 0, 0], 0),
        ([255, 255, 0], 256),
        ([0, 255, 0], 512),
        ([0, 255, 255], 768),
        ([0, 0, 255], 1024),
        ([255, 0, 255], 1280),
    ];
    for (colour, hue) in named {
        assert_eq!(hsv_of(colour), (hue, 255, 255));
        assert_eq!(hsv(hue, 255, 255), colour);
    }
    for colour in colours() {
        let (h, s, v) = hsv_of(colour);
        assert!(h < 1536);
        // A step of saturation is a value's 255th, one of hue a 256th of the range.
        let again = hsv(h, s, v);
        for i in 0..3 {
            assert!(again[i].abs_diff(colour[i]) <= 1, "{colour:?} {again:?}");
        }
    }
}

/// Against the usual formula.
#[test]
fn colours_of_hues_are_rounded_to_nearest() {
    for hue in (0..1536u16).step_by(7) {
        for (s, v) in [(255, 255), (0, 77), (128, 200), (13, 255), (250, 3)] {
            let (fs, fv) = (f64::from(s) / 255.0, f64::from(v));
            let exact = |n: f64| {
                let k = (n + f64::from(hue) / 256.0) % 6.0;
                fv - fv * fs * k.min(4.0 - k).clamp(0.0, 1.0)
            };
            let found = hsv(hue, s, v);
            for (channel, n) in found.iter().zip([5.0, 3.0, 1.0]) {
                let off = f64::from(*channel) - exact(n);
                assert!(off.abs() <= 0.5 + 1e-9, "{hue} {s} {v}: {found:?}");
            }
        }
    }
}

#[test]
fn a_fade_ends_where_it_should() {
    let (from, to) = ([[10, 200, 0], [255; 3]], [[0; 3], [1, 2, 3]]);
    let mut faded = [[9; 3]; 2];
    cross_fade(&from, &to, 0, &mut faded);
    assert_eq!(faded, from);
    cross_fade(&from, &to, 300, &mut faded);
    assert_eq!(faded, to);
    fade(&from, [20, 0, 255], 64, &mut faded);
    assert_eq!(faded[0], [13, 150, 64]);
}
