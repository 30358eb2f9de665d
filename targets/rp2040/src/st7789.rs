//! ST7789: colour, RGB565, in the background by DMA.

use embedded_dma::ReadBuffer;
use embedded_hal::delay::DelayNs;
use embedded_hal::digital::OutputPin;
use fixel::display::Background;
use rp2040_hal::Timer;
use rp2040_hal::dma::single_buffer::{Config, Transfer};
use rp2040_hal::dma::{CH0, Channel};

use crate::board::Bus;
use crate::link::{Link, LinkPins};
use crate::{Waited, halt};

/// What SPI clock the panel takes, in Hz: a cycle of 16 ns at least.
pub const RATE: u32 = 62_500_000;

const SLEEP_OUT: u8 = 0x11;
const INVERT: u8 = 0x21;
const DISPLAY_ON: u8 = 0x29;
const COLUMNS: u8 = 0x2A;
const ROWS: u8 = 0x2B;
const WRITE: u8 = 0x2C;
const ORDER: u8 = 0x36;
const FORMAT: u8 = 0x3A;

/// The panel has 240 columns and up to 320 rows; on its side, columns and rows change places.
const COLUMNS_UPRIGHT: u16 = 240;
const UPRIGHT: u8 = 0;
const ON_ITS_SIDE: u8 = 0x60;
const RGB565: u8 = 0x55;

/// A panel, of which one part at a time may be on its way.
pub struct St7789<'a> {
    state: Option<State>,
    size: (u16, u16),
    waited: &'a Waited,
}

enum State {
    Idle(Link, Channel<CH0>),
    Sending(Transfer<Channel<CH0>, Part, Bus>, LinkPins),
}

/// The first pixels of a buffer, as bytes.
struct Part {
    pixels: &'static mut [u16],
    count: usize,
}

// SAFETY: the pixels stay where they are, and are nobody else's until the transfer gives the
// part back; the length is at most theirs.
unsafe impl ReadBuffer for Part {
    type Word = u8;

    unsafe fn read_buffer(&self) -> (*const u8, usize) {
        let count = self.count.min(self.pixels.len());
        (self.pixels.as_ptr().cast(), 2 * count)
    }
}

impl<'a> St7789<'a> {
    /// Resets a panel of so many columns and rows and switches it on; takes an eighth of a
    /// second.
    pub fn new(
        mut link: Link,
        channel: Channel<CH0>,
        reset: &mut impl OutputPin,
        timer: &mut Timer,
        size: (u16, u16),
        waited: &'a Waited,
    ) -> Self {
        let _ = reset.set_low();
        timer.delay_us(20);
        let _ = reset.set_high();
        timer.delay_ms(120);
        link.command(SLEEP_OUT, &[]);
        timer.delay_ms(5);
        link.command(FORMAT, &[RGB565]);
        let order = if size.0 > COLUMNS_UPRIGHT {
            ON_ITS_SIDE
        } else {
            UPRIGHT
        };
        link.command(ORDER, &[order]);
        // The glass is dark where no voltage is.
        link.command(INVERT, &[]);
        link.command(DISPLAY_ON, &[]);
        Self {
            state: Some(State::Idle(link, channel)),
            size,
            waited,
        }
    }
}

/// A range of columns or rows, both ends inclusive, as the panel takes it.
fn range(first: u16, last: u16) -> [u8; 4] {
    let ([a, b], [c, d]) = (first.to_be_bytes(), last.to_be_bytes());
    [a, b, c, d]
}

impl Background for St7789<'_> {
    type Buffer = &'static mut [u16];
    type Error = core::convert::Infallible;

    fn start(
        &mut self,
        top: u16,
        buffer: Self::Buffer,
        pixels: usize,
    ) -> Result<(), (Self::Error, Self::Buffer)> {
        let Some(State::Idle(mut link, channel)) = self.state.take() else {
            halt()
        };
        let (width, height) = self.size;
        link.command(COLUMNS, &range(0, width.saturating_sub(1)));
        // To the end of the screen: the panel stops where the pixels do.
        link.command(ROWS, &range(top, height.saturating_sub(1)));
        link.begin(WRITE);
        let part = Part {
            pixels: buffer,
            count: pixels,
        };
        let (bus, pins) = link.lend();
        let transfer = Config::new(channel, part, bus).start();
        self.state = Some(State::Sending(transfer, pins));
        Ok(())
    }

    fn wait(&mut self) -> Result<Self::Buffer, (Self::Error, Self::Buffer)> {
        let Some(State::Sending(transfer, pins)) = self.state.take() else {
            halt()
        };
        let (channel, part, link) = self.waited.during(|| {
            let (channel, part, bus) = transfer.wait();
            let mut link = Link::back(bus, pins);
            link.end();
            (channel, part, link)
        });
        self.state = Some(State::Idle(link, channel));
        Ok(part.pixels)
    }
}
