//! No board at all: QEMU, whose first picture becomes `frame.ppm`, after which it ends. Put
//! your own display here: all that is a `DrawTarget` will do.

use embedded_graphics::pixelcolor::{Rgb565, Rgb888};
use embedded_graphics::prelude::*;
use semihosting::io::{Error, Write};
use semihosting::{fs::File, process};

pub const WIDTH: usize = 240;
const HEIGHT: usize = 240;

pub fn display() -> Panel {
    let mut file = File::create(c"frame.ppm").unwrap();
    file.write_all(b"P6 240 240 255\n").unwrap();
    Panel { file, row: [[0; 3]; WIDTH], pixels: 0 }
}

/// Pixels come from the left to the right and from the top to the bottom.
pub struct Panel {
    file: File,
    row: [[u8; 3]; WIDTH],
    pixels: usize,
}

impl OriginDimensions for Panel {
    fn size(&self) -> Size {
        Size::new(WIDTH as u32, HEIGHT as u32)
    }
}

impl DrawTarget for Panel {
    type Color = Rgb565;
    type Error = Error;

    fn draw_iter<I>(&mut self, pixels: I) -> Result<(), Error>
    where
        I: IntoIterator<Item = Pixel<Rgb565>>,
    {
        for Pixel(_, colour) in pixels {
            let colour = Rgb888::from(colour);
            self.row[self.pixels % WIDTH] = [colour.r(), colour.g(), colour.b()];
            self.pixels += 1;
            if self.pixels % WIDTH == 0 {
                self.file.write_all(self.row.as_flattened())?;
            }
            if self.pixels == WIDTH * HEIGHT {
                process::exit(0);
            }
        }
        Ok(())
    }
}
