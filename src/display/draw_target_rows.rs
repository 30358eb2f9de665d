//! Rows of RGB565 on any `embedded-graphics` display of that colour.

use embedded_graphics_core::draw_target::DrawTarget;
use embedded_graphics_core::geometry::{Point, Size};
use embedded_graphics_core::pixelcolor::Rgb565;
use embedded_graphics_core::pixelcolor::raw::RawU16;
use embedded_graphics_core::primitives::Rectangle;

use super::Rgb565Rows;

/// Shows the rows of a [`Resolve`](super::Resolve) on a [`DrawTarget`].
#[derive(Debug)]
pub struct DrawTargetRows<D> {
    target: D,
    origin: Point,
}

impl<D: DrawTarget<Color = Rgb565>> DrawTargetRows<D> {
    /// Draws with the picture's top left corner at `origin` of `target`.
    pub fn new(target: D, origin: Point) -> Self {
        Self { target, origin }
    }

    /// The display itself, to draw over the frame.
    pub fn target(&mut self) -> &mut D {
        &mut self.target
    }
}

impl<D: DrawTarget<Color = Rgb565>> Rgb565Rows for DrawTargetRows<D> {
    type Error = D::Error;

    fn row(&mut self, y: u16, pixels: &[u16]) -> Result<(), D::Error> {
        let corner = self.origin + Point::new(0, y.into());
        let size = Size::new(pixels.len() as u32, 1);
        let native = pixels.iter().map(|pixel| u16::from_be(*pixel));
        let colours = native.map(|pixel| Rgb565::from(RawU16::new(pixel)));
        self.target
            .fill_contiguous(&Rectangle::new(corner, size), colours)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use core::convert::Infallible;
    use embedded_graphics_core::Pixel;
    use embedded_graphics_core::geometry::OriginDimensions;
    use embedded_graphics_core::prelude::RgbColor;
    use std::vec::Vec;

    #[derive(Default)]
    struct Panel(Vec<(Point, Rgb565)>);

    impl OriginDimensions for Panel {
        fn size(&self) -> Size {
            Size::new(16, 16)
        }
    }

    impl DrawTarget for Panel {
        type Color = Rgb565;
        type Error = Infallible;

        fn draw_iter<I: IntoIterator<Item = Pixel<Rgb565>>>(
            &mut self,
            pixels: I,
        ) -> Result<(), Infallible> {
            self.0.extend(pixels.into_iter().map(|p| (p.0, p.1)));
            Ok(())
        }
    }

    #[test]
    fn rows_land_where_they_belong() {
        let mut rows = DrawTargetRows::new(Panel::default(), Point::new(3, 4));
        let colours = [[255, 0, 0], [0, 0, 255]].map(crate::palette::rgb565);
        let Ok(()) = rows.row(2, &colours.map(u16::to_be));
        let wanted = [
            (Point::new(3, 6), Rgb565::RED),
            (Point::new(4, 6), Rgb565::BLUE),
        ];
        assert_eq!(rows.target().0, wanted);
    }
}
