//! What lies outside of a band stays outside, whatever the bands.

use std::vec;
use std::vec::Vec;

use proptest::prelude::*;

use super::*;
use crate::frame::Band;

const WIDTH: u16 = 20;
const HEIGHT: u16 = 12;

/// A picture of two rectangles and some pixels, drawn in bands of so many rows.
fn picture(rows: u16, area: Rectangle, pixels: &[(i32, i32)]) -> Vec<u8> {
    let size = usize::from(WIDTH) * usize::from(rows);
    let (mut indices, mut depths) = (vec![0; size], vec![7; size]);
    let Ok(mut band) = Band::new(WIDTH, &mut indices, &mut depths) else {
        return Vec::new();
    };
    let colours = [[0, 0, 0], [200, 10, 10], [10, 10, 220]];
    let mut all = Vec::new();
    for top in (0..HEIGHT).step_by(rows.into()) {
        let mut target = band.target(top, HEIGHT.min(top + rows));
        target.clear(|_| 0);
        let mut overlay = Overlay::new(&mut target, Palette::new(&colours));
        let Ok(()) = overlay.fill_solid(&area, Rgb888::RED);
        let pixels = pixels
            .iter()
            .map(|(x, y)| Pixel(Point::new(*x, *y), Rgb888::BLUE));
        let Ok(()) = overlay.draw_iter(pixels);
        all.extend(target.finished().indices);
    }
    all
}

proptest! {
    #[test]
    fn bands_show_what_a_frame_would(
        rows in 1..=HEIGHT,
        corner in (-30..30, -30..30),
        size in (0..60u32, 0..60u32),
        pixels in prop::collection::vec((-5..25, -5..17), 0..20),
    ) {
        let area = Rectangle::new(Point::new(corner.0, corner.1), Size::new(size.0, size.1));
        let drawn = picture(rows, area, &pixels);
        prop_assert_eq!(drawn.len(), usize::from(WIDTH) * usize::from(HEIGHT));
        for (at, index) in drawn.iter().enumerate() {
            let (x, y) = ((at % usize::from(WIDTH)) as i32, (at / usize::from(WIDTH)) as i32);
            let wanted = if pixels.contains(&(x, y)) {
                2
            } else {
                u8::from(area.contains(Point::new(x, y)))
            };
            prop_assert_eq!(*index, wanted, "{} {}", x, y);
        }
    }
}

#[test]
fn the_largest_rectangles_do_not_overflow() {
    let far = Rectangle::new(
        Point::new(i32::MIN, i32::MIN),
        Size::new(u32::MAX, u32::MAX),
    );
    assert_eq!(picture(5, far, &[]), [1; 240]);
    let past = Rectangle::new(
        Point::new(i32::MAX, i32::MAX),
        Size::new(u32::MAX, u32::MAX),
    );
    assert_eq!(picture(5, past, &[]), [0; 240]);
}

#[test]
fn colours_become_the_nearest_entry() {
    let palette = Palette::new(&[[0, 0, 0], [255, 255, 255], [0, 200, 0], [0, 0, 200]]);
    assert_eq!(Rgb565::GREEN.index(&palette), 2);
    assert_eq!(Rgb888::new(10, 20, 190).index(&palette), 3);
    assert_eq!(BinaryColor::On.index(&palette), 1);
    assert_eq!(Gray8::new(20).index(&palette), 0);
    assert_eq!(PaletteIndex(9).index(&palette), 9);
}
