//! Bands, panels and what goes over a picture, with whatever numbers their arguments' types
//! hold.

use core::num::NonZeroU32;

use embedded_graphics::Pixel;
use embedded_graphics::draw_target::DrawTarget;
use embedded_graphics::geometry::{Dimensions, Point, Size};
use embedded_graphics::pixelcolor::Rgb888;
use embedded_graphics::primitives::Rectangle;
use fixel::Band;
use fixel::display::{
    Changed, Diffused, Display, Dither, Nearest, Ordered, Overlay, Packed, PackedRows, Packing,
    PaletteIndex, PartialRows, Resolve, ResolvePacked, Rgb565Rows,
};
use fixel::frame::BandRows;
use fixel::math::Rect;
use fixel::palette::Palette;
use fixel::scene::{Output, Stereo};

use super::numbers::Numbers;

/// One of them after the other for as long as there are bytes.
pub fn panels(bytes: &[u8]) {
    let all = [band, changed, packed, resolved, over];
    let mut n = Numbers(bytes);
    while !n.0.is_empty() {
        all[n.below(all.len())](&mut n);
    }
}

/// A panel that takes everything.
struct Any;

impl PartialRows for Any {
    type Error = ();

    fn part(&mut self, _: u16, _: u16, _: &[u8]) -> Result<(), ()> {
        Ok(())
    }
}

impl PackedRows for Any {
    type Error = ();

    fn rows(&mut self, _: u16, _: &[u8]) -> Result<(), ()> {
        Ok(())
    }
}

impl Rgb565Rows for Any {
    type Error = ();

    fn row(&mut self, _: u16, _: &[u16]) -> Result<(), ()> {
        Ok(())
    }
}

fn short(n: &mut Numbers<'_>) -> u16 {
    match n.below(2) {
        0 => n.below(40) as u16,
        _ => n.extreme() as u16,
    }
}

fn rect(n: &mut Numbers<'_>) -> Rect {
    Rect {
        left: short(n),
        top: short(n),
        right: short(n),
        bottom: short(n),
    }
}

fn band(n: &mut Numbers<'_>) {
    let (width, ground) = (short(n), n.byte());
    let (mut indices, mut depths) = (vec![0; n.below(256)], vec![0; n.below(256)]);
    let Ok(mut band) = Band::<u8>::new(width, &mut indices, &mut depths) else {
        return;
    };
    let mut target = band.target(short(n), short(n));
    // Its fields are public.
    for field in [
        &mut target.width,
        &mut target.stride,
        &mut target.top,
        &mut target.end,
    ] {
        if n.below(4) == 0 {
            *field = short(n);
        }
    }
    let rect = rect(n);
    target.part(&rect).clear(|y| y as u8);
    let inner = target.part(&rect).finished().rows();
    let _ = (inner, target.finished().rows());
    if target.end.saturating_sub(target.top) < 64 {
        target.clear(|_| ground);
    }
    let _ = target.into_finished().rows();
}

fn changed(n: &mut Numbers<'_>) {
    let (row_bytes, tile) = (short(n).into(), short(n).into());
    let (rows, height) = (short(n), short(n));
    let _ = Changed::<Any>::sums(row_bytes, tile, rows, height);
    let _ = Changed::<Any>::sums(usize::MAX, tile, rows, height);
    let mut sums = vec![NonZeroU32::new(n.word()); n.below(64)];
    let mut panel = Changed::new(Any, row_bytes, tile, rows, &mut sums);
    let bytes = vec![n.byte(); n.below(64)];
    let _ = (panel.rows(short(n), &bytes), panel.rows(short(n), &bytes));
}

