//! SSD1306: an OLED of 128x64, black and white, in pages of 8 rows.

use embedded_hal::delay::DelayNs;
use embedded_hal::digital::OutputPin;
use fixel::display::PackedRows;
use rp2040_hal::Timer;

use crate::Waited;
use crate::link::Link;

/// What SPI clock the panel takes, in Hz.
pub const RATE: u32 = 10_000_000;
/// Columns and rows.
pub const SIZE: (u16, u16) = (128, 64);

const COLUMNS: u8 = 0x21;
const PAGES: u8 = 0x22;

/// Everything until the picture is on, as the data sheet has it for glass of 64 rows whose
/// connector is at the top.
const START: [u8; 26] = [
    0xAE, // off
    0xD5, 0x80, // clock
    0xA8, 0x3F, // 64 rows
    0xD3, 0x00, // from the first one on
    0x40, // whose data are the first
    0x8D, 0x14, // charge pump on
    0x20, 0x00, // addresses go along a page, then to the next one
    0xA1, 0xC8, // seen from the other side
    0xDA, 0x12, // rows alternate between the sides
    0x81, 0xCF, // contrast
    0xD9, 0xF1, // precharge
    0xDB, 0x40, // deselect level
    0xA4, 0xA6, // what is in memory, 1 is white
    0x2E, // no scrolling
    0xAF, // on
];

/// A panel.
pub struct Ssd1306<'a> {
    link: Link,
    waited: &'a Waited,
}

impl<'a> Ssd1306<'a> {
    /// Resets a panel and switches it on.
    pub fn new(
        mut link: Link,
        reset: &mut impl OutputPin,
        timer: &mut Timer,
        waited: &'a Waited,
    ) -> Self {
        let _ = reset.set_low();
        timer.delay_us(20);
        let _ = reset.set_high();
        timer.delay_us(20);
        for byte in START {
            link.command(byte, &[]);
        }
        Self { link, waited }
    }
}

impl PackedRows for Ssd1306<'_> {
    type Error = core::convert::Infallible;

    fn rows(&mut self, y: u16, bytes: &[u8]) -> Result<(), Self::Error> {
        let Self { link, waited } = self;
        let page = (y / 8) as u8;
        waited.during(|| {
            for byte in [COLUMNS, 0, 127, PAGES, page, 7] {
                link.command(byte, &[]);
            }
            link.data(bytes);
        });
        Ok(())
    }
}
