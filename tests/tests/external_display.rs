//! A display and a panel by a stranger, through public names only, and a bus that breaks.

use fixel::display::{Fault, Faulty, Ordered, Packed, PackedRows, Packing};
use fixel::frame::BandRows;
use fixel::palette::{Palette, Rgb565Table};
use fixel::{Band, Display, Scene, Scratch, render_frame};
use fixel_tests::{load, root};

/// A panel of RGB565 in memory: an address window, then pixels.
struct Panel {
    table: Rgb565Table,
    pixels: Vec<u16>,
}

#[derive(Debug, PartialEq)]
struct BusError;

impl Panel {
    fn new(scene: &Scene<'_>) -> Self {
        let size = usize::from(scene.width()) * usize::from(scene.height());
        Self {
            table: Rgb565Table::new(),
            pixels: vec![0x1234; size],
        }
    }
}

impl Display for Panel {
    type Error = BusError;

    fn begin(&mut self, palette: &Palette<'_>) -> Result<(), BusError> {
        self.table.set(palette);
        Ok(())
    }

    fn show(&mut self, rows: BandRows<'_>) -> Result<(), BusError> {
        let start = usize::from(rows.top) * usize::from(rows.width);
        let part = self.pixels.get_mut(start..).ok_or(BusError)?;
        self.table.resolve(rows.indices, part);
        Ok(())
    }
}

/// A frame, in bands of so many rows.
fn draw<D: Display>(scene: &Scene<'_>, rows: u16, display: &mut D) -> Result<(), D::Error> {
    let pixels = usize::from(scene.frame_width()) * usize::from(rows);
    let (mut indices, mut depths) = (vec![0; pixels], vec![0; pixels]);
    let mut band = Band::new(scene.frame_width(), &mut indices, &mut depths).expect("a band");
    let mut scratch = Box::new(Scratch::<64, 8, 4>::new());
    let work = &mut scratch.workspace();
    render_frame(scene, &scene.pose(3), work, &mut band, display).map(|_| ())
}

#[test]
fn every_transfer_may_fail_and_the_next_frame_is_right() {
    let (_, baked) = load(&root().join("scenes/teapot.toml"));
    let scene = baked.scene().expect("baked a moment ago");
    let mut good = Panel::new(&scene);
    draw(&scene, 16, &mut good).expect("a good bus");
    // The palette and 15 bands.
    for fail in 0..16 {
        let mut panel = Faulty::new(Panel::new(&scene), fail);
        assert_eq!(draw(&scene, 16, &mut panel), Err(Fault::Injected));
        assert_eq!(draw(&scene, 16, &mut panel), Ok(()));
        assert!(panel.display().pixels == good.pixels, "after fault {fail}");
    }
    let mut panel = Faulty::new(Panel::new(&scene), 16);
    assert_eq!(draw(&scene, 16, &mut panel), Ok(()));
}

/// An OLED's memory, by pages.
#[derive(Default)]
struct Oled(Vec<u8>);

impl PackedRows for Oled {
    type Error = BusError;

    fn rows(&mut self, y: u16, page: &[u8]) -> Result<(), BusError> {
        if self.0.len() != usize::from(y / 8) * page.len() {
            return Err(BusError);
        }
        self.0.extend(page);
        Ok(())
    }
}

#[test]
fn an_oled_gets_the_same_pages_whatever_the_bands() {
    let (_, baked) = load(&root().join("scenes/mono_bunny.toml"));
    let scene = baked.scene().expect("baked a moment ago");
    let shown = |rows: u16| {
        let mut page = [0; 128];
        let dither = Ordered::BAYER8;
        let mut oled = Packed::new(Packing::Pages, 64, dither, &mut page, Oled::default());
        draw(&scene, rows, &mut oled).expect("pages in order");
        std::mem::take(&mut oled.rows().0)
    };
    let whole = shown(64);
    assert_eq!(whole.len(), 1024);
    for rows in [1, 5, 8, 30] {
        assert!(shown(rows) == whole, "bands of {rows}");
    }
}
