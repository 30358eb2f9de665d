//! Text and shapes of `embedded-graphics` over a scene, band by band.

use embedded_graphics::mono_font::{MonoTextStyle, ascii::FONT_10X20};
use embedded_graphics::pixelcolor::Rgb888;
use embedded_graphics::prelude::*;
use embedded_graphics::primitives::{Circle, PrimitiveStyle};
use embedded_graphics::text::Text;

use fixel::display::{Overlay, PaletteIndex};
use fixel::frame::Target;
use fixel::render::{Bands, palette};
use fixel::{Band, Scene, Scratch};
use fixel_tests::{load, root};

/// The frame's indices and depths, in bands of so many rows, each drawn over.
fn frame(
    scene: &Scene<'_>,
    rows: u16,
    mut over: impl FnMut(&mut Target<'_>),
) -> (Vec<u8>, Vec<u16>) {
    let pixels = usize::from(scene.frame_width()) * usize::from(rows);
    let (mut indices, mut depths) = (vec![0; pixels], vec![0; pixels]);
    let mut band = Band::new(scene.frame_width(), &mut indices, &mut depths).expect("a band");
    let mut scratch = Box::new(Scratch::<64, 8, 4>::new());
    let (pose, mut work) = (scene.pose(0), scratch.workspace());
    let mut bands = Bands::new(scene, &pose, &mut work, &mut band);
    let mut all = (Vec::new(), Vec::new());
    while let Some(mut target) = bands.next_target() {
        over(&mut target);
        all.0.extend(&*target.indices);
        all.1.extend(&*target.depths);
    }
    all
}

#[test]
fn text_and_shapes_lie_over_the_scene() {
    let (_, baked) = load(&root().join("scenes/teapot.toml"));
    let scene = baked.scene().expect("baked a moment ago");
    let colours = palette(&scene, &scene.pose(0));
    let plain = frame(&scene, 240, |_| {});
    let dashboard = |target: &mut Target<'_>| {
        let mut overlay = Overlay::<Rgb888>::new(target, colours);
        let style = MonoTextStyle::new(&FONT_10X20, Rgb888::WHITE);
        let Ok(_) = Text::new("Teapot\n90 C", Point::new(8, 20), style).draw(&mut overlay);
        let mut overlay = Overlay::new(target, colours);
        let ring = PrimitiveStyle::with_stroke(PaletteIndex(7), 3);
        let Ok(()) = Circle::new(Point::new(250, 150), 100)
            .into_styled(ring)
            .draw(&mut overlay);
    };
    let whole = frame(&scene, 240, dashboard);
    for rows in [1, 7, 16] {
        assert!(frame(&scene, rows, dashboard) == whole, "bands of {rows}");
    }
    assert!(whole.1 == plain.1, "depths stay");
    let white = colours.nearest([255; 3]);
    let changed: Vec<_> = (0..whole.0.len())
        .filter(|i| whole.0[*i] != plain.0[*i])
        .collect();
    let (text, ring): (Vec<usize>, Vec<usize>) = changed.into_iter().partition(|i| i % 320 < 160);
    assert!(
        (200..1000).contains(&text.len()),
        "{} pixels of text",
        text.len()
    );
    assert!(text.iter().all(|i| whole.0[*i] == white && *i / 320 < 50));
    assert!(
        (400..900).contains(&ring.len()),
        "{} pixels of the ring",
        ring.len()
    );
    assert!(ring.iter().all(|i| whole.0[*i] == 7));
}
