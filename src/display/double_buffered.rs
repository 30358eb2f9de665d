//! Sending one part of the picture while the next is drawn.

use super::Display;
use crate::frame::BandRows;
use crate::palette::{Palette, Rgb565Table};

/// A bus that sends by itself once started: DMA that an interrupt ends, or another core.
pub trait Background {
    /// Pixels on their way, which nobody else may touch: mostly `&'static mut [u16]`.
    type Buffer: AsMut<[u16]>;
    /// What can go wrong on the way.
    type Error;

    /// Begins to send the first `pixels` of a buffer, whole rows from row `top` of the screen
    /// on, in the byte order of panels. Nothing is being sent.
    ///
    /// # Errors
    /// Those of the panel's bus, with the buffer, of which nothing more is sent.
    fn start(
        &mut self,
        top: u16,
        buffer: Self::Buffer,
        pixels: usize,
    ) -> Result<(), (Self::Error, Self::Buffer)>;

    /// Waits until what was started is sent, and gives its buffer back.
    ///
    /// # Errors
    /// Those of the panel's bus, with the buffer.
    fn wait(&mut self) -> Result<Self::Buffer, (Self::Error, Self::Buffer)>;
}

/// Shows frames in RGB565 through two buffers: while one is sent, the renderer draws the
/// next band and resolves it into the other. A buffer that holds less than a band takes it in
/// parts; the best size is a band's, the least a row's. Needs 512 bytes besides.
#[derive(Debug)]
pub struct DoubleBuffered<B: Background> {
    bus: B,
    table: Rgb565Table,
    /// Those that are not being sent.
    free: [Option<B::Buffer>; 2],
    sending: bool,
}

/// Why a frame was given up.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BufferedError<E> {
    /// The bus failed.
    Bus(E),
    /// The buffers do not hold one row.
    Small,
}

impl<B: Background> DoubleBuffered<B> {
    /// On a bus that is idle.
    pub fn new(bus: B, buffers: [B::Buffer; 2]) -> Self {
        Self {
            bus,
            table: Rgb565Table::new(),
            free: buffers.map(Some),
            sending: false,
        }
    }

    /// Waits for the last part of a frame, after which the bus is idle: before the panel is
    /// asked for something else.
    ///
    /// # Errors
    /// Those of the bus.
    pub fn flush(&mut self) -> Result<(), BufferedError<B::Error>> {
        if !self.sending {
            return Ok(());
        }
        self.sending = false;
        match self.bus.wait() {
            Ok(buffer) => {
                self.put(buffer);
                Ok(())
            }
            Err((error, buffer)) => {
                self.put(buffer);
                Err(BufferedError::Bus(error))
            }
        }
    }

    /// The bus and the buffers that are not being sent.
    pub fn release(self) -> (B, [Option<B::Buffer>; 2]) {
        (self.bus, self.free)
    }

    fn put(&mut self, buffer: B::Buffer) {
        if let Some(place) = self.free.iter_mut().find(|place| place.is_none()) {
            *place = Some(buffer);
        }
    }

    /// Fills a free buffer and starts it as soon as the bus is idle; gives how many of the
    /// indices that took.
    fn send(
        &mut self,
        top: u16,
        indices: &[u8],
        width: usize,
    ) -> Result<usize, BufferedError<B::Error>> {
        if self.free.iter().all(Option::is_none) {
            self.flush()?;
        }
        let free = self.free.iter_mut().find_map(Option::take);
        let Some(mut buffer) = free else {
            return Err(BufferedError::Small);
        };
        let pixels = buffer.as_mut();
        let rows = pixels
            .len()
            .min(indices.len())
            .checked_div(width)
            .unwrap_or(0);
        let count = rows * width;
        if count == 0 {
            self.put(buffer);
            return Err(BufferedError::Small);
        }
        self.table.resolve(
            indices.get(..count).unwrap_or_default(),
            pixels.get_mut(..count).unwrap_or_default(),
        );
        if let Err(error) = self.flush() {
            self.put(buffer);
            return Err(error);
        }
        match self.bus.start(top, buffer, count) {
            Ok(()) => {
                self.sending = true;
                Ok(count)
            }
            Err((error, buffer)) => {
                self.put(buffer);
                Err(BufferedError::Bus(error))
            }
        }
    }
}

impl<B: Background> Display for DoubleBuffered<B> {
    type Error = BufferedError<B::Error>;

    fn begin(&mut self, palette: &Palette<'_>) -> Result<(), Self::Error> {
        self.table.set(palette);
        Ok(())
    }

    fn show(&mut self, rows: BandRows<'_>) -> Result<(), Self::Error> {
        let width = usize::from(rows.width).max(1);
        let (mut top, mut indices) = (rows.top, rows.indices);
        while !indices.is_empty() {
            let sent = self.send(top, indices, width)?;
            indices = indices.get(sent..).unwrap_or_default();
            top = top.saturating_add((sent / width) as u16);
        }
        Ok(())
    }
}
