//! Which pixels a pass of a frame casts, and those of coarse passes, which are kept.

use crate::frame::Target;
use crate::math::Rect;

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
    pub kept: &'a mut [KeptPixel],
    /// From one of them to the next: `2^finest` columns or rows; and how many are in a row.
    pub finest: u32,
    pub columns: usize,
    /// The same of this pass.
    pub step: u32,
    /// The same of the pass before, if there was one.
    pub known: Option<u32>,
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
