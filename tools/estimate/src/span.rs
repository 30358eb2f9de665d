//! The pixels of a triangle, row by row.

use std::ops::Range;

use fixel::math::SUBPX_BITS;
use fixel::vertex::ScreenVertex;

/// A vertex's place in pixels.
pub(crate) fn place(vertex: &ScreenVertex) -> [f64; 2] {
    let unit = f64::from(1 << SUBPX_BITS);
    [vertex.x(), vertex.y()].map(|c| f64::from(c.to_bits()) / unit)
}

/// The rows, of `rows`, whose middles are between the triangle's top and bottom.
pub(crate) fn rows(corners: [[f64; 2]; 3], rows: Range<u16>) -> Range<i32> {
    let (least, most) = ends(corners.map(|[_, y]| y));
    let from = (first_centre(least)).max(rows.start.into());
    from..first_centre(most).min(rows.end.into()).max(from)
}

/// The columns, of `width`, whose middles are inside in a row.
pub(crate) fn columns(corners: [[f64; 2]; 3], row: i32, width: u16) -> Range<usize> {
    let y = f64::from(row) + 0.5;
    let (mut least, mut most) = (f64::INFINITY, f64::NEG_INFINITY);
    for side in 0..3 {
        let ([ax, ay], [bx, by]) = (corners[side], corners[(side + 1) % 3]);
        if (ay <= y) != (by <= y) {
            let x = ax + (y - ay) / (by - ay) * (bx - ax);
            (least, most) = (least.min(x), most.max(x));
        }
    }
    if least > most {
        return 0..0;
    }
    let column = |x: f64| (first_centre(x)).clamp(0, width.into()) as usize;
    column(least)..column(most)
}

/// The first pixel whose middle is at or past a place.
pub(crate) fn first_centre(place: f64) -> i32 {
    (place - 0.5).ceil() as i32
}

/// Pixels of a surface's longest run.
pub(crate) const LONGEST_RUN_PX: f64 = 64.0;
/// The same of texels, and their shortest.
pub(crate) const LONGEST_TEXELS_PX: f64 = 128.0;
const SHORTEST_TEXELS_PX: f64 = 8.0;

/// How long the runs of a triangle are, as `fixel::raster` has them: by how nearness changes
/// along rows.
pub(crate) struct RunPx {
    /// A corner, and the nearness there.
    corner: [f64; 2],
    nearness: f64,
    /// Its change a column and a row.
    change: [f64; 2],
    kind: RunKind,
}

/// What the length of runs goes by.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum RunKind {
    /// Along parabolas.
    Any,
    /// Along parabolas that show at outlines.
    CutOut,
    /// Along cubics, with outlines or without.
    Texels { cut_out: bool },
}

impl RunPx {
    pub(crate) fn new(corners: [&ScreenVertex; 3], kind: RunKind) -> Self {
        let [a, b, c] = corners.map(place);
        let [za, zb, zc] = corners.map(|corner| f64::from(corner.z().to_bits()));
        let ([bx, by], [cx, cy]) = ([b[0] - a[0], b[1] - a[1]], [c[0] - a[0], c[1] - a[1]]);
        let area = bx * cy - cx * by;
        let along = ((zb - za) * cy - (zc - za) * by) / area;
        let down = ((zc - za) * bx - (zb - za) * cx) / area;
        Self {
            corner: a,
            nearness: za,
            change: [along, down],
            kind,
        }
    }

    /// That of a row, by the nearness in its middle.
    pub(crate) fn at(&self, [x, y]: [f64; 2]) -> f64 {
        let ([ax, ay], [along, down]) = (self.corner, self.change);
        let nearness = self.nearness + along * (x - ax) + down * (y - ay);
        let fits = |px: f64, part: f64| along.abs() * px <= nearness * part;
        if let RunKind::Texels { cut_out } = self.kind {
            let part = if cut_out {
                1.0 / 16.0
            } else if along > 0.0 {
                3.0 / 8.0
            } else {
                1.0 / 4.0
            };
            let px = (nearness * part / along.abs()).min(LONGEST_TEXELS_PX);
            if px >= SHORTEST_TEXELS_PX {
                return (px / 4.0).floor() * 4.0;
            }
        }
        let cut_out = matches!(
            self.kind,
            RunKind::CutOut | RunKind::Texels { cut_out: true }
        );
        if !cut_out && fits(LONGEST_RUN_PX, 1.0 / 32.0) {
            return LONGEST_RUN_PX;
        }
        let (mut px, part) = if cut_out {
            (16.0, 1.0 / 32.0)
        } else {
            (32.0, 1.0 / 4.0)
        };
        while px > 1.0 && !fits(px, part) {
            px /= 2.0;
        }
        px
    }
}

/// The least and the most.
pub(crate) fn ends<const N: usize>(all: [f64; N]) -> (f64, f64) {
    let least = all.iter().copied().fold(f64::INFINITY, f64::min);
    (least, all.iter().copied().fold(f64::NEG_INFINITY, f64::max))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn half_a_square_has_its_pixels() {
        let corners = [[0.0, 0.0], [8.0, 0.0], [0.0, 8.0]];
        assert_eq!(rows(corners, 0..100), 0..8);
        assert_eq!(rows(corners, 3..5), 3..5);
        assert_eq!(rows(corners, 9..12), 9..9);
        assert_eq!(columns(corners, 0, 100), 0..7);
        assert_eq!(columns(corners, 6, 100), 0..1);
        assert_eq!(columns(corners, 0, 4), 0..4);
        assert_eq!(columns(corners, 8, 100), 0..0);
    }
}
