//! Grey panels of few levels: bytes by the core, as firmware makes them, and from them
//! what the panel shows.

use std::convert::Infallible;

use fixel::Scene;
use fixel::display::{Diffused, Dither, Nearest, Ordered, Packed, PackedRows, Packing};
use fixel::palette::{luma, tone};
use fixel::scene::{ColourFormat, PanelDithering};

/// Whether pixels of the same palette index may look different.
pub fn is_dithered(scene: &Scene<'_>) -> bool {
    packing(scene.colour_format()).is_some() && scene.panel_dithering() != PanelDithering::None
}

fn packing(format: ColourFormat) -> Option<Packing> {
    match format {
        ColourFormat::Mono => Some(Packing::Pages),
        ColourFormat::Gray2 => Some(Packing::Rows2),
        ColourFormat::Gray4 => Some(Packing::Rows4),
        _ => None,
    }
}

/// What the panel shows for these colours.
pub(crate) fn dithered(scene: &Scene<'_>, width: u16, colours: Vec<[u8; 3]>) -> Vec<[u8; 3]> {
    let packing = packing(scene.colour_format()).unwrap_or(Packing::Pages);
    let mut errors = vec![0; width.into()];
    let by = |dither| through(packing, dither, width, &colours);
    match scene.panel_dithering() {
        PanelDithering::None => through(packing, Nearest, width, &colours),
        PanelDithering::Bayer4 => by(Ordered::BAYER4),
        PanelDithering::Bayer8 => by(Ordered::BAYER8),
        PanelDithering::BlueNoise => by(Ordered::BLUE_NOISE),
        PanelDithering::FloydSteinberg => {
            through(packing, Diffused::new(&mut errors), width, &colours)
        }
    }
}

/// The panel: rows of grey.
struct Panel {
    packing: Packing,
    width: u16,
    height: u16,
    pixels: Vec<[u8; 3]>,
}

impl PackedRows for Panel {
    type Error = Infallible;

    fn rows(&mut self, y: u16, bytes: &[u8]) -> Result<(), Infallible> {
        let end = match self.packing {
            Packing::Pages => (y + 8).min(self.height),
            _ => y + 1,
        };
        let most = u32::from(self.packing.most());
        for y in y..end {
            let level = |x| u32::from(self.packing.level(bytes, x, y));
            let row = (0..usize::from(self.width)).map(|x| [(level(x) * 255 / most) as u8; 3]);
            self.pixels.extend(row);
        }
        Ok(())
    }
}

fn through(packing: Packing, dither: impl Dither, width: u16, colours: &[[u8; 3]]) -> Vec<[u8; 3]> {
    let height = (colours.len() / usize::from(width).max(1)) as u16;
    let panel = Panel {
        packing,
        width,
        height,
        pixels: Vec::new(),
    };
    let mut bytes = vec![0; packing.bytes(width)];
    let mut display = Packed::new(packing, height, dither, &mut bytes, panel);
    for (y, row) in (0..).zip(colours.chunks(usize::from(width).max(1))) {
        let tones = row.iter().map(|c| tone(luma(*c), packing.most()));
        let Ok(()) = display.row(y, tones);
    }
    std::mem::take(&mut display.rows().pixels)
}
