//! The scene through fixel.

use std::convert::Infallible;
use std::path::Path;

use crate::Renderer;
use fixel::display::Display;
use fixel::frame::BandRows;
use fixel::palette::{Palette, Rgb565Table};
use fixel::{Band, Scene, Scratch};

/// What it needs: as large as in firmware.
#[derive(Debug)]
pub struct Fixel {
    scene: Scene<'static>,
    indices: Vec<u8>,
    depths: Vec<u16>,
    scratch: Box<Scratch<64, 10, 4>>,
    panel: Panel,
}

/// Takes bands as a panel does, in RGB565.
#[derive(Debug)]
struct Panel {
    colours: Rgb565Table,
    pixels: Vec<u16>,
}

impl Display for Panel {
    type Error = Infallible;

    fn begin(&mut self, palette: &Palette<'_>) -> Result<(), Infallible> {
        self.colours.set(palette);
        Ok(())
    }

    fn show(&mut self, rows: BandRows<'_>) -> Result<(), Infallible> {
        let start = usize::from(rows.top) * usize::from(rows.width);
        let pixels = &mut self.pixels[start..start + rows.indices.len()];
        self.colours.resolve(rows.indices, pixels);
        Ok(())
    }
}

impl Fixel {
    /// Ready for the first frame.
    ///
    /// # Errors
    /// If the scene cannot be baked.
    pub fn new(path: &Path) -> Result<Self, String> {
        let scene = fixel_scene::load(path).map_err(|error| error.to_string())?;
        let baked = fixel_bake::bake(&scene).map_err(|error| error.to_string())?;
        // As in flash: there for good, and checked once.
        let baked = Box::leak(Box::new(baked));
        let scene = baked.scene().map_err(|error| error.to_string())?;
        let pixels = usize::from(scene.width()) * usize::from(scene.height());
        Ok(Self {
            scene,
            indices: vec![0; pixels],
            depths: vec![0; pixels],
            scratch: Box::default(),
            panel: Panel {
                colours: Rgb565Table::new(),
                pixels: vec![0; pixels],
            },
        })
    }
}

impl Renderer for Fixel {
    fn name(&self) -> &'static str {
        "fixel"
    }

    fn draw(&mut self, frame: u32) {
        let Self {
            scene,
            indices,
            depths,
            scratch,
            panel,
        } = self;
        let Ok(mut band) = Band::new(scene.width(), indices, depths) else {
            return;
        };
        let pose = scene.pose(frame);
        let Ok(_) = fixel::render_frame(scene, &pose, &mut scratch.workspace(), &mut band, panel);
    }

    fn pixels(&self) -> &[u16] {
        &self.panel.pixels
    }
}
