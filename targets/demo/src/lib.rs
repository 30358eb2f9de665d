//! What the firmware for real boards shares.
//!
//! In: a baked scene, which buttons are pressed, and a panel as a
//! [`Display`](fixel::Display). Out: frames on the panel, and a line of JSON for each.
//! A board's loop is
//!
//! ```text
//! let mut demo = Demo::new(SCENE, (320, 240))?;
//! loop {
//!     demo.frame(buttons(), &mut memory, &mut display)?;
//!     demo.report(cost).end(print);
//! }
//! ```
#![no_std]

mod buttons;
mod memory;
#[cfg(feature = "panic-handler")]
mod panic;
mod show;
mod statistics;

pub use buttons::{Buttons, Object, STEP};
pub use memory::Memory;
pub use show::{Demo, DemoError};
pub use statistics::{Cost, Statistics};
