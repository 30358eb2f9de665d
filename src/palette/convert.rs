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
mod tests;
