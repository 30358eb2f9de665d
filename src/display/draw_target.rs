//! Any `embedded-graphics` display.

use embedded_graphics_core::Pixel;
use embedded_graphics_core::draw_target::DrawTarget;
use embedded_graphics_core::geometry::{Point, Size};
use embedded_graphics_core::pixelcolor::{PixelColor, Rgb888};
use embedded_graphics_core::primitives::Rectangle;

use super::Display;
use crate::frame::BandRows;
use crate::palette::Palette;

/// Shows frames on a [`DrawTarget`] whose colour can be made from RGB888. Rows
/// go out by `fill_contiguous`, so a panel's address window is set once a band.
#[derive(Debug)]
pub struct DrawTargetDisplay<D: DrawTarget> {
    target: D,
    origin: Point,
    colours: [Option<D::Color>; 256],
}

impl<D> DrawTargetDisplay<D>
where
    D: DrawTarget,
    D::Color: From<Rgb888> + PixelColor,
{
    /// Draws with the screen's top left corner at `origin` of `target`.
    pub fn new(target: D, origin: Point) -> Self {
        Self {
            target,
            origin,
            colours: [None; 256],
        }
    }

    /// The display itself, to draw over the frame.
    pub fn target(&mut self) -> &mut D {
        &mut self.target
    }

    /// Gives the display back.
    pub fn release(self) -> D {
        self.target
    }
}

impl<D> Display for DrawTargetDisplay<D>
where
    D: DrawTarget,
    D::Color: From<Rgb888> + PixelColor,
{
    type Error = D::Error;

    fn begin(&mut self, palette: &Palette<'_>) -> Result<(), D::Error> {
        for (slot, [r, g, b]) in self.colours.iter_mut().zip(palette.entries()) {
            *slot = Some(Rgb888::new(r, g, b).into());
        }
        Ok(())
    }

    fn show(&mut self, rows: BandRows<'_>) -> Result<(), D::Error> {
        let corner = self.origin + Point::new(0, i32::from(rows.top));
        let size = Size::new(u32::from(rows.width), u32::from(rows.rows()));
        let colours = &self.colours;
        let pixels = rows
            .indices
            .iter()
            .filter_map(|i| *colours.get(usize::from(*i))?);
        if size.width == 0 {
            return self
                .target
                .draw_iter(core::iter::empty::<Pixel<D::Color>>());
        }
        self.target
            .fill_contiguous(&Rectangle::new(corner, size), pixels)
    }
}
