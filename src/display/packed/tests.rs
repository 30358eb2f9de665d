use super::*;
use crate::display::{Diffused, Nearest, Ordered};
use core::convert::Infallible;
use std::vec::Vec;

#[derive(Default)]
struct Bytes(Vec<(u16, Vec<u8>)>);

impl PackedRows for Bytes {
    type Error = Infallible;

    fn rows(&mut self, y: u16, bytes: &[u8]) -> Result<(), Infallible> {
        self.0.push((y, bytes.to_vec()));
        Ok(())
    }
}

fn greys() -> Vec<[u8; 3]> {
    (0..=255).map(|grey| [grey; 3]).collect()
}

/// A picture of greys, in bands of so many rows.
fn packed(
    packing: Packing,
    dither: impl Dither,
    width: u16,
    band: usize,
    picture: &[u8],
) -> Vec<(u16, Vec<u8>)> {
    let depths = std::vec![0; picture.len()];
    let height = (picture.len() / usize::from(width)) as u16;
    let mut bytes = [0x77; 64];
    let mut display = Packed::new(packing, height, dither, &mut bytes, Bytes::default());
    let Ok(()) = display.begin(&Palette::new(&greys()));
    let pixels = band * usize::from(width);
    for (number, indices) in picture.chunks(pixels).enumerate() {
        let Ok(()) = display.show(BandRows {
            indices,
            depths: &depths[..indices.len()],
            width,
            top: (number * band) as u16,
        });
    }
    core::mem::take(&mut display.rows().0)
}

#[test]
fn rows_begin_a_byte_and_the_left_pixel_is_highest() {
    let picture = [255, 0, 0, 255, 0, 0, 0, 255, 0, 255];
    let found = packed(Packing::Rows1, Nearest, 10, 1, &picture);
    assert_eq!(found, [(0, [0b1001_0001, 0b0100_0000].to_vec())]);
    let found = packed(Packing::Rows2, Nearest, 5, 1, &[0, 85, 170, 255, 85]);
    assert_eq!(found, [(0, [0b0001_1011, 0b0100_0000].to_vec())]);
    let found = packed(Packing::Rows4, Nearest, 3, 1, &[17, 34, 255, 0, 255, 0]);
    assert_eq!(
        found,
        [(0, [0x12, 0xf0].to_vec()), (1, [0x0f, 0x00].to_vec())]
    );
}

#[test]
fn pages_have_eight_rows_and_the_top_one_is_lowest() {
    // Two columns, ten rows: the left one white in rows 0, 7 and 9, the right one in row 1.
    let mut picture = [0; 20];
    for pixel in [0, 2 * 7, 2 * 9, 2 + 1] {
        picture[pixel] = 255;
    }
    for band in 1..=10 {
        let found = packed(Packing::Pages, Nearest, 2, band, &picture);
        let pages = [(0, [0b1000_0001, 2].to_vec()), (8, [2, 0].to_vec())];
        assert_eq!(found, pages, "bands of {band}");
    }
}

#[test]
fn bytes_do_not_depend_on_the_bands_and_unpack_to_levels() {
    let (width, height) = (37u16, 24);
    let picture: Vec<u8> = (0..usize::from(width) * height)
        .map(|i| (i * 7 % 256) as u8)
        .collect();
    for packing in [
        Packing::Rows1,
        Packing::Rows2,
        Packing::Rows4,
        Packing::Pages,
    ] {
        let diffused = |band| {
            let mut errors = [3; 37];
            packed(packing, Diffused::new(&mut errors), width, band, &picture)
        };
        for band in [2, 5, 8, 24] {
            assert_eq!(diffused(1), diffused(band), "bands of {band}");
        }
        let found = packed(packing, Ordered::BAYER8, width, 24, &picture);
        let mut dither = Ordered::BAYER8;
        for (y, row) in (0u16..).zip(picture.chunks(width.into())) {
            let most = packing.most();
            let tones = row.iter().map(|grey| crate::palette::tone(*grey, most));
            let of = |(top, _): &&(u16, Vec<u8>)| *top <= y;
            let (_, bytes) = found.iter().rev().find(of).unwrap();
            dither.row(y, most, tones, |x, level| {
                assert_eq!(packing.level(bytes, x, y), level);
            });
        }
    }
}
