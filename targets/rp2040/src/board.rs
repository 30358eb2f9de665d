//! A Raspberry Pi Pico, or any board with an RP2040 and a crystal of 12 MHz. The wiring is in
//! the README beside this crate.

use embedded_hal::digital::InputPin;
use embedded_hal::spi::Mode;
use fixel_demo::Buttons;
use rp2040_hal::clocks::{ClockSource, ClocksManager};
use rp2040_hal::dma::{CH0, Channel, DMAExt};
use rp2040_hal::fugit::{HertzU32, RateExtU32};
use rp2040_hal::gpio::bank0::{
    Gpio0, Gpio1, Gpio12, Gpio13, Gpio14, Gpio16, Gpio17, Gpio18, Gpio19, Gpio20, Gpio21, Gpio22,
};
use rp2040_hal::gpio::{
    FunctionSio, FunctionSpi, FunctionUart, Pin, Pins, PullDown, PullUp, SioInput, SioOutput,
};
use rp2040_hal::pll::{PLLConfig, setup_pll_blocking};
use rp2040_hal::uart::{DataBits, StopBits, UartConfig, UartPeripheral};
use rp2040_hal::xosc::setup_xosc_blocking;
use rp2040_hal::{Clock, Sio, Spi, Timer, Watchdog, pac, spi, uart};

use crate::link::Link;
use crate::stopwatch::Stopwatch;

/// The processor's clock: what the chip is specified for.
pub const SYSTEM_MHZ: u32 = 133;
/// The clock of SPI and UART, from the second PLL, which USB would need otherwise: half of it
/// is the fastest that ST7789 panels take.
pub const PERIPHERAL_MHZ: u32 = 125;
/// Of the serial line.
const BAUD: u32 = 921_600;

/// An output.
pub type Output<P> = Pin<P, FunctionSio<SioOutput>, PullDown>;
/// An input to ground.
pub type Button<P> = Pin<P, FunctionSio<SioInput>, PullUp>;
/// The pin that says that e-paper is busy.
pub type Busy = Pin<Gpio22, FunctionSio<SioInput>, PullDown>;
/// The bus: data from GPIO 19, clock from GPIO 18.
pub type Bus = Spi<
    spi::Enabled,
    pac::SPI0,
    (
        Pin<Gpio19, FunctionSpi, PullDown>,
        Pin<Gpio18, FunctionSpi, PullDown>,
    ),
    8,
>;
type Serial = UartPeripheral<
    uart::Enabled,
    pac::UART0,
    (
        Pin<Gpio0, FunctionUart, PullDown>,
        Pin<Gpio1, FunctionUart, PullDown>,
    ),
>;

/// Everything that is set up.
pub struct Board {
    /// The panel's bus.
    pub link: Link,
    /// Moves a part of the picture.
    pub channel: Channel<CH0>,
    /// The panel's reset, low for reset.
    pub reset: Output<Gpio21>,
    /// The panel's light, off.
    pub light: Output<Gpio20>,
    /// High while e-paper is busy.
    pub busy: Busy,
    /// Waits.
    pub timer: Timer,
    /// The rest.
    pub console: Console,
}

/// What the loop needs besides the panel.
pub struct Console {
    left: Button<Gpio12>,
    right: Button<Gpio13>,
    stop: Button<Gpio14>,
    serial: Serial,
    /// Counts the processor's cycles.
    pub stopwatch: Stopwatch,
}

impl Board {
    /// Sets the chip up, with SPI at `rate` Hz. `None` if that was done before, or the clocks
    /// do not start.
    pub fn start(rate: u32, mode: Mode) -> Option<Self> {
        let chip = pac::Peripherals::take()?;
        let core = pac::CorePeripherals::take()?;
        let mut resets = chip.RESETS;
        let mut watchdog = Watchdog::new(chip.WATCHDOG);
        watchdog.enable_tick_generation(12);

        let crystal = setup_xosc_blocking(chip.XOSC, 12.MHz()).ok()?;
        let mut clocks = ClocksManager::new(chip.CLOCKS);
        let config = |mhz: u32| PLLConfig {
            vco_freq: HertzU32::MHz(mhz * 12),
            refdiv: 1,
            post_div1: 6,
            post_div2: 2,
        };
        let rate_of_crystal = crystal.operating_frequency();
        let system = setup_pll_blocking(
            chip.PLL_SYS,
            rate_of_crystal,
            config(SYSTEM_MHZ),
            &mut clocks,
            &mut resets,
        )
        .ok()?;
        let peripheral = setup_pll_blocking(
            chip.PLL_USB,
            rate_of_crystal,
            config(PERIPHERAL_MHZ),
            &mut clocks,
            &mut resets,
        )
        .ok()?;
        clocks
            .reference_clock
            .configure_clock(&crystal, crystal.get_freq())
            .ok()?;
        clocks
            .system_clock
            .configure_clock(&system, system.get_freq())
            .ok()?;
        clocks
            .peripheral_clock
            .configure_clock(&peripheral, peripheral.get_freq())
            .ok()?;
        let timer = Timer::new(chip.TIMER, &mut resets, &clocks);

        let sio = Sio::new(chip.SIO);
        let pins = Pins::new(chip.IO_BANK0, chip.PADS_BANK0, sio.gpio_bank0, &mut resets);
        let lines = (pins.gpio0.into_function(), pins.gpio1.into_function());
        let serial = UartPeripheral::new(chip.UART0, lines, &mut resets)
            .enable(
                UartConfig::new(BAUD.Hz(), DataBits::Eight, None, StopBits::One),
                clocks.peripheral_clock.freq(),
            )
            .ok()?;
        let lines = (pins.gpio19.into_function(), pins.gpio18.into_function());
        let bus = Spi::<_, _, _, 8>::new(chip.SPI0, lines).init(
            &mut resets,
            clocks.peripheral_clock.freq(),
            rate.Hz(),
            mode,
        );
        Some(Self {
            link: Link::new(
                bus,
                pins.gpio16.into_function(),
                pins.gpio17.into_function(),
            ),
            channel: chip.DMA.split(&mut resets).ch0,
            reset: pins.gpio21.into_function(),
            light: pins.gpio20.into_function(),
            busy: pins.gpio22.reconfigure(),
            timer,
            console: Console {
                left: pins.gpio12.reconfigure(),
                right: pins.gpio13.reconfigure(),
                stop: pins.gpio14.reconfigure(),
                serial,
                stopwatch: Stopwatch::new(core.SYST, timer),
            },
        })
    }
}

impl Console {
    /// What is pressed now.
    pub fn buttons(&mut self) -> Buttons {
        let Ok(left) = self.left.is_low();
        let Ok(right) = self.right.is_low();
        let Ok(stop) = self.stop.is_low();
        Buttons { left, right, stop }
    }

    /// Sends a text over the serial line.
    pub fn print(&self, text: &[u8]) {
        for byte in text {
            while self.serial.write_raw(&[*byte]).is_err() {}
        }
    }
}

/// The pin that tells commands from data.
pub type DataCommand = Output<Gpio16>;
/// The panel's chip select, low for selected.
pub type ChipSelect = Output<Gpio17>;
