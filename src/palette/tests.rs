use embedded_graphics_core::pixelcolor::{IntoStorage, Rgb565, Rgb888};

use super::{Cycle, Palette, Rgb565Table, rgb565};

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
    table.set(&Palette::new(&[[0, 0, 0], [255, 0, 0]]));
    let mut pixels = [0; 3];
    table.resolve(&[1, 0, 1], &mut pixels);
    assert_eq!(
        bytemuck::cast_slice::<u16, u8>(&pixels),
        [0xf8, 0, 0, 0, 0xf8, 0]
    );
}

#[test]
fn entries_go_round_within_their_range() {
    let colours: [[u8; 3]; 6] = core::array::from_fn(|i| [i as u8; 3]);
    let shown = |first, count, shift| {
        let cycle = Cycle {
            first,
            count,
            shift,
        };
        let palette = Palette {
            colours: &colours,
            cycle,
        };
        let mut table = Rgb565Table::new();
        table.set(&palette);
        let red = palette.entries().map(|[red, ..]| red);
        red.collect::<std::vec::Vec<u8>>()
    };
    assert_eq!(shown(0, 0, 3), [0, 1, 2, 3, 4, 5]);
    assert_eq!(shown(1, 4, 0), [0, 1, 2, 3, 4, 5]);
    assert_eq!(shown(1, 4, 1), [0, 2, 3, 4, 1, 5]);
    assert_eq!(shown(1, 4, 7), [0, 4, 1, 2, 3, 5]);
    assert_eq!(shown(0, 6, 6), [0, 1, 2, 3, 4, 5]);
}

#[test]
fn colours_of_consoles() {
    let of = super::bgr555;
    assert_eq!(of([255, 0, 0]), 0x001F);
    assert_eq!(of([0, 255, 0]), 0x03E0);
    assert_eq!(of([0, 0, 255]), 0x7C00);
    // 4.11 is a half of a 31st.
    assert_eq!(of([4, 5, 250]), 30 << 10 | 1 << 5);
}

#[test]
fn light_and_16_bits() {
    use super::{light_of_rgb565, rgb565_of_light};
    for v in 0..=255 {
        let fine = [v << 6; 3];
        let v = v as u8;
        assert_eq!(rgb565_of_light(fine), rgb565([v; 3]), "{v}");
    }
    for colour in 0..=u16::MAX {
        assert_eq!(rgb565_of_light(light_of_rgb565(colour)), colour);
    }
}
