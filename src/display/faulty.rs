//! A panel that breaks, for tests.

use super::Display;
use crate::frame::BandRows;
use crate::palette::Palette;

/// Fails one transfer of a display: what programs do then can be tested.
#[derive(Debug)]
pub struct Faulty<D> {
    display: D,
    /// Transfers until the one that fails.
    left: Option<u32>,
}

/// What a [`Faulty`] display reports.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fault<E> {
    /// The transfer that was to fail.
    Injected,
    /// The display's own.
    Display(E),
}

impl<D> Faulty<D> {
    /// Transfer number `fail` fails, from 0, and none after it. A transfer is a call of
    /// [`Display::begin`] or [`Display::show`].
    pub fn new(display: D, fail: u32) -> Self {
        Self {
            display,
            left: Some(fail),
        }
    }

    /// The display.
    pub fn display(&mut self) -> &mut D {
        &mut self.display
    }

    fn count<E>(&mut self) -> Result<(), Fault<E>> {
        match self.left {
            Some(0) => {
                self.left = None;
                Err(Fault::Injected)
            }
            left => {
                self.left = left.map(|n| n - 1);
                Ok(())
            }
        }
    }
}

impl<D: Display> Display for Faulty<D> {
    type Error = Fault<D::Error>;

    fn begin(&mut self, palette: &Palette<'_>) -> Result<(), Self::Error> {
        self.count()?;
        self.display.begin(palette).map_err(Fault::Display)
    }

    fn show(&mut self, rows: BandRows<'_>) -> Result<(), Self::Error> {
        self.count()?;
        self.display.show(rows).map_err(Fault::Display)
    }
}
