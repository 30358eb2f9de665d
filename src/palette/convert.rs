//! Colour models. Channels are 0..=255; a hue is 0..=1535, 256 steps from one of red,
//! yellow, green, cyan, blue, magenta to the next.

/// Cyan, magenta, yellow of red, green, blue, and back. Exact.
pub const fn cmy([a, b, c]: [u8; 3]) -> [u8; 3] {
    [255 - a, 255 - b, 255 - c]
}

/// Cyan, magenta, yellow, black of a colour, with as much black as there can be; each
/// rounded to nearest, so off by at most 1/2. Black is no cyan, magenta or yellow.
pub const fn cmyk_of([r, g, b]: [u8; 3]) -> [u8; 4] {
    const fn ink(channel: u8, white: u8) -> u8 {
        if white == 0 {
            return 0;
        }
        let (off, white) = ((white - channel) as u32, white as u32);
        ((2 * 255 * off + white) / (2 * white)) as u8
    }
    let white = max(r, max(g, b));
    [ink(r, white), ink(g, white), ink(b, white), 255 - white]
}

/// The colour of cyan, magenta, yellow, black: `(255 - ink) (255 - k) / 255`, rounded to
/// nearest. Of a colour's [`cmyk_of`] it is that colour again.
pub const fn cmyk([c, m, y, k]: [u8; 4]) -> [u8; 3] {
    const fn channel(ink: u8, k: u8) -> u8 {
        (((255 - ink) as u32 * (255 - k) as u32 + 127) / 255) as u8
    }
    [channel(c, k), channel(m, k), channel(y, k)]
}

/// Hue (0..=1535), saturation and value, each rounded to nearest: the hue and the
/// saturation are off by at most 1/2 of a step. Grey has hue 0.
pub const fn hsv_of([r, g, b]: [u8; 3]) -> (u16, u8, u8) {
    let value = max(r, max(g, b));
    let low = 255 - max(255 - r, max(255 - g, 255 - b));
    let range = (value - low) as i32;
    if range == 0 {
        return (0, 0, value);
    }
    let (r, g, b) = (r as i32, g as i32, b as i32);
    // The middle of a sector of 512 steps, and how far to the side.
    let (middle, side) = if value as i32 == r {
        (0, g - b)
    } else if value as i32 == g {
        (512, b - r)
    } else {
        (1024, r - g)
    };
    let step = (2 * 256 * side + range).div_euclid(2 * range);
    let hue = (middle + step).rem_euclid(1536) as u16;
    let value = value as i32;
    let saturation = (2 * 255 * range + value) / (2 * value);
    (hue, saturation as u8, value as u8)
}

/// The colour of a hue (any number; 1536 is a turn), saturation and value: off by at most
/// 1/2 from the exact formula, once it is rounded.
pub const fn hsv(hue: u16, saturation: u8, value: u8) -> [u8; 3] {
    /// 255 in the middle third of the turn about `at`, falling to 0 beside it.
    const fn wave(hue: i32, at: i32, saturation: u8, value: u8) -> u8 {
        let turn = (hue - at).rem_euclid(1536);
        let away = if turn > 768 { 1536 - turn } else { turn };
        // In 1/256: full up to 256 steps away, nothing from 512 on.
        let full = if away <= 256 {
            256
        } else if away >= 512 {
            0
        } else {
            512 - away
        };
        let (s, v) = (saturation as u32, value as u32);
        let part = 255 * 256 - s * (256 - full as u32);
        ((v * part + 255 * 128) / (255 * 256)) as u8
    }
    let hue = hue as i32;
    [
        wave(hue, 0, saturation, value),
        wave(hue, 512, saturation, value),
        wave(hue, 1024, saturation, value),
    ]
}

/// `part` of 256 of the way from one colour to another, each channel rounded to nearest:
/// 0 is the one, 256 the other; more is taken as 256.
pub const fn mixed(from: [u8; 3], to: [u8; 3], part: u16) -> [u8; 3] {
    const fn channel(from: u8, to: u8, part: u32) -> u8 {
        ((from as u32 * (256 - part) + to as u32 * part + 128) >> 8) as u8
    }
    let part = if part > 256 { 256 } else { part } as u32;
    let ([a, b, c], [d, e, f]) = (from, to);
    [
        channel(a, d, part),
        channel(b, e, part),
        channel(c, f, part),
    ]
}

/// Fades the entries of a palette to a colour, into `faded`, as many as there is room
/// for: see [`mixed`]. With a frame of indices kept, a panel shows the fade without
/// rendering.
///
/// ```
/// use fixel::palette::{Palette, fade};
///
/// let colours = [[255, 0, 0], [0, 0, 0]];
/// let mut faded = [[0; 3]; 2];
/// fade(&colours, [255; 3], 128, &mut faded);
/// assert_eq!(Palette::new(&faded).rgb888(0), [255, 128, 128]);
/// ```
pub fn fade(colours: &[[u8; 3]], to: [u8; 3], part: u16, faded: &mut [[u8; 3]]) {
    for (faded, colour) in faded.iter_mut().zip(colours) {
        *faded = mixed(*colour, to, part);
    }
}

/// Fades one palette into another, as [`fade`] does.
pub fn cross_fade(from: &[[u8; 3]], to: &[[u8; 3]], part: u16, faded: &mut [[u8; 3]]) {
    for ((faded, from), to) in faded.iter_mut().zip(from).zip(to) {
        *faded = mixed(*from, *to, part);
    }
}

const fn max(a: u8, b: u8) -> u8 {
    if a > b { a } else { b }
}

#[cfg(test)]
mod tests {
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
}
