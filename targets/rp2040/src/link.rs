//! A panel's controller on SPI: commands and data are told apart by a pin.

use embedded_hal::digital::OutputPin;
use embedded_hal::spi::SpiBus;

use crate::board::{Bus, ChipSelect, DataCommand};

/// The bus and its two pins.
pub struct Link {
    bus: Bus,
    pins: LinkPins,
}

/// The pins while the bus is somewhere else.
pub struct LinkPins {
    /// Low for a command.
    data: DataCommand,
    /// Low for selected.
    select: ChipSelect,
}

impl Link {
    /// Not selected.
    pub fn new(bus: Bus, data: DataCommand, mut select: ChipSelect) -> Self {
        let Ok(()) = select.set_high();
        let pins = LinkPins { data, select };
        Self { bus, pins }
    }

    /// Sends a command and what belongs to it.
    pub fn command(&mut self, command: u8, data: &[u8]) {
        self.begin(command);
        self.write(data);
        self.end();
    }

    /// Selects the panel and sends a command, after which come its data.
    pub fn begin(&mut self, command: u8) {
        let Ok(()) = self.pins.select.set_low();
        let Ok(()) = self.pins.data.set_low();
        self.write(&[command]);
        self.flush();
        let Ok(()) = self.pins.data.set_high();
    }

    /// Sends data that belong to no command.
    pub fn data(&mut self, data: &[u8]) {
        let Ok(()) = self.pins.select.set_low();
        self.write(data);
        self.end();
    }

    /// Sends more data of the command that [`Link::begin`] began.
    pub fn write(&mut self, data: &[u8]) {
        let Ok(()) = self.bus.write(data);
    }

    /// Ends a command that [`Link::begin`] began. The last bytes are still on their way when
    /// the FIFO has taken them, and the panel would lose them if it were not selected.
    pub fn end(&mut self) {
        self.flush();
        let Ok(()) = self.pins.select.set_high();
    }

    fn flush(&mut self) {
        let Ok(()) = self.bus.flush();
    }

    /// The bus, for someone else to send data with.
    pub fn lend(self) -> (Bus, LinkPins) {
        (self.bus, self.pins)
    }

    /// The bus back.
    pub fn back(bus: Bus, pins: LinkPins) -> Self {
        Self { bus, pins }
    }
}
