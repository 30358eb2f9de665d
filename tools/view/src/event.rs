//! What happens to the window, and what it has to do.

use std::sync::Arc;

use crate::keys::Key;
use crate::source::Source;

/// A button of the mouse.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Button {
    /// Rotates; with Shift, pans.
    Left,
    /// Pans.
    Middle,
    /// Zooms.
    Right,
}

/// What happens.
#[derive(Clone, Debug)]
pub enum Event {
    /// A key, and whether Shift is down.
    Key(Key, bool),
    /// The mouse moves with a button down: to the right and down, as parts of the picture's
    /// width and height; and whether Shift is down.
    Drag(Button, [f64; 2], bool),
    /// The wheel turns; up, which is nearer, is above 0.
    Wheel(f64),
    /// Seconds have gone, and whether the picture that was asked for is there.
    Tick(f64, bool),
    /// The scene was loaded anew, or could not be.
    Loaded(Result<Arc<Source>, String>),
    /// The picture that was asked for cannot be made.
    Failed(String),
    /// There it is.
    Drawn,
}

/// What has to be done outside.
#[derive(Clone, Debug, PartialEq)]
pub enum Effect {
    /// Close the window.
    Quit,
    /// Print this.
    Print(String),
    /// Write the panel's pixels to a new file.
    Screenshot,
}
