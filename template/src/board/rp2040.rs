//! A Raspberry Pi Pico, and an ST7789 of 240x240 on SPI0.

use core::fmt::Debug;

use cortex_m::singleton;
use embedded_graphics::pixelcolor::Rgb565;
use embedded_graphics::prelude::*;
use embedded_hal::spi::MODE_3;
use embedded_hal_bus::spi::ExclusiveDevice;
use mipidsi::interface::SpiInterface;
use mipidsi::options::ColorInversion;
use mipidsi::{Builder, models::ST7789};
use panic_halt as _;
use rp2040_hal::fugit::RateExtU32;
use rp2040_hal::gpio::{FunctionSpi, Pins};
use rp2040_hal::{Clock, Sio, Spi, Timer, Watchdog, clocks, pac};

/// Sets the flash chip up.
#[unsafe(link_section = ".boot2")]
#[used]
static BOOT2: [u8; 256] = rp2040_boot2::BOOT_LOADER_W25Q080;

pub const WIDTH: usize = 240;
const HEIGHT: u16 = 240;
const CRYSTAL_HZ: u32 = 12_000_000;

/// | GPIO | panel |
/// |---|---|
/// | 18 | SCL, SCK |
/// | 19 | SDA, MOSI |
/// | 16 | DC |
/// | 17 | CS |
/// | 21 | RES |
/// | 20 | BLK, the light |
pub fn display() -> impl DrawTarget<Color = Rgb565, Error: Debug> {
    let mut chip = pac::Peripherals::take().unwrap();
    let mut watchdog = Watchdog::new(chip.WATCHDOG);
    let clocks = clocks::init_clocks_and_plls(
        CRYSTAL_HZ,
        chip.XOSC,
        chip.CLOCKS,
        chip.PLL_SYS,
        chip.PLL_USB,
        &mut chip.RESETS,
        &mut watchdog,
    );
    let clocks = clocks.ok().unwrap();
    let mut timer = Timer::new(chip.TIMER, &mut chip.RESETS, &clocks);
    let sio = Sio::new(chip.SIO);
    let pins = Pins::new(chip.IO_BANK0, chip.PADS_BANK0, sio.gpio_bank0, &mut chip.RESETS);

    let data = pins.gpio19.into_function::<FunctionSpi>();
    let clock = pins.gpio18.into_function::<FunctionSpi>();
    let spi = Spi::<_, _, _, 8>::new(chip.SPI0, (data, clock)).init(
        &mut chip.RESETS,
        clocks.peripheral_clock.freq(),
        62_500_000.Hz(),
        // Mode 3: modules without a CS pin need it.
        MODE_3,
    );
    let device = ExclusiveDevice::new_no_delay(spi, pins.gpio17.into_push_pull_output()).unwrap();
    let buffer = singleton!(: [u8; 512] = [0; 512]).unwrap();
    let interface = SpiInterface::new(device, pins.gpio16.into_push_pull_output(), buffer);
    let _ = pins.gpio20.into_push_pull_output_in_state(rp2040_hal::gpio::PinState::High);
    Builder::new(ST7789, interface)
        .display_size(WIDTH as u16, HEIGHT)
        .invert_colors(ColorInversion::Inverted)
        .reset_pin(pins.gpio21.into_push_pull_output())
        .init(&mut timer)
        .unwrap()
}
