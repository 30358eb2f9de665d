//! What the page asks for, as JSON.

use serde::Deserialize;

/// A scene to show.
#[derive(Clone, Debug, Deserialize)]
pub struct Open {
    /// Which of the files.
    pub path: String,
    /// The panel's name.
    pub panel: String,
    /// How it shows greys between its own; without, as the scene says.
    pub dithering: Option<String>,
    /// By rays instead of triangles; without, as the scene asks for.
    pub rays: Option<bool>,
}

/// What to estimate.
#[derive(Clone, Debug, Deserialize)]
pub struct Asked {
    /// The board's name.
    pub board: String,
    /// Number of the animation's frame.
    pub number: u32,
}

/// A frame to draw, and how the view has been moved since the last one.
#[derive(Clone, Copy, Debug, Default, Deserialize)]
#[serde(default)]
pub struct Frame {
    /// Number of the animation's frame.
    pub number: u32,
    /// Back to the scene's own view first.
    pub reset: bool,
    /// Degrees that the eye goes to its right about what it looks at.
    pub azimuth: f64,
    /// Degrees that it goes up.
    pub elevation: f64,
    /// By how much things are enlarged; 0: not.
    pub zoom: f64,
    /// What is seen moves by this many pictures' heights to the right.
    pub right: f64,
    /// The same up.
    pub up: f64,
}
