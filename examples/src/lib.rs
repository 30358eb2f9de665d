//! Small programs that show one thing each, for any `embedded-graphics` display: the same
//! code draws on the desktop and in firmware. In: a display, and what the device would have
//! measured. Out: a frame on it. Used by `src/main.rs`, which draws them into files, and by
//! tests.
#![no_std]

#[cfg(feature = "desktop")]
pub mod desktop;

mod animated;
mod attitude;
mod clock;
mod dashboard;
mod epaper;

pub use animated::{Animated, GLOBE, HEAT_MAP, HELLO_TRIANGLE, SPINNING_LOGO};
pub use attitude::Attitude;
pub use clock::Clock;
pub use dashboard::{Dashboard, Reading};
pub use epaper::Epaper;
