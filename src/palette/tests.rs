use embedded_graphics_core::pixelcolor::{IntoStorage, Rgb565, Rgb888};

use super::{Palette, Rgb565Table, rgb565};

#[test]
fn rgb565_rounds_as_embedded_graphics_does() {
    for v in 0..=255 {
        for colour in [[v, 0, 0], [0, v, 0], [0, 0, v], [v, 255 - v, v / 2]] {
            let [r, g, b] = colour;
            let theirs = Rgb565::from(Rgb888::new(r, g, b)).into_storage();
            assert_eq!(rgb565(colour), theirs, "{colour:?}");
        }
    }
}

#[test]
fn pixels_leave_high_byte_first() {
    let mut table = Rgb565Table::new();
    table.set(&Palette {
        colours: &[[0, 0, 0], [255, 0, 0]],
    });
    let mut pixels = [0; 3];
    table.resolve(&[1, 0, 1], &mut pixels);
    assert_eq!(
        bytemuck::cast_slice::<u16, u8>(&pixels),
        [0xf8, 0, 0, 0, 0xf8, 0]
    );
}
