use super::*;
use crate::palette::rgb565;
use crate::scene::Stereo;
use core::convert::Infallible;
use std::vec::Vec;

#[derive(Default)]
struct Rows(Vec<(u16, Vec<u16>)>);

impl Rgb565Rows for Rows {
    type Error = Infallible;

    fn row(&mut self, y: u16, pixels: &[u16]) -> Result<(), Infallible> {
        let native = pixels.iter().map(|p| u16::from_be(*p)).collect();
        self.0.push((y, native));
        Ok(())
    }
}

const COLOURS: [[u8; 3]; 4] = [[0, 0, 0], [255, 255, 255], [200, 0, 0], [0, 100, 48]];

/// Indices, `width` to a row of samples, given to the display in bands of `rows`.
fn resolved(output: Output, width: u16, rows: usize, indices: &[u8]) -> Vec<(u16, Vec<u16>)> {
    let depths = std::vec![0; indices.len()];
    let mut sums = [7; 8];
    let mut pixels = [0; 8];
    let mut display = Resolve::new(output, &mut sums, &mut pixels, Rows::default());
    let Ok(()) = display.begin(&Palette::new(&COLOURS));
    let band = usize::from(width) * rows;
    for (number, (indices, depths)) in indices.chunks(band).zip(depths.chunks(band)).enumerate() {
        let Ok(()) = display.show(BandRows {
            indices,
            depths,
            width,
            top: (number * rows) as u16,
        });
    }
    core::mem::take(&mut display.rows().0)
}

fn output(samples: [u8; 2], stereo: Stereo) -> Output {
    Output {
        samples,
        stereo,
        eye_slope: 0,
    }
}

#[test]
fn four_equal_samples_are_the_colour_itself() {
    for v in 0..=255u8 {
        for colour in [[v, 0, 255], [3, v, v], [v, 255, 0]] {
            let [r, g, b] = colour.map(|c| 4 * u32::from(c));
            assert_eq!(rgb565_of_sum(r << 20 | g << 10 | b), rgb565(colour));
        }
    }
}

#[test]
fn sums_are_rounded_to_nearest() {
    for sum in 0..=1020u32 {
        for (shift, most, got) in [
            (20, 31, rgb565_of_sum(sum << 20) >> 11),
            (10, 63, rgb565_of_sum(sum << 10) >> 5 & 63),
            (0, 31, rgb565_of_sum(sum) & 31),
        ] {
            let off = (i64::from(got) * 1020 - i64::from(sum * most)).abs();
            assert!(off <= 511, "{sum} << {shift}");
        }
    }
}

#[test]
fn samples_are_averaged_whatever_the_bands() {
    #[rustfmt::skip]
    let indices = [
        0, 0, 1, 2, 3, 3,
        0, 1, 1, 2, 3, 3,
        1, 1, 2, 2, 0, 3,
        1, 1, 2, 2, 0, 3,
    ];
    let wanted = [
        (
            0,
            [
                rgb565([64, 64, 64]),
                rgb565([228, 128, 128]),
                rgb565(COLOURS[3]),
            ]
            .to_vec(),
        ),
        (
            1,
            [rgb565(COLOURS[1]), rgb565(COLOURS[2]), rgb565([0, 50, 24])].to_vec(),
        ),
    ];
    for rows in 1..=4 {
        let found = resolved(output([2, 2], Stereo::None), 6, rows, &indices);
        assert_eq!(found, wanted, "bands of {rows}");
    }
    let across = resolved(output([2, 1], Stereo::None), 6, 2, &indices);
    assert_eq!(across.len(), 4);
    assert_eq!(across[0].1[0], rgb565(COLOURS[0]));
    let down = resolved(output([1, 2], Stereo::None), 6, 3, &indices);
    assert_eq!((down.len(), down[0].1[1]), (2, rgb565([128; 3])));
}

#[test]
fn the_left_eye_is_red() {
    // Left: white, black, red; right: black, white, green.
    let found = resolved(output([1, 1], Stereo::Anaglyph), 6, 1, &[1, 0, 2, 0, 1, 3]);
    let wanted = [[255, 0, 0], [0, 255, 255], [200, 100, 48]].map(rgb565);
    assert_eq!(found, [(0, wanted.to_vec())]);
    let fine = output([2, 1], Stereo::Anaglyph);
    let found = resolved(fine, 4, 1, &[1, 0, 3, 3, 0, 0, 1, 1]);
    assert_eq!(found[0].1, [rgb565([128, 100, 48])]);
    assert_eq!(found[1].1, [rgb565([0, 255, 255])]);
}
