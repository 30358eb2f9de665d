use super::*;
use crate::palette::tone;
use std::vec::Vec;

fn rows(dither: &mut impl Dither, most: u8, tones: &[Tone], width: usize) -> Vec<u8> {
    let mut levels = Vec::new();
    for (y, row) in (0..).zip(tones.chunks(width)) {
        let mut out = std::vec![99; width];
        dither.row(y, most, row.iter().copied(), |x, level| out[x] = level);
        levels.extend(out);
    }
    levels
}

#[test]
fn the_nearest_level_is_the_nearest_value() {
    for most in [1u8, 3, 15] {
        let tones: Vec<Tone> = (0..=255).map(|grey| tone(grey, most)).collect();
        let found = rows(&mut Nearest, most, &tones, 256);
        for (grey, level) in (0u32..).zip(found) {
            let off = (i64::from(level) * 255 - i64::from(grey) * i64::from(most)).abs();
            assert!(off <= 128, "{grey} of {most}: {level}");
        }
    }
}

/// Of an even area, as much light as wanted.
#[test]
fn areas_have_the_light_of_their_tone() {
    let mut errors = [0; 64];
    for part in (0..=256).step_by(16) {
        for (most, level) in [(1, 0), (3, 2), (15, 7)] {
            let tones = [level * 256 + part; 64 * 64];
            let mean = |levels: Vec<u8>| {
                let sum: u32 = levels.into_iter().map(u32::from).sum();
                f64::from(sum) / 4096.0 * 256.0
            };
            let wanted = f64::from(level * 256 + part);
            for (dither, most_off) in [
                (Ordered::BAYER4, 0.0),
                (Ordered::BAYER8, 0.0),
                (Ordered::BLUE_NOISE, 0.5),
            ] {
                let mut dither = dither;
                let found = mean(rows(&mut dither, most, &tones, 64));
                assert!((found - wanted).abs() <= most_off, "{found} {wanted}");
            }
            let found = mean(rows(&mut Diffused::new(&mut errors), most, &tones, 64));
            // Some of it leaves at the sides.
            assert!((found - wanted).abs() <= 4.0, "{found} {wanted}");
        }
    }
}

#[test]
fn errors_go_where_floyd_and_steinberg_send_them() {
    // Two rows of five; only the middle one of the first has anything: 96 of 256, which
    // becomes black and leaves 42 (7/16), 18, 30 and the rest, 6.
    let mut errors = [7; 5];
    let mut dither = Diffused::new(&mut errors);
    let levels = rows(&mut dither, 1, &[0, 0, 96, 0, 0], 5);
    assert_eq!(levels, [0; 5]);
    // The right neighbour's 42 go on: 18 right, 7 back, 13 straight, 4 beyond; and the 18 of
    // its neighbour: 7 lost, 3 back, 5 straight.
    assert_eq!(errors, [0, 18, 30 + 7, 6 + 13 + 3, 4 + 5]);
}

#[test]
fn black_and_white_stay_clean() {
    for tone in [0, 256] {
        let tones = [tone; 64 * 64];
        let mut errors = [0; 64];
        let all = [
            rows(&mut Nearest, 1, &tones, 64),
            rows(&mut { Ordered::BAYER4 }, 1, &tones, 64),
            rows(&mut { Ordered::BAYER8 }, 1, &tones, 64),
            rows(&mut { Ordered::BLUE_NOISE }, 1, &tones, 64),
            rows(&mut Diffused::new(&mut errors), 1, &tones, 64),
        ];
        for levels in all {
            assert!(levels.iter().all(|l| u16::from(*l) << 8 == tone));
        }
    }
}
