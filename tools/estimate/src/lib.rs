//! What a scene takes on a board, without the board: flash, RAM, instructions and frames a
//! second.
//!
//! In: a baked scene. [`work()`] has the core draw a frame and counts what it is made of;
//! [`Model`] has what each of that takes, fitted to counts from emulators; [`Estimate`]
//! puts both together for a [`Board`]. Used by `fixel estimate`, and by `cargo xtask fit`,
//! which makes the coefficients.

mod bend;
mod board;
mod capacity;
mod counting;
mod estimate;
mod frame;
mod kernel;
mod layout;
mod model;
mod parts;
mod seen;
mod solve;
mod span;
mod surface;
mod term;

pub use board::{BOARDS, Board, Cycles, Panel};
pub use capacity::Lists;
pub use estimate::Estimate;
pub use frame::work;
pub use layout::{Layout, Ram, Wire};
pub use model::{Count, Firmware, Model};
pub use parts::Parts;
pub use solve::non_negative;
pub use term::{Term, Work};
