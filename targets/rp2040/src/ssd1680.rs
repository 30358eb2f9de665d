//! SSD1680: e-paper of 2.9 inches, 296x128 when it lies on its side, black and white.

use embedded_hal::delay::DelayNs;
use embedded_hal::digital::{InputPin, OutputPin};
use fixel::display::{Packing, PartialRows};
use rp2040_hal::Timer;

use crate::Waited;
use crate::link::Link;

/// What SPI clock the panel takes, in Hz.
pub const RATE: u32 = 10_000_000;
/// Columns and rows.
pub const SIZE: (u16, u16) = (296, 128);
/// Bytes of 8 rows.
pub const PAGE: usize = Packing::Pages.bytes(SIZE.0);
const PAGES: usize = SIZE.1 as usize / 8;
/// After so many changes of a part, everything is drawn anew, which takes the shadows away
/// that they leave.
const PARTIAL: u32 = 31;

const GATES: u8 = 0x01;
const ENTRY: u8 = 0x11;
const RESET: u8 = 0x12;
const SENSOR: u8 = 0x18;
const UPDATE: u8 = 0x20;
const UPDATE_STEPS: u8 = 0x22;
const NEW: u8 = 0x24;
const OLD: u8 = 0x26;
const BORDER: u8 = 0x3C;
const X_RANGE: u8 = 0x44;
const Y_RANGE: u8 = 0x45;
const X: u8 = 0x4E;
const Y: u8 = 0x4F;

/// Addresses go along y, which counts up, then to the next lower x. A byte holds 8 pixels
/// along x, the first in its highest bit. So if the panel's y goes to the right and its x up,
/// bytes are as [`Packing::Pages`] has them.
const ALONG_Y: u8 = 0b110;
/// The waveform that draws every pixel, black and white in turns.
const WHOLE: u8 = 0xF7;
/// The one that only moves pixels that are not in the old picture as in the new one.
const CHANGES: u8 = 0xFF;

/// A panel, and the picture that it shows, which its controller wants again after each change.
pub struct Ssd1680<'a, B> {
    link: Link,
    busy: B,
    timer: Timer,
    waited: &'a Waited,
    shown: &'a mut [[u8; PAGE]; PAGES],
    /// Changes since everything was drawn; none yet if there is no number.
    changes: Option<u32>,
}

impl<'a, B: InputPin> Ssd1680<'a, B> {
    /// Resets a panel. What it shows stays until the first [`Ssd1680::update`].
    pub fn new(
        link: Link,
        reset: &mut impl OutputPin,
        busy: B,
        mut timer: Timer,
        shown: &'a mut [[u8; PAGE]; PAGES],
        waited: &'a Waited,
    ) -> Self {
        let mut panel = Self {
            link,
            busy,
            timer,
            waited,
            shown,
            changes: None,
        };
        let _ = reset.set_low();
        timer.delay_ms(1);
        let _ = reset.set_high();
        panel.wait();
        panel.link.command(RESET, &[]);
        panel.wait();
        let [low, high] = (SIZE.0 - 1).to_le_bytes();
        panel.link.command(GATES, &[low, high, 0]);
        panel.link.command(ENTRY, &[ALONG_Y]);
        panel.link.command(BORDER, &[0x05]);
        panel.link.command(SENSOR, &[0x80]);
        panel
    }

    /// Whether the next update draws everything, for which the whole picture is to be sent.
    pub fn is_whole_next(&self) -> bool {
        self.changes.is_none_or(|changes| changes >= PARTIAL)
    }

    /// Shows what was sent.
    pub fn update(&mut self) {
        let whole = self.is_whole_next();
        let steps = if whole { WHOLE } else { CHANGES };
        self.link.command(UPDATE_STEPS, &[steps]);
        self.link.command(UPDATE, &[]);
        self.wait();
        self.changes = Some(if whole {
            0
        } else {
            self.changes.unwrap_or(0) + 1
        });
        window(&mut self.link, 0, 0, PAGES as u8 - 1);
        self.link.begin(OLD);
        for page in self.shown.iter() {
            self.link.write(page);
        }
        self.link.end();
    }

    /// Waits for the panel, which takes its time to say that it is busy.
    fn wait(&mut self) {
        self.timer.delay_ms(1);
        while self.busy.is_high().unwrap_or(false) {}
    }
}

/// Where the next bytes go: from column `first` of a page on, to the end of page `last`.
fn window(link: &mut Link, first: u16, page: u8, last: u8) {
    // Pages are counted down in the panel's x.
    let x = |page: u8| (PAGES as u8 - 1).saturating_sub(page);
    link.command(X_RANGE, &[x(page), x(last)]);
    let ([a, b], [c, d]) = (first.to_le_bytes(), (SIZE.0 - 1).to_le_bytes());
    link.command(Y_RANGE, &[a, b, c, d]);
    link.command(X, &[x(page)]);
    link.command(Y, &[a, b]);
}

impl<B: InputPin> PartialRows for Ssd1680<'_, B> {
    type Error = core::convert::Infallible;

    fn part(&mut self, y: u16, first: u16, bytes: &[u8]) -> Result<(), Self::Error> {
        let Self {
            link,
            waited,
            shown,
            ..
        } = self;
        let page = y / 8;
        let kept = shown.get_mut(usize::from(page));
        let kept = kept.and_then(|page| page.get_mut(usize::from(first)..));
        for (kept, byte) in kept.unwrap_or_default().iter_mut().zip(bytes) {
            *kept = *byte;
        }
        waited.during(|| {
            window(link, first, page as u8, page as u8);
            link.begin(NEW);
            link.write(bytes);
            link.end();
        });
        Ok(())
    }
}