/// Any rows of a band, to a display.
fn show<D: Display>(n: &mut Numbers<'_>, display: &mut D) {
    let colours: Vec<[u8; 3]> = (0..n.below(8)).map(|_| [0; 3].map(|_| n.byte())).collect();
    let _ = display.begin(&Palette::new(&colours));
    for _ in 0..n.below(4) {
        let indices: Vec<u8> = (0..n.below(128)).map(|_| n.byte()).collect();
        let rows = BandRows {
            depths: &vec![0; indices.len()],
            indices: &indices,
            width: short(n),
            top: short(n),
        };
        let _ = display.show(rows);
    }
}

fn packing(n: &mut Numbers<'_>) -> Packing {
    n.one_of(&[
        Packing::Rows1,
        Packing::Rows2,
        Packing::Rows4,
        Packing::Pages,
    ])
}

fn packed(n: &mut Numbers<'_>) {
    let mut errors = vec![n.extreme() as i16; n.below(40)];
    match n.below(5) {
        0 => packed_by(n, Nearest),
        1 => packed_by(n, Ordered::BAYER4),
        2 => packed_by(n, Ordered::BAYER8),
        3 => packed_by(n, Ordered::BLUE_NOISE),
        _ => packed_by(n, Diffused::new(&mut errors)),
    }
}

fn packed_by(n: &mut Numbers<'_>, mut dither: impl Dither) {
    let tones: Vec<u16> = (0..n.below(40)).map(|_| n.extreme() as u16).collect();
    dither.row(short(n), n.byte(), tones.iter().copied(), |_, _| {});
    let packing = packing(n);
    let mut bytes = vec![0; n.below(64)];
    let _ = packing.level(&bytes, n.wide() as usize, short(n));
    let mut display = Packed::new(packing, short(n), dither, &mut bytes, Any);
    show(n, &mut display);
    let _ = display.row(short(n), tones.iter().copied());
}

fn resolved(n: &mut Numbers<'_>) {
    let output = Output {
        samples: [n.byte(), n.byte()].map(|s| if s < 200 { s % 4 } else { s }),
        stereo: n.one_of(&[Stereo::None, Stereo::Anaglyph, Stereo::SideBySide]),
        eye_slope: n.extreme(),
    };
    let size = (short(n), short(n));
    let _ = (output.eyes(), output.is_resolved());
    let _ = (output.frame_size(size), output.picture_size(size));
    let (mut sums, mut pixels) = (vec![n.word(); n.below(40)], vec![0; n.below(40)]);
    show(n, &mut Resolve::new(output, &mut sums, &mut pixels, Any));
    let mut bytes = vec![0; n.below(64)];
    let packed = Packed::new(packing(n), short(n), Ordered::BAYER8, &mut bytes, Any);
    show(n, &mut ResolvePacked::new(output, &mut sums, packed));
}

fn over(n: &mut Numbers<'_>) {
    let colours = [[0; 3], [n.byte(); 3]];
    let (mut indices, mut depths) = (vec![0; 200], vec![0; 200]);
    let width = 1 + n.below(40) as u16;
    let mut band = Band::new(width, &mut indices, &mut depths).expect("a row at least");
    let mut target = band.target(short(n), short(n));
    let place = |n: &mut Numbers<'_>| Point::new(n.extreme(), n.extreme());
    // A shape of as many pixels as there are numbers would take for ever.
    let size = Size::new(short(n).into(), short(n).into());
    let area = Rectangle::new(place(n), size);
    let (at, colour) = (place(n), [0; 3].map(|_| n.byte()));
    let mut over = Overlay::new(&mut target, Palette::new(&colours));
    let index = PaletteIndex(colour[0]);
    let _ = over.draw_iter([Pixel(at, index)]);
    let _ = over.fill_solid(&area, index);
    let _ = over.fill_contiguous(&area, [index; 9]);
    let _ = over.bounding_box();
    let [r, g, b] = colour;
    let mut over = Overlay::new(&mut target, Palette::new(&colours));
    let _ = over.fill_solid(&area, Rgb888::new(r, g, b));
    let _ = over.clear(Rgb888::new(r, g, b));
}
