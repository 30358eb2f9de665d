//! A frame in several passes: coarse ones, of which something is to be seen at once, and
//! the whole. Pixels of a coarse pass are kept, so that no ray is cast twice.

use super::frame::{RayStats, draw_pass};
use super::scratch::RayWorkspace;
use crate::display::Display;
use crate::frame::{Band, Target};
use crate::math::Rect;
use crate::scene::{Pose, Scene};

/// Of the first pass: every 8th pixel of every 8th row.
const COARSEST: u32 = 3;

/// A pixel of a coarse pass, for the passes that follow.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct KeptPixel {
    index: u8,
    /// 0: nothing is there.
    depth: u16,
}

/// Which pixels of a frame are cast in a pass.
#[derive(Debug)]
pub(super) struct Pass<'a> {
    /// Those of coarse passes, row by row.
    kept: &'a mut [KeptPixel],
    /// From one of them to the next: `2^finest` columns or rows; and how many are in a row.
    finest: u32,
    columns: usize,
    /// The same of this pass.
    step: u32,
    /// The same of the pass before, if there was one.
    known: Option<u32>,
}

fn is_on_grid([column, row]: [u16; 2], step: u32) -> bool {
    (column | row) & ((1 << step) - 1) == 0
}

impl Pass<'_> {
    /// All pixels at once.
    pub(super) fn whole() -> Pass<'static> {
        Pass {
            kept: &mut [],
            finest: 0,
            columns: 0,
            step: 0,
            known: None,
        }
    }

    /// Whether all pixels are drawn.
    pub(super) fn is_whole(&self) -> bool {
        self.step == 0
    }

    /// Whether all pixels are drawn, and none is known.
    #[inline(always)]
    pub(super) fn is_plain(&self) -> bool {
        self.step == 0 && self.known.is_none()
    }

    /// Whether the pixels are so far apart that rays have nothing to share.
    pub(super) fn is_sparse(&self) -> bool {
        self.step > 1
    }

    /// Whether a pixel of the frame is drawn in this pass.
    #[inline(always)]
    pub(super) fn takes(&self, place: [u16; 2]) -> bool {
        is_on_grid(place, self.step)
    }

    /// What a pixel is known to show.
    #[inline(always)]
    pub(super) fn known(&self, place: [u16; 2]) -> Option<(u8, u16)> {
        let known = self.known.filter(|step| is_on_grid(place, *step))?;
        let kept = self.kept.get(self.at(place, known))?;
        Some((kept.index, kept.depth))
    }

    /// Keeps what a pixel shows.
    #[inline(always)]
    pub(super) fn keep(&mut self, place: [u16; 2], index: u8, depth: u16) {
        if self.is_whole() {
            return;
        }
        let at = self.at(place, self.step);
        if let Some(slot) = self.kept.get_mut(at) {
            *slot = KeptPixel { index, depth };
        }
    }

    /// Where the pixel of a block is kept.
    fn at(&self, place: [u16; 2], step: u32) -> usize {
        let [column, row] = place.map(|c| usize::from(c >> step << step >> self.finest));
        row * self.columns + column
    }

    /// Forgets what an earlier viewport showed where `target`, the part of one that lies at
    /// `rect` in the frame, is to be drawn.
    pub(super) fn begin(&mut self, target: &Target<'_>, rect: &Rect) {
        if self.is_whole() {
            return;
        }
        for row in target.top..target.end {
            for column in 0..target.width {
                let place = [rect.left + column, rect.top + row];
                if self.takes(place) && self.known(place).is_none() {
                    self.keep(place, 0, 0);
                }
            }
        }
    }

    /// Fills each block with its first pixel; see [`Pass::begin`].
    pub(super) fn spread(&self, target: &mut Target<'_>, rect: &Rect) {
        if self.is_whole() {
            return;
        }
        let stride = usize::from(target.stride).max(1);
        let rows = target.indices.chunks_mut(stride);
        let rows = rows.zip(target.depths.chunks_mut(stride));
        for (row, (indices, depths)) in (target.top..target.end).zip(rows) {
            let pixels = indices.iter_mut().zip(depths);
            for (column, (index, depth)) in (0..target.width).zip(pixels) {
                let place = [rect.left + column, rect.top + row];
                let [left, top] = place.map(|c| c >> self.step << self.step);
                let kept = self.kept.get(self.at(place, self.step));
                if let Some(kept) = kept
                    && kept.depth != 0
                    && left >= rect.left
                    && top >= rect.top
                {
                    (*index, *depth) = (kept.index, kept.depth);
                }
            }
        }
    }
}

/// Draws a frame by rays in several passes, each of which goes to the display as a frame of
/// its own: first every 8th pixel of every 8th row, as blocks of 8x8, then blocks half as
/// large, as long as `kept` has room for one entry each, and at last the whole, which is
/// the same bytes as [`render_frame`](super::render_frame)'s. For 320x240, 1,200 entries are
/// one coarse pass, 4,800 two. A first pass takes a 64th of the rays, and no ray is cast
/// twice, but in scenes whose pixels have several where they differ from neighbours.
///
/// # Errors
/// Those of the display; drawing itself cannot fail.
pub fn render_progressively<D: Display>(
    scene: &Scene<'_>,
    pose: &Pose<'_>,
    work: &mut RayWorkspace<'_>,
    band: &mut Band<'_>,
    display: &mut D,
    kept: &mut [KeptPixel],
) -> Result<RayStats, D::Error> {
    let size = [band.width(), pose.height].map(usize::from);
    let blocks = |step: u32| size.map(|c| c.div_ceil(1 << step));
    let fits = |step: &u32| {
        let [columns, rows] = blocks(*step);
        columns * rows <= kept.len()
    };
    let finest = (1..=COARSEST).find(fits).unwrap_or(COARSEST + 1);
    let [columns, _] = blocks(finest);
    let mut pass = Pass {
        kept,
        finest,
        columns,
        step: COARSEST,
        known: None,
    };
    let mut stats = RayStats::default();
    for step in (finest..=COARSEST).rev().chain([0]) {
        pass.step = step;
        let own = draw_pass(scene, pose, work, band, display, (&mut (), &mut pass))?;
        stats.bands += own.bands;
        stats.rays += own.rays;
        pass.known = Some(step);
    }
    Ok(stats)
}
