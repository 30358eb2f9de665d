//! The smallest useful firmware: one frame in bands, row by row to a panel.
//! What it takes in flash, RAM and stack is what `cargo xtask footprint` says.

use crate::engine::{self, EngineError, Scene, Scratch};

/// Rows in a band.
pub const BAND_ROWS: usize = 16;
/// The widest picture.
pub const WIDTH: usize = 320;
const PIXELS: usize = WIDTH * BAND_ROWS;

/// All the RAM that a frame needs, whatever its mesh and its height.
#[derive(Debug)]
pub struct Memory {
    index: [u8; PIXELS],
    depth: [u16; PIXELS],
    row: [u8; WIDTH * 2],
    scratch: Scratch,
}

impl Memory {
    /// All zero: lies in `.bss`.
    #[allow(clippy::new_without_default)]
    pub const fn new() -> Self {
        Self {
            index: [0; PIXELS],
            depth: [0; PIXELS],
            row: [0; WIDTH * 2],
            scratch: Scratch::new(),
        }
    }
}

/// Renders `frame` and sends each row's RGB565 bytes, top to bottom.
#[inline(never)]
pub fn draw(
    blob: &[u8],
    frame: u32,
    memory: &mut Memory,
    mut send: impl FnMut(&[u8]),
) -> Result<(), EngineError> {
    let scene = Scene::parse(blob)?;
    let row = &mut memory.row;
    engine::render(
        &scene,
        frame,
        BAND_ROWS,
        &mut memory.scratch,
        &mut memory.index,
        &mut memory.depth,
        |band| band.rows_rgb565(row, &mut send),
    )
}
