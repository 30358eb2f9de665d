//! The smallest useful firmware: one frame in bands, row by row to a panel.
//! What it takes in flash, RAM and stack is what `cargo xtask footprint` says.

use fixel::Scene;
use fixel::palette::Rgb565Table;

use crate::engine::{self, Buffers, EngineError, Scratch};

/// Rows in a band.
pub const BAND_ROWS: usize = if cfg!(feature = "rays-alone") {
    4
} else if cfg!(any(feature = "small", feature = "compact")) {
    8
} else {
    16
};
/// The widest picture.
pub const WIDTH: usize = if cfg!(feature = "small") { 128 } else { 320 };
const PIXELS: usize = WIDTH * BAND_ROWS;

/// All the RAM that a frame needs, whatever its mesh and its height.
#[derive(Debug)]
pub struct Memory {
    index: [u8; PIXELS],
    depth: [u16; PIXELS],
    /// One is sent while the next is made.
    rows: [[u16; WIDTH]; 2],
    scratch: Scratch,
    colours: Rgb565Table,
}

impl Memory {
    /// Ready for the first frame.
    #[allow(clippy::new_without_default)]
    pub const fn new() -> Self {
        Self {
            index: [0; PIXELS],
            depth: [0; PIXELS],
            rows: [[0; WIDTH]; 2],
            scratch: Scratch::new(),
            colours: Rgb565Table::new(),
        }
    }
}

/// Renders `frame` and sends each row's RGB565 bytes, top to bottom.
#[inline(never)]
pub fn draw(
    blob: &[u8],
    frame: u32,
    memory: &mut Memory,
    send: impl FnMut(&[u8]),
) -> Result<(), EngineError> {
    // Used where it is: it is half a kilobyte.
    match &Scene::embedded(blob) {
        Ok(scene) if scene.output().is_resolved() => Err(EngineError::Samples),
        Ok(scene) if scene.is_direct() => Err(EngineError::Direct),
        Ok(scene) => show(scene, frame, memory, send),
        Err(error) => Err(EngineError::Scene(*error)),
    }
}

#[inline(never)]
fn show(
    scene: &Scene<'_>,
    frame: u32,
    memory: &mut Memory,
    mut send: impl FnMut(&[u8]),
) -> Result<(), EngineError> {
    let [mut row, mut other] = memory.rows.each_mut();
    let buffers = Buffers {
        index: &mut memory.index,
        depth: &mut memory.depth,
        work: memory.scratch.workspace(),
        colours: &mut memory.colours,
    };
    engine::render(scene, frame, BAND_ROWS, buffers, |band, colours| {
        let width = usize::from(band.width).max(1);
        for indices in band.indices.chunks_exact(width) {
            let Some(pixels) = row.get_mut(..width) else {
                return;
            };
            colours.resolve(indices, pixels);
            send(bytemuck::cast_slice(pixels));
            core::mem::swap(&mut row, &mut other);
        }
    })
}
