//! Pixels of the window, and text on them.

use embedded_graphics::draw_target::DrawTarget;
use embedded_graphics::geometry::{OriginDimensions, Size};
use embedded_graphics::mono_font::{MonoFont, MonoTextStyle, iso_8859_1::FONT_7X13};
use embedded_graphics::pixelcolor::BinaryColor;
use embedded_graphics::prelude::Point;
use embedded_graphics::text::{Baseline, Text};
use embedded_graphics::{Drawable, Pixel};

/// The letters of all that is written.
const FONT: &MonoFont<'_> = &FONT_7X13;
/// Their width in pixels, at a scale of 1.
pub const LETTER: u32 = FONT.character_size.width;
/// From a line to the next.
pub const LINE: u32 = FONT.character_size.height + 3;

/// A colour: `0x00RRGGBB`, as windows take it.
pub type Colour = u32;

/// The colour of 8 bits a channel.
pub fn colour([red, green, blue]: [u8; 3]) -> Colour {
    u32::from_be_bytes([0, red, green, blue])
}

/// A rectangle of whole pixels; may reach beyond a canvas.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Rect {
    /// Left column.
    pub x: i32,
    /// Top row.
    pub y: i32,
    /// Columns.
    pub width: u32,
    /// Rows.
    pub height: u32,
}

impl Rect {
    /// Wider by so much on every side.
    pub fn grown(self, by: i32) -> Self {
        Self {
            x: self.x - by,
            y: self.y - by,
            width: self.width.saturating_add_signed(2 * by),
            height: self.height.saturating_add_signed(2 * by),
        }
    }
}

/// The window's pixels, by rows from the top left.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Canvas {
    /// Columns.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// Window pixels a pixel of a letter takes.
    pub scale: u32,
    /// Colours.
    pub pixels: Vec<Colour>,
}

impl Canvas {
    /// All of one colour.
    pub fn new([width, height]: [u32; 2], scale: u32, colour: Colour) -> Self {
        Self {
            width,
            height,
            scale,
            pixels: vec![colour; width as usize * height as usize],
        }
    }

    /// Fills what of a rectangle is on the canvas.
    pub fn fill(&mut self, rect: Rect, colour: Colour) {
        self.mix(rect, colour, 256);
    }

    /// Mixes in `part` of 256 of a colour.
    pub fn mix(&mut self, rect: Rect, colour: Colour, part: u32) {
        let ends = |start: i32, length: u32, most: u32| {
            let end = i64::from(start) + i64::from(length);
            let clamp = |v: i64| v.clamp(0, i64::from(most)) as usize;
            clamp(start.into())..clamp(end)
        };
        let columns = ends(rect.x, rect.width, self.width);
        for y in ends(rect.y, rect.height, self.height) {
            let start = y * self.width as usize;
            let row = self
                .pixels
                .get_mut(start + columns.start..start + columns.end);
            for pixel in row.into_iter().flatten() {
                *pixel = mixed(*pixel, colour, part);
            }
        }
    }

    /// Draws a picture, each pixel `zoom` wide and high.
    pub fn picture(&mut self, x: i32, y: i32, zoom: u32, width: u32, rgb: &[[u8; 3]]) {
        for (row, pixels) in (0..).zip(rgb.chunks(width.max(1) as usize)) {
            for (column, pixel) in (0..).zip(pixels) {
                let place = Rect {
                    x: x + column * zoom as i32,
                    y: y + row * zoom as i32,
                    width: zoom,
                    height: zoom,
                };
                self.fill(place, colour(*pixel));
            }
        }
    }

    /// Writes a line of text, its top left corner at a place.
    pub fn text(&mut self, x: i32, y: i32, colour: Colour, text: &str) {
        let scale = self.scale;
        let style = MonoTextStyle::new(FONT, BinaryColor::On);
        let mut sheet = Sheet {
            canvas: self,
            corner: [x, y],
            scale,
            colour,
        };
        let Ok(_) = Text::with_baseline(text, Point::zero(), style, Baseline::Top).draw(&mut sheet);
    }
}

