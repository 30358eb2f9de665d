//! A still on e-paper of 200x200, by rays: glass, a mirror, shadows, in black and white.

use fixel::display::{Diffused, Packed, PackedRows, Packing};
use fixel::ray::{self, RayScratch};
use fixel::{Band, Scene, SceneError};

static SCENE: &[u8] = fixel::include_scene!(OUT_DIR, "epaper.fxl");
const SIDE: usize = 200;

/// The picture's memory: bands of 4 rows, and the errors of a row that go to the next one.
#[derive(Debug)]
pub struct Epaper {
    scene: Scene<'static>,
    indices: [[u8; SIDE]; 4],
    depths: [[u16; SIDE]; 4],
    scratch: RayScratch<4>,
    errors: [i16; SIDE],
    row: [u8; SIDE / 8],
}

impl Epaper {
    /// Checks the scene.
    ///
    /// # Errors
    /// If it is damaged.
    pub fn new() -> Result<Self, SceneError> {
        Ok(Self {
            scene: Scene::embedded(SCENE)?,
            indices: [[0; SIDE]; 4],
            depths: [[0; SIDE]; 4],
            scratch: RayScratch::new(),
            errors: [0; SIDE],
            row: [0; SIDE / 8],
        })
    }

    /// Draws it; a row of the panel has 25 bytes, 8 pixels in each, the left one in the
    /// highest bit, 1 is white.
    ///
    /// # Errors
    /// Those of the panel.
    pub fn draw<P: PackedRows>(&mut self, panel: P) -> Result<(), P::Error> {
        let dither = Diffused::new(&mut self.errors);
        let mut display = Packed::new(Packing::Rows1, SIDE as u16, dither, &mut self.row, panel);
        let mut band = Band::of_rows(&mut self.indices, &mut self.depths);
        let mut work = self.scratch.workspace();
        let pose = self.scene.pose(0);
        ray::render_frame(&self.scene, &pose, &mut work, &mut band, &mut display)?;
        Ok(())
    }
}
