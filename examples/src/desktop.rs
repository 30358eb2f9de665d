//! The examples on the desktop: panels in memory, and what each example shows over time.

extern crate std;

use std::convert::Infallible;
use std::vec::Vec;

use embedded_graphics::pixelcolor::{BinaryColor, Rgb565, Rgb888};
use embedded_graphics::prelude::*;
use fixel::display::PackedRows;
use fixel::math::Angle;
use fixel::{DrawTargetDisplay, SceneError};

use crate::{
    Animated, Attitude, Clock, Dashboard, Epaper, GLOBE, HEAT_MAP, HELLO_TRIANGLE, Reading,
    SPINNING_LOGO,
};

/// A panel's pixels, by rows.
#[derive(Debug)]
pub struct Panel<C> {
    size: Size,
    pixels: Vec<C>,
}

/// What a panel shows: its size, and red, green and blue of each pixel, by rows.
pub type Picture = (Size, Vec<[u8; 3]>);

/// An example.
#[derive(Clone, Copy, Debug)]
pub struct Example {
    /// What it is called.
    pub name: &'static str,
    /// Frames after which it starts again.
    pub frames: u32,
    /// Draws one of them.
    pub draw: fn(u32) -> Result<Picture, SceneError>,
}

impl Example {
    /// The frame that shows it best.
    pub const fn shown(&self) -> u32 {
        self.frames / 8
    }
}

/// All of them.
pub const EXAMPLES: [Example; 8] = [
    example("hello_triangle", 60, |frame| {
        animated::<240>(HELLO_TRIANGLE, frame)
    }),
    example("spinning_logo", 90, |frame| {
        animated::<320>(SPINNING_LOGO, frame)
    }),
    example("attitude", 120, attitude),
    example("clock", 80, clock),
    example("heat_map", 120, |frame| animated::<320>(HEAT_MAP, frame)),
    example("globe", 120, |frame| animated::<240>(GLOBE, frame)),
    example("epaper", 1, epaper),
    example("dashboard", 96, dashboard),
];

const fn example(
    name: &'static str,
    frames: u32,
    draw: fn(u32) -> Result<Picture, SceneError>,
) -> Example {
    Example { name, frames, draw }
}

fn animated<const WIDTH: usize>(scene: &'static [u8], frame: u32) -> Result<Picture, SceneError> {
    let mut panel = on::<Rgb565>(WIDTH as u32, 240);
    let Ok(()) = Animated::<WIDTH>::new(scene)?.draw(frame, &mut panel);
    Ok(panel.release().picture())
}

/// A gentle turn to the left and back, as a gyroscope would tell it.
fn attitude(frame: u32) -> Result<Picture, SceneError> {
    let wave = |turns| Angle::fraction(frame * turns, 120).sin_cos().0;
    let angle = |wave: i32, sixteenths: i32| Angle::from_bits((wave / 16 * sixteenths) as u32);
    let (pitch, roll, heading) = (wave(2), wave(1), wave(1));
    let angles = [angle(pitch, 3), angle(roll, 6), angle(heading, 4)];
    let mut panel = on::<Rgb565>(240, 240);
    let Ok(()) = Attitude::new()?.draw(angles, &mut panel);
    Ok(panel.release().picture())
}

/// Half a second a frame, from nine minutes past ten on.
fn clock(frame: u32) -> Result<Picture, SceneError> {
    let mut panel = on::<BinaryColor>(128, 64);
    let second = 10 * 3600 + 9 * 60 + frame / 2;
    let Ok(()) = Clock::new()?.draw(second, "1 March", &mut panel);
    Ok(panel.release().picture())
}

fn epaper(_: u32) -> Result<Picture, SceneError> {
    let mut panel = Panel::<BinaryColor>::new(200, 200);
    let Ok(()) = Epaper::new()?.draw(&mut panel);
    Ok(panel.picture())
}

/// A wheel of 24 teeth that turns by a tooth in 4 frames.
fn dashboard(frame: u32) -> Result<Picture, SceneError> {
    let wave = Angle::fraction(frame, 96).sin_cos().0;
    let around = |middle: i32, reach: i32| (middle + (wave >> 16) * reach / (1 << 14)) as u32;
    let reading = Reading {
        turn: Angle::fraction(frame, 96),
        speed: around(1480, 60),
        oil: around(86, 2),
        load: around(64, 12),
    };
    let mut panel = on::<Rgb565>(320, 240);
    let Ok(()) = Dashboard::new()?.draw(&reading, &mut panel);
    Ok(panel.release().picture())
}

fn on<C: PixelColor + From<Rgb888>>(width: u32, height: u32) -> DrawTargetDisplay<Panel<C>> {
    DrawTargetDisplay::new(Panel::new(width, height), Point::zero())
}

impl<C: PixelColor + From<Rgb888>> Panel<C> {
    fn new(width: u32, height: u32) -> Self {
        let black = Rgb888::BLACK.into();
        Self {
            size: Size::new(width, height),
            pixels: std::vec![black; (width * height) as usize],
        }
    }
}

impl<C: PixelColor + Into<Rgb888>> Panel<C> {
    fn picture(&self) -> Picture {
        let colours = self.pixels.iter().map(|colour| (*colour).into());
        let channels = colours.map(|colour: Rgb888| [colour.r(), colour.g(), colour.b()]);
        (self.size, channels.collect())
    }
}

impl<C> OriginDimensions for Panel<C> {
    fn size(&self) -> Size {
        self.size
    }
}

impl<C: PixelColor> DrawTarget for Panel<C> {
    type Color = C;
    type Error = Infallible;

    fn draw_iter<I>(&mut self, pixels: I) -> Result<(), Infallible>
    where
        I: IntoIterator<Item = Pixel<C>>,
    {
        let area = self.bounding_box();
        for Pixel(place, colour) in pixels {
            if area.contains(place) {
                let row = place.y as usize * self.size.width as usize;
                self.pixels[row + place.x as usize] = colour;
            }
        }
        Ok(())
    }
}

impl PackedRows for &mut Panel<BinaryColor> {
    type Error = Infallible;

    fn rows(&mut self, y: u16, bytes: &[u8]) -> Result<(), Infallible> {
        let width = self.size.width as usize;
        let row = self.pixels[usize::from(y) * width..].iter_mut().take(width);
        for (x, pixel) in row.enumerate() {
            *pixel = BinaryColor::from(bytes[x / 8] << (x % 8) & 0x80 != 0);
        }
        Ok(())
    }
}
