//! Frames of several samples a pixel on grey panels: what firmware packs is what the host
//! makes of the same samples by itself.

use std::convert::Infallible;

use fixel::display::{Diffused, Dither, Ordered, Packed, PackedRows, Packing, ResolvePacked};
use fixel::{Band, Scene, Scratch, render_frame};
use fixel_host::{Options, picture, render};
use fixel_scene::{ColourFormat, PanelDithering};
use fixel_tests::{load, root};

/// Levels as greys of 8 bits, row by row.
struct Panel {
    packing: Packing,
    size: (u16, u16),
    greys: Vec<u8>,
}

impl PackedRows for Panel {
    type Error = Infallible;

    fn rows(&mut self, y: u16, bytes: &[u8]) -> Result<(), Infallible> {
        let (width, height) = self.size;
        let end = match self.packing {
            Packing::Pages => (y + 8).min(height),
            _ => y + 1,
        };
        for y in y..end {
            let most = u16::from(self.packing.most());
            let level = |x| u16::from(self.packing.level(bytes, x, y)) * 255 / most;
            self.greys
                .extend((0..usize::from(width)).map(|x| level(x) as u8));
        }
        Ok(())
    }
}

fn packed(scene: &Scene<'_>, packing: Packing, dither: impl Dither, rows: u16) -> Vec<u8> {
    let size = (scene.width(), scene.height());
    let panel = Panel {
        packing,
        size,
        greys: Vec::new(),
    };
    let (mut sums, mut bytes) = (vec![0; size.0.into()], vec![0; packing.bytes(size.0)]);
    let inner = Packed::new(packing, size.1, dither, &mut bytes, panel);
    let mut display = ResolvePacked::new(scene.output(), &mut sums, inner);
    let pixels = usize::from(scene.frame_width()) * usize::from(rows);
    let (mut indices, mut depths) = (vec![0; pixels], vec![0; pixels]);
    let mut band =
        Band::new(scene.frame_width(), &mut indices, &mut depths).expect("one row at least");
    let mut scratch = Box::new(Scratch::<256, 16, 8>::new());
    let (mut work, pose) = (scratch.workspace(), scene.pose(0));
    let Ok(_) = render_frame(scene, &pose, &mut work, &mut band, &mut display);
    std::mem::take(&mut display.rows().greys)
}

fn expected(scene: &Scene<'_>) -> Vec<u8> {
    let (pixels, _) = picture(scene, &render(scene, &Options::of(scene)));
    pixels.into_iter().map(|[grey, ..]| grey).collect()
}

#[test]
fn firmware_packs_what_the_host_shows() {
    for name in ["antialiased", "stereo_anaglyph"] {
        let (mut description, _) = load(&root().join(format!("scenes/{name}.toml")));
        for rows in [1, 5, 32] {
            description.display.colour = ColourFormat::Mono;
            description.display.dithering = PanelDithering::Bayer8;
            let baked = fixel_bake::bake(&description).expect("it bakes");
            let scene = baked.scene().expect("baked a moment ago");
            assert!(scene.output().is_resolved());
            let pages = packed(&scene, Packing::Pages, Ordered::BAYER8, rows);
            assert!(pages == expected(&scene), "{name} in pages, {rows} rows");

            description.display.colour = ColourFormat::Gray4;
            description.display.dithering = PanelDithering::FloydSteinberg;
            let baked = fixel_bake::bake(&description).expect("it bakes");
            let scene = baked.scene().expect("baked a moment ago");
            let mut errors = vec![0; scene.width().into()];
            let grey = packed(&scene, Packing::Rows4, Diffused::new(&mut errors), rows);
            assert!(grey == expected(&scene), "{name} in 16 greys, {rows} rows");
        }
    }
}
