//! A text's pixels, as embedded-graphics draws them.

use embedded_graphics::draw_target::DrawTarget;
use embedded_graphics::geometry::{OriginDimensions, Size};
use embedded_graphics::mono_font::{MonoFont, MonoTextStyle, iso_8859_1};
use embedded_graphics::pixelcolor::BinaryColor;
use embedded_graphics::prelude::Point;
use embedded_graphics::text::{Baseline, Text};
use embedded_graphics::{Drawable, Pixel};
use fixel_scene::{Anchor, Font, Side};

/// Collects what is drawn.
struct Sheet(Vec<[i64; 2]>);

impl OriginDimensions for Sheet {
    fn size(&self) -> Size {
        Size::new(1 << 16, 1 << 16)
    }
}

impl DrawTarget for Sheet {
    type Color = BinaryColor;
    type Error = std::convert::Infallible;

    fn draw_iter<I: IntoIterator<Item = Pixel<BinaryColor>>>(
        &mut self,
        pixels: I,
    ) -> Result<(), Self::Error> {
        let on = pixels.into_iter().filter(|Pixel(_, colour)| colour.is_on());
        self.0
            .extend(on.map(|Pixel(at, _)| [at.x.into(), at.y.into()]));
        Ok(())
    }
}

/// What has to be added to the point, rounded down, for the box's corner; and the
/// pixels that are on, from that corner.
pub(crate) fn letters(text: &str, font: Font, anchor: Anchor) -> ([f64; 2], Vec<[i64; 2]>) {
    let font: &MonoFont<'_> = match font {
        Font::F4x6 => &iso_8859_1::FONT_4X6,
        Font::F5x8 => &iso_8859_1::FONT_5X8,
        Font::F6x10 => &iso_8859_1::FONT_6X10,
        Font::F7x13 => &iso_8859_1::FONT_7X13,
        Font::F9x15 => &iso_8859_1::FONT_9X15,
        Font::F10x20 => &iso_8859_1::FONT_10X20,
    };
    let style = MonoTextStyle::new(font, BinaryColor::On);
    let mut sheet = Sheet(Vec::new());
    let drawn = Text::with_baseline(text, Point::zero(), style, Baseline::Top).draw(&mut sheet);
    let Ok(_) = drawn;
    let columns = text.split('\n').map(|line| line.chars().count()).max();
    let size = [
        columns.unwrap_or(0) as u32 * font.character_size.width,
        text.split('\n').count() as u32 * font.character_size.height,
    ];
    let sides = [anchor.horizontal, anchor.vertical];
    let corner = [0, 1].map(|axis| {
        -f64::from(match sides[axis] {
            Side::Start => 0,
            Side::Middle => size[axis] / 2,
            Side::End => size[axis],
        })
    });
    (corner, sheet.0)
}