fn mixed(below: Colour, above: Colour, part: u32) -> Colour {
    let channel = |shift: u32| {
        let (b, a) = (below >> shift & 255, above >> shift & 255);
        ((b * (256 - part) + a * part) >> 8) << shift
    };
    channel(16) | channel(8) | channel(0)
}

/// Where a text's pixels go.
struct Sheet<'a> {
    canvas: &'a mut Canvas,
    corner: [i32; 2],
    scale: u32,
    colour: Colour,
}

impl OriginDimensions for Sheet<'_> {
    fn size(&self) -> Size {
        Size::new(1 << 16, 1 << 16)
    }
}

impl DrawTarget for Sheet<'_> {
    type Color = BinaryColor;
    type Error = std::convert::Infallible;

    fn draw_iter<I: IntoIterator<Item = Pixel<BinaryColor>>>(
        &mut self,
        pixels: I,
    ) -> Result<(), Self::Error> {
        let scale = self.scale as i32;
        for Pixel(at, on) in pixels {
            if on.is_on() {
                let place = Rect {
                    x: self.corner[0] + at.x * scale,
                    y: self.corner[1] + at.y * scale,
                    width: self.scale,
                    height: self.scale,
                };
                self.canvas.fill(place, self.colour);
            }
        }
        Ok(())
    }
}

/// Cuts text into lines of at most so many letters, between words where it can.
pub fn wrapped(text: &str, most: usize) -> Vec<String> {
    let most = most.max(8);
    let mut lines: Vec<String> = Vec::new();
    for word in text.split_whitespace() {
        let mut word = word;
        loop {
            let room = match lines.last_mut() {
                Some(line) if line.chars().count() + 1 + word.chars().count() <= most => {
                    line.push(' ');
                    line.push_str(word);
                    break;
                }
                _ => most,
            };
            let cut = word
                .char_indices()
                .nth(room)
                .map_or(word.len(), |(at, _)| at);
            let (head, tail) = word.split_at(cut);
            lines.push(head.to_owned());
            if tail.is_empty() {
                break;
            }
            word = tail;
        }
    }
    lines
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_beyond_the_canvas_is_not_drawn() {
        let mut canvas = Canvas::new([4, 2], 1, 0);
        let rect = |x, y, width, height| Rect {
            x,
            y,
            width,
            height,
        };
        canvas.fill(rect(-1, 1, 3, 9), 7);
        assert_eq!(canvas.pixels, [0, 0, 0, 0, 7, 7, 0, 0]);
        canvas.fill(rect(4, 0, 3, 9), 7);
        canvas.fill(rect(9, 9, 1, 1), 7);
        assert_eq!(canvas.pixels, [0, 0, 0, 0, 7, 7, 0, 0]);
        canvas.mix(rect(0, 0, 1, 1), 0x00FF_0080, 128);
        assert_eq!(canvas.pixels[0], 0x007F_0040);
    }

    #[test]
    fn pixels_are_enlarged() {
        let mut canvas = Canvas::new([5, 3], 1, 9);
        canvas.picture(1, 1, 2, 2, &[[0, 0, 1], [0, 0, 2]]);
        let expected = [[9, 9, 9, 9, 9], [9, 1, 1, 2, 2], [9, 1, 1, 2, 2]];
        assert_eq!(canvas.pixels, expected.as_flattened());
    }

    #[test]
    fn text_is_written_at_its_scale() {
        let on = |scale| {
            let mut canvas = Canvas::new([200, 40], scale, 0);
            canvas.text(2, 2, 1, "Ag");
            canvas.pixels.iter().filter(|pixel| **pixel == 1).count()
        };
        assert!(on(1) > 20);
        assert_eq!(on(2), 4 * on(1));
    }

    #[test]
    fn lines_break_between_words() {
        assert_eq!(wrapped("one two  three", 8), ["one two", "three"]);
        assert_eq!(wrapped("abcdefghijkl m", 8), ["abcdefgh", "ijkl m"]);
        assert!(wrapped("", 8).is_empty());
    }
}
