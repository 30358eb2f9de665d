//! What the firmware for the RP2040 shares.
//!
//! In: pins, clocks and a panel on SPI. Out: the demo's frames on it. [`board`] sets the chip
//! up, [`link`] talks to a panel's controller, one module each knows a controller, and
//! [`run`] is the loop.
#![no_std]

pub mod board;
pub mod link;
mod run;
pub mod ssd1306;
pub mod ssd1680;
pub mod st7789;
mod stopwatch;

pub use run::{Waited, run};
pub use stopwatch::Stopwatch;

/// The second stage of booting: sets the flash up, and jumps to the program.
#[unsafe(link_section = ".boot2")]
#[unsafe(no_mangle)]
#[used]
static FIXEL_BOOT2: [u8; 256] = rp2040_boot2::BOOT_LOADER_W25Q080;

/// Nothing more can be done.
pub fn halt() -> ! {
    loop {
        cortex_m::asm::wfi();
    }
}
