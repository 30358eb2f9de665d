//! A display and a panel by a stranger, through public names only, and a bus that breaks.

use fixel::display::{Fault, Faulty, Ordered, Packed, PackedRows, Packing};
use fixel::frame::BandRows;
use fixel::palette::{Palette, Rgb565Table};
use fixel::ray::{self, KeptPixel, RayScratch};
use fixel::{Band, Display, Renderer, Scene, Scratch, render_frame};
use fixel_tests::{load, load_for_rays, root};

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

/// Fails each transfer of a frame once and draws the next frame with what the frame before has
/// left in working memory; gives how many transfers there are.
fn after_each_fault(
    scene: &Scene<'_>,
    mut frame: impl FnMut(&mut Faulty<Panel>) -> Result<(), Fault<BusError>>,
) -> u32 {
    let mut good = Faulty::new(Panel::new(scene), u32::MAX);
    frame(&mut good).expect("a good bus");
    for fail in 0.. {
        let mut panel = Faulty::new(Panel::new(scene), fail);
        let result = frame(&mut panel);
        if result.is_ok() {
            return fail;
        }
        assert_eq!(result, Err(Fault::Injected));
        assert_eq!(frame(&mut panel), Ok(()));
        let right = panel.display().pixels == good.display().pixels;
        assert!(right, "after fault {fail}");
    }
    unreachable!("a frame ends")
}

#[test]
fn every_transfer_may_fail_and_the_next_frame_is_right() {
    let (_, baked) = load(&root().join("scenes/teapot.toml"));
    let scene = baked.scene().expect("baked a moment ago");
    let mut renderer = Box::new(Renderer::<320, 16>::new());
    let pose = scene.pose(3);
    let transfers = after_each_fault(&scene, |panel| {
        renderer.draw(&scene, &pose, panel).map(|_| ())
    });
    // The palette and 15 bands.
    assert_eq!(transfers, 16);
}

#[test]
fn every_transfer_of_rays_may_fail_and_the_next_frame_is_right() {
    let (_, baked) = load_for_rays(&root().join("tests/data/rays.toml"));
    let scene = baked.scene().expect("baked a moment ago");
    let (width, height) = (scene.frame_width(), scene.frame_height());
    let pixels = usize::from(width) * usize::from(height);
    let (mut indices, mut depths) = (vec![0; pixels], vec![0; pixels]);
    let mut scratch = Box::new(RayScratch::<8>::new());
    let mut kept = vec![KeptPixel::default(); pixels];
    let pose = scene.pose(3);
    let rows = usize::from(width) * 7;
    let whole = after_each_fault(&scene, |panel| {
        let band = Band::new(width, &mut indices[..rows], &mut depths[..rows]);
        let (work, band) = (&mut scratch.workspace(), &mut band.expect("a band"));
        ray::render_frame(&scene, &pose, work, band, panel).map(|_| ())
    });
    assert_eq!(whole, 1 + u32::from(height.div_ceil(7)));
    let in_passes = after_each_fault(&scene, |panel| {
        let band = Band::new(width, &mut indices[..rows], &mut depths[..rows]);
        let (work, band) = (&mut scratch.workspace(), &mut band.expect("a band"));
        ray::render_progressively(&scene, &pose, work, band, panel, &mut kept).map(|_| ())
    });
    assert!(in_passes > whole, "{in_passes} transfers");
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
