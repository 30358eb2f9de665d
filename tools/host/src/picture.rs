//! The picture that a panel shows.

use std::convert::Infallible;

use fixel::Scene;
use fixel::display::{Display, Resolve, Rgb565Rows};
use fixel::frame::BandRows;
use fixel::scene::{ColourFormat, Pose, Stereo};

use crate::Planes;
use crate::colour::{colours, pixels, shown, widened};
use crate::direct::direct_posed;
use crate::panel::{dithered, is_dithered};

/// The pixels of a frame's picture as the panel shows them, and its size.
pub fn picture(scene: &Scene<'_>, planes: &Planes) -> (Vec<[u8; 3]>, (u16, u16)) {
    let output = scene.output();
    let size = output.picture_size(planes.size);
    let format = scene.colour_format();
    let pose = scene.pose(planes.frame);
    let palette = fixel::render::palette(scene, &pose);
    let colour = |index: u8| palette.rgb888(index);
    if scene.is_direct() {
        let rows = planes.size.1;
        let camera = planes.camera.unwrap_or(pose.camera);
        let pose = Pose { camera, ..pose };
        let dither = scene.dither();
        return (direct_posed(scene, planes.size, rows, pose, dither), size);
    }
    if !output.is_resolved() {
        if is_dithered(scene) {
            let colours = planes.index.iter().map(|index| colour(*index));
            return (dithered(scene, size.0, colours.collect()), size);
        }
        return (pixels(&colours(scene, planes.frame), &planes.index), size);
    }
    if format == ColourFormat::Rgb565 {
        return (resolved(scene, planes, size.0), size);
    }
    let [across, down] = output.samples.map(usize::from);
    let width = usize::from(planes.size.0);
    let (columns, rows) = (usize::from(size.0), usize::from(size.1));
    let right = if output.stereo == Stereo::Anaglyph {
        columns
    } else {
        0
    };
    let mean = |x: usize, y: usize, channel: usize| {
        let samples = (0..down).flat_map(|sy| (0..across).map(move |sx| (sx, sy)));
        let at = |(sx, sy)| planes.index[(y * down + sy) * width + x * across + sx];
        let sum: usize = samples.map(|s| usize::from(colour(at(s))[channel])).sum();
        let count = across * down;
        ((sum + count / 2) / count) as u8
    };
    let pixels = (0..rows).flat_map(|y| (0..columns).map(move |x| (x, y)));
    let pixels = pixels.map(|(x, y)| [mean(x, y, 0), mean(x + right, y, 1), mean(x + right, y, 2)]);
    if is_dithered(scene) {
        return (dithered(scene, size.0, pixels.collect()), size);
    }
    (pixels.map(|c| shown(format, c)).collect(), size)
}

/// By the core, as firmware does it.
fn resolved(scene: &Scene<'_>, planes: &Planes, width: u16) -> Vec<[u8; 3]> {
    struct Pixels(Vec<[u8; 3]>);
    impl Rgb565Rows for Pixels {
        type Error = Infallible;

        fn row(&mut self, _: u16, pixels: &[u16]) -> Result<(), Infallible> {
            self.0
                .extend(pixels.iter().map(|p| widened(u16::from_be(*p))));
            Ok(())
        }
    }
    let mut sums = vec![0; width.into()];
    let mut row = vec![0; width.into()];
    let pixels = Pixels(Vec::new());
    let mut display = Resolve::new(scene.output(), &mut sums, &mut row, pixels);
    let pose = scene.pose(planes.frame);
    let Ok(()) = display.begin(&fixel::render::palette(scene, &pose));
    let Ok(()) = display.show(BandRows {
        indices: &planes.index,
        depths: &planes.depth,
        width: planes.size.0,
        top: 0,
    });
    std::mem::take(&mut display.rows().0)
}
