//! `embedded-graphics` over a band: text, shapes and images in 2D on what is drawn in 3D.

use core::convert::Infallible;

use embedded_graphics_core::Pixel;
use embedded_graphics_core::draw_target::DrawTarget;
use embedded_graphics_core::geometry::{Dimensions, Point, Size};
use embedded_graphics_core::pixelcolor::raw::RawU8;
use embedded_graphics_core::pixelcolor::{
    BinaryColor, Gray8, PixelColor, Rgb565, Rgb888, RgbColor,
};
use embedded_graphics_core::primitives::Rectangle;

use crate::frame::Target;
use crate::palette::Palette;

/// A palette entry as a colour, for those who know which it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PaletteIndex(pub u8);

impl PixelColor for PaletteIndex {
    type Raw = RawU8;
}

/// A colour that a palette has something for.
pub trait Ink: PixelColor {
    /// The palette's index for it.
    fn index(self, palette: &Palette<'_>) -> u8;
}

impl Ink for PaletteIndex {
    fn index(self, _: &Palette<'_>) -> u8 {
        let Self(index) = self;
        index
    }
}

/// The nearest entry.
macro_rules! nearest {
    ($($colour:ty),*) => {$(
        impl Ink for $colour {
            fn index(self, palette: &Palette<'_>) -> u8 {
                let colour = Rgb888::from(self);
                palette.nearest([colour.r(), colour.g(), colour.b()])
            }
        }
    )*};
}

nearest!(Rgb888, Rgb565, Gray8, BinaryColor);

/// A band to draw on, in the frame's columns and rows: of what is drawn, the part that lies in
/// the band appears. Draw the same for each band, as
/// [`Bands::next_target`](crate::render::Bands::next_target) gives them. Depths stay as they
/// are.
///
/// ```
/// use embedded_graphics_core::prelude::*;
/// use embedded_graphics_core::{pixelcolor::Rgb888, primitives::Rectangle};
/// use fixel::{Band, display::Overlay, palette::Palette};
///
/// let (mut indices, mut depths) = ([0; 8], [0; 8]);
/// let mut band = Band::new(4, &mut indices, &mut depths)?;
/// // Rows 2 and 3 of the frame.
/// let mut rows = band.target(2, 4);
/// let palette = Palette::new(&[[0, 0, 0], [250, 0, 0], [0, 0, 250]]);
/// let mut overlay = Overlay::new(&mut rows, palette);
/// let part = Rectangle::new(Point::new(1, 0), Size::new(2, 3));
/// overlay.fill_solid(&part, Rgb888::RED).unwrap();
/// assert_eq!(rows.indices, [0, 1, 1, 0, 0, 0, 0, 0]);
/// # Ok::<(), fixel::frame::BandError>(())
/// ```
#[derive(Debug)]
pub struct Overlay<'a, 'b, C = Rgb888> {
    target: &'a mut Target<'b>,
    palette: Palette<'a>,
    /// The colour that was asked for last, and its index: looking for the nearest entry
    /// takes some thousand instructions.
    known: Option<(C, u8)>,
}

impl<'a, 'b, C: Ink> Overlay<'a, 'b, C> {
    /// Over a band, or a viewport's part of one; colours become the palette's.
    pub fn new(target: &'a mut Target<'b>, palette: Palette<'a>) -> Self {
        Self {
            target,
            palette,
            known: None,
        }
    }

    fn index(&mut self, colour: C) -> u8 {
        match self.known {
            Some((known, index)) if known == colour => index,
            _ => {
                let index = colour.index(&self.palette);
                self.known = Some((colour, index));
                index
            }
        }
    }

    /// The pixels of a row from column `left` on, at most `width`: those that there are.
    fn row(&mut self, y: i32, left: i32, width: u32) -> &mut [u8] {
        let (columns, stride) = (
            i32::from(self.target.width),
            usize::from(self.target.stride),
        );
        let right = i64::from(left) + i64::from(width);
        let (left, right) = (
            left.clamp(0, columns),
            right.clamp(0, columns.into()) as i32,
        );
        let rows = i32::from(self.target.top)..i32::from(self.target.end);
        if !rows.contains(&y) || left >= right {
            return &mut [];
        }
        let start = (y - rows.start) as usize * stride;
        let pixels = start + left as usize..start + right as usize;
        self.target.indices.get_mut(pixels).unwrap_or_default()
    }
}

impl<C> Dimensions for Overlay<'_, '_, C> {
    fn bounding_box(&self) -> Rectangle {
        let (top, end) = (self.target.top, self.target.end);
        Rectangle::new(
            Point::new(0, top.into()),
            Size::new(self.target.width.into(), end.saturating_sub(top).into()),
        )
    }
}

impl<C: Ink> DrawTarget for Overlay<'_, '_, C> {
    type Color = C;
    type Error = Infallible;

    fn draw_iter<I>(&mut self, pixels: I) -> Result<(), Infallible>
    where
        I: IntoIterator<Item = Pixel<C>>,
    {
        for Pixel(place, colour) in pixels {
            if self.row(place.y, place.x, 1).is_empty() {
                continue;
            }
            let index = self.index(colour);
            self.row(place.y, place.x, 1).fill(index);
        }
        Ok(())
    }

    fn fill_solid(&mut self, area: &Rectangle, colour: C) -> Result<(), Infallible> {
        let index = self.index(colour);
        let top = i32::from(self.target.top).max(area.top_left.y);
        let bottom = i64::from(area.top_left.y) + i64::from(area.size.height);
        let bottom = bottom.min(i64::from(self.target.end)) as i32;
        for y in top..bottom {
            self.row(y, area.top_left.x, area.size.width).fill(index);
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests;
