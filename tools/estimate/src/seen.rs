//! A triangle's rows and pixels, and which of these are in front.

use fixel::frame::Target;
use fixel::math::Depth;
use fixel::vertex::ScreenVertex;

use crate::span;

/// Most columns and rows of what is drawn as a small triangle.
const SMALL_PX: f64 = 16.0;
/// The same of a tiny one.
const TINY_PX: f64 = 4.0;

/// What of a triangle is in a target.
pub(crate) struct Seen {
    pub small: bool,
    pub tiny: bool,
    /// Columns from its leftmost to its rightmost vertex.
    pub width: f64,
    /// Pixels in the box around it.
    pub boxed: f64,
    /// Rows between its top and its bottom.
    pub rows: f64,
    pub px: f64,
    /// Pixels that were not behind others.
    pub in_front: f64,
    /// The middle of each row that has pixels, and how many.
    spans: Vec<([f64; 2], f64)>,
}

impl Seen {
    /// Runs of at most so many pixels, by the middle of a row.
    pub fn runs(&self, longest: impl Fn([f64; 2]) -> f64) -> f64 {
        let runs = |(middle, px): &([f64; 2], f64)| (px / longest(*middle)).ceil();
        self.spans.iter().map(runs).sum()
    }

    /// Rows that have pixels.
    pub fn spans(&self) -> f64 {
        self.spans.len() as f64
    }
}

/// Depths as they were after the last triangle: where they changed, the next one is in front.
#[derive(Debug, Default)]
pub(crate) struct Front {
    /// Which part of a band is drawn.
    part: (usize, u16, u16),
    depths: Vec<Depth>,
}

impl Front {
    /// What of a triangle is in the target, and in front.
    pub fn seen<C>(&mut self, target: &Target<'_, C>, corners: [&ScreenVertex; 3]) -> Seen {
        self.keep(target);
        let places = corners.map(span::place);
        let (left, right) = span::ends(places.map(|[x, _]| x));
        let (top, bottom) = span::ends(places.map(|[_, y]| y));
        let size = (right - left).max(bottom - top);
        let inside = left >= 0.0 && right < f64::from(target.width);
        let mut seen = Seen {
            small: inside && size < SMALL_PX,
            tiny: inside && size < TINY_PX,
            width: right - left,
            boxed: 0.0,
            rows: 0.0,
            px: 0.0,
            in_front: 0.0,
            spans: Vec::new(),
        };
        let stride = usize::from(target.stride);
        for row in span::rows(places, target.top..target.end) {
            seen.rows += 1.0;
            seen.boxed += f64::from(span::first_centre(right) - span::first_centre(left));
            let columns = span::columns(places, row, target.width);
            if columns.is_empty() {
                continue;
            }
            seen.px += columns.len() as f64;
            let middle = [(columns.start + columns.end) as f64, f64::from(2 * row + 1)];
            seen.spans
                .push((middle.map(|c| c / 2.0), columns.len() as f64));
            let start = (row as usize - usize::from(target.top)) * stride;
            // A rounding more on each side.
            let from = columns.start.saturating_sub(1);
            let to = (columns.end + 1).min(target.width.into());
            for at in start + from..start + to {
                let (Some(now), Some(before)) = (target.depths.get(at), self.depths.get_mut(at))
                else {
                    continue;
                };
                if *now != *before {
                    *before = *now;
                    seen.in_front += 1.0;
                }
            }
        }
        seen
    }

    /// Goes on to another part of a band, which begins empty.
    fn keep<C>(&mut self, target: &Target<'_, C>) {
        let part = (target.depths.as_ptr().addr(), target.top, target.width);
        if self.part != part {
            self.part = part;
            self.depths.clear();
            self.depths.resize(target.depths.len(), 0);
        }
    }
}
