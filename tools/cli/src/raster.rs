//! The fixed-point rasteriser: bakes the scene in memory, renders it with the
//! core, and hands back what the core drew as plain arrays.

use anyhow::{Result, bail};
use fixel_reference::Frame;
use fixel_scene::Scene;
use serde_json::{Map, Value};

/// How to render.
#[derive(Clone, Copy, Debug)]
#[expect(dead_code, reason = "read once it is there")]
pub struct Options {
    /// Width in pixels.
    pub width: u32,
    /// Height in pixels.
    pub height: u32,
    /// Frame of the animation.
    pub frame: u32,
    /// Rows in a band; `None`: one band as high as the picture.
    pub bands: Option<u32>,
}

/// A rendered frame.
#[derive(Debug)]
pub struct Rendered {
    /// What was drawn.
    pub frame: Frame,
    /// The core's own counters, as they stand in `--stats`.
    pub stats: Map<String, Value>,
}

/// Renders a scene with the core.
pub fn render(_scene: &Scene, _options: Options) -> Result<Rendered> {
    bail!("the raster renderer is not there yet")
}
