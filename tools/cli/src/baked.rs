//! Baked scenes: making one, and saying what is in one.

use anyhow::{Result, bail};
use fixel_scene::Scene;
use serde_json::{Map, Value};

/// What a user may ask for beyond the scene itself.
#[derive(Clone, Copy, Debug)]
#[expect(dead_code, reason = "read once it is there")]
pub struct Options {
    /// Simplify each mesh to at most this many triangles.
    pub max_triangles: Option<u32>,
}

/// The bytes of a `.fxl` file.
pub fn bake(_scene: &Scene, _options: Options) -> Result<Vec<u8>> {
    bail!("bake is not there yet")
}

/// Checks a `.fxl` file's bytes and says what is in it, in the order to print.
pub fn describe(_bytes: &[u8]) -> Result<Map<String, Value>> {
    bail!("info is not there yet")
}
