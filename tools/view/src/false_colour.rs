//! Colours for what is no picture: depth, numbers, counts.

/// Where nothing is.
const NOTHING: [u8; 3] = [16, 20, 32];

/// Depth, the nearer the lighter, over the range of depths that are there.
pub fn depth(depths: &[u16]) -> Vec<[u8; 3]> {
    let there = || depths.iter().copied().filter(|d| *d != 0);
    let (far, near) = (there().min().unwrap_or(0), there().max().unwrap_or(0));
    let range = u32::from(near - far).max(1);
    let grey = |d: u16| (48 + u32::from(d - far) * 207 / range) as u8;
    let colour = |d: &u16| if *d == 0 { NOTHING } else { [grey(*d); 3] };
    depths.iter().map(colour).collect()
}

/// A colour for each number, as different as can be from its neighbours'.
pub fn numbers(numbers: impl Iterator<Item = Option<u32>>) -> Vec<[u8; 3]> {
    numbers.map(|n| n.map_or(NOTHING, number)).collect()
}

/// Hues by the golden ratio, with three lightnesses.
fn number(n: u32) -> [u8; 3] {
    let turn = n.wrapping_mul(0x9E37_79B9);
    let hue = f64::from(turn) / f64::from(u32::MAX) * 6.0;
    let light = [1.0, 0.72, 0.86][(n % 3) as usize];
    // Red, green and blue are the largest at hues 0, 2 and 4.
    [0.0, 2.0, 4.0].map(|middle| {
        let away = (hue - middle).abs().min(6.0 - (hue - middle).abs());
        let part = (2.0 - away).clamp(0.0, 1.0) * 0.75 + 0.25;
        (255.0 * light * part).round() as u8
    })
}

/// What counts look like: blue once, then green, yellow, red, and white from 8 on.
const COUNTS: [[u8; 3]; 9] = [
    NOTHING,
    [40, 80, 200],
    [20, 150, 160],
    [40, 180, 60],
    [190, 200, 40],
    [240, 150, 30],
    [235, 80, 30],
    [230, 30, 90],
    [255, 255, 255],
];

/// Counts, from blue to white.
pub fn counts(counts: &[u8]) -> Vec<[u8; 3]> {
    let colour = |n: &u8| COUNTS[usize::from(*n).min(COUNTS.len() - 1)];
    counts.iter().map(colour).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_nearest_is_the_lightest() {
        assert_eq!(
            depth(&[0, 100, 200, 150]),
            [NOTHING, [48; 3], [255; 3], [151; 3]]
        );
        assert_eq!(depth(&[0]), [NOTHING]);
        assert_eq!(depth(&[7]), [[48; 3]]);
    }

    #[test]
    fn neighbours_differ() {
        let colours = numbers((0..500).map(Some));
        for (i, colour) in colours.iter().enumerate() {
            for other in colours.iter().skip(i + 1).take(4) {
                let off = (0..3).map(|c| colour[c].abs_diff(other[c])).max();
                assert!(off > Some(40), "{i}: {colour:?}, {other:?}");
            }
        }
        assert_eq!(numbers([None].into_iter()), [NOTHING]);
    }

    #[test]
    fn many_are_white() {
        assert_eq!(counts(&[0, 8, 255]), [NOTHING, [255; 3], [255; 3]]);
    }
}
