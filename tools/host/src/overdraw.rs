//! How often each pixel is drawn.

use std::cell::Cell;

use fixel::Scene;
use fixel::math::Level;
use fixel::raster::Fill;
use fixel::render::{Ids, Paint, render_frame_with};
use fixel::shade::{Blend, Pixel};

use crate::planes::{HostScratch, Options, collected};

/// How often the rasteriser draws each pixel of a frame: what is nearer than what was
/// there, in the order of drawing; what is hidden already costs a depth test and is not
/// counted. `scene` is baked without a palette (`palette.direct`), where each pixel is shaded
/// by itself. Pixels go by rows, of the frame; `None` of a scene with viewports, whose pixels
/// do not know where theirs lies.
pub fn overdraw(scene: &Scene<'_>, options: &Options) -> Option<Vec<u8>> {
    if scene.viewport_count() != 1 || !scene.is_direct() {
        return None;
    }
    let (width, height) = scene.output().frame_size((options.width, options.height));
    let counts = vec![Cell::new(0); usize::from(width) * usize::from(height)];
    let paint = Count {
        counts: &counts,
        width: width.into(),
    };
    let mut scratch = Box::new(HostScratch::new());
    collected(scene, options, |pose, band, collector| {
        let work = &mut scratch.workspace();
        let Ok(stats) = render_frame_with(&paint, scene, pose, work, band, collector);
        stats
    });
    Some(counts.into_iter().map(Cell::into_inner).collect())
}

/// Counts instead of painting.
#[derive(Clone, Copy)]
struct Count<'c> {
    counts: &'c [Cell<u8>],
    width: usize,
}

impl Count<'_> {
    fn count(&self, pixel: &Pixel<'_>) {
        let [column, row] = pixel.place.map(|at| at as usize);
        if let Some(count) = self.counts.get(row * self.width + column) {
            count.set(count.get().saturating_add(1));
        }
    }
}

impl Paint for Count<'_> {
    type Stored = u8;

    /// Not asked for: every material goes by colour.
    fn fill<'a>(&self, _: &'a [u8; 256], _: Option<Level>, _: Ids) -> Fill<'a> {
        Fill::Depth
    }

    fn hidden<'a>(&self, _: Ids) -> Fill<'a> {
        Fill::Depth
    }

    fn background(&self, _: u8) -> u8 {
        0
    }

    fn surface(&self, pixel: &Pixel<'_>, _: Ids) -> u8 {
        self.count(pixel);
        0
    }

    fn blend(&self, pixel: &Pixel<'_>, behind: u8, _: &Blend<'_>) -> u8 {
        self.count(pixel);
        behind
    }
}
