//! Triangles within four pixels, which most of a fine mesh are from afar: each centre in the
//! box around one (most boxes have one or two, or none) is held to its edges, and a pixel's
//! attributes are the vertices', weighted
//! (barycentric coordinates; Pineda, "A parallel algorithm for polygon rasterization", 1988).
//! Same coverage as [`scan`](super::scan), to the last bit; no gradient is worked out, and
//! nothing at all where no centre is inside.

use super::small::turned;
use super::span::Fill;
use super::triangle::{Seen, first_centre};
use crate::frame::Target;
use crate::math::{Depth, HALF_PX, Reciprocal, SUBPX_BITS, keep_rolled, reciprocal};
use crate::vertex::ScreenVertex;

/// Most columns and rows from one vertex to another: edge functions have 30 bits then.
const PIXELS: i32 = 4;

/// What the second and the third vertex differ by from the first one.
type Differences = [i32; 2];

/// Whether a [small](super::small) triangle is of a few pixels.
#[inline(always)]
pub(super) fn is_tiny(seen: &Seen) -> bool {
    let [[left, top], [right, bottom]] = seen.bounds;
    (right - left) | (bottom - top) < PIXELS << SUBPX_BITS
}

/// Fills a tiny triangle; `false` if it is steep, or its depths differ by 2,048 units.
#[inline(never)]
pub(super) fn fill_tiny(
    target: &mut Target<'_>,
    triangle: [&ScreenVertex; 3],
    seen: &Seen,
    fill: Fill<'_>,
) -> bool {
    let triangle = turned(triangle, seen);
    let mut pixels = Pixels {
        target,
        triangle,
        area: seen.area.unsigned_abs() as u32,
        // Not known yet.
        recip: Reciprocal::default(),
        depths: [0; 2],
        fill,
    };
    covered(triangle, seen, &mut pixels)
}

/// What is known of a tiny triangle once a pixel of it is found.
struct Pixels<'a, 't> {
    target: &'a mut Target<'t>,
    triangle: [&'a ScreenVertex; 3],
    /// Twice its area.
    area: u32,
    /// One over that, or 0.
    recip: Reciprocal,
    depths: Differences,
    fill: Fill<'a>,
}

/// From the first vertex to the others, sub-pixels.
#[inline(always)]
fn sides([a, b, c]: [&ScreenVertex; 3]) -> [[i32; 2]; 2] {
    let (x, y) = (a.x().to_bits(), a.y().to_bits());
    [b, c].map(|v| [v.x().to_bits() - x, v.y().to_bits() - y])
}

/// A pixel's centre.
#[inline(always)]
fn centre(pixel: i32) -> i32 {
    (pixel << SUBPX_BITS) + HALF_PX
}

/// Finds the pixels whose centres are inside.
#[inline(never)]
fn covered(triangle: [&ScreenVertex; 3], seen: &Seen, pixels: &mut Pixels<'_, '_>) -> bool {
    let [a, ..] = triangle;
    let [[left, _], [right, _]] = seen.bounds;
    let (first, end) = seen.rows;
    let [[bx, by], [cx, cy]] = sides(triangle);
    // What goes up is on the right, whose pixels are the next triangle's: its function has to
    // be 1 at least. Functions add up to the area.
    let up = |dy: i32| dy >> 31;
    let (up_ab, up_ca) = (up(by), up(-cy));
    let rest = pixels.area as i32 + up_ab + up_ca + up(cy - by);
    let (ax, ay) = (a.x().to_bits(), a.y().to_bits());
    let (start, past) = (first_centre(left), first_centre(right));
    let (x, y) = (centre(start) - ax, centre(first) - ay);
    let mut at_row = [by * x - bx * y + up_ab, cx * y - cy * x + up_ca];
    for row in first..end {
        let [mut ab, mut ca] = at_row;
        for column in start..past {
            if (ab | ca | (rest - ab - ca)) >= 0
                && !pixels.draw([ca - up_ca, ab - up_ab], [column, row])
            {
                return false;
            }
            ab += by << SUBPX_BITS;
            ca -= cy << SUBPX_BITS;
            keep_rolled();
        }
        let [ab, ca] = &mut at_row;
        *ab -= bx << SUBPX_BITS;
        *ca += cx << SUBPX_BITS;
        keep_rolled();
    }
    true
}

/// A value with 4 fractional bits, with 16 and half a unit added.
#[inline(always)]
fn rounded(value: u32) -> u32 {
    (value << 12) + (1 << 15)
}

impl Pixels<'_, '_> {
    /// Draws a pixel, from edge functions at its centre: those of the second and the third vertex.
    #[inline(never)]
    fn draw(&mut self, functions: [i32; 2], [column, row]: [i32; 2]) -> bool {
        if self.recip.mantissa == 0 && !self.set() {
            return false;
        }
        let top = i32::from(self.target.top);
        let at = ((row - top) * i32::from(self.target.stride) + column) as usize;
        let (Some(pixel), Some(depth)) = (
            self.target.indices.get_mut(at),
            self.target.depths.get_mut(at),
        ) else {
            return true;
        };
        let weights = Weights::new(functions, &self.recip);
        let [a, b, c] = self.triangle;
        let here = (weights.value(rounded(a.z().to_bits()), self.depths) >> 16) as Depth;
        if here > *depth {
            let level = || {
                let [level, b, c] = [a, b, c].map(|v| i32::from(v.level().to_bits() >> 2));
                weights.value(rounded(level as u32), [b - level, c - level]) >> 16
            };
            if let Some(index) = self.fill.index(|| level() as usize) {
                *depth = here;
                *pixel = index;
            }
        }
        true
    }

    /// Sets differences of depth, unless they exceed 15 bits, or half a sub-pixel makes a depth
    /// off by a quarter of a unit.
    #[inline(always)]
    fn set(&mut self) -> bool {
        const MOST: i32 = 1 << 15;
        let [za, zb, zc] = self.triangle.map(|v| v.z().to_bits() as i32);
        let (b, c) = (zb - za, zc - za);
        if ((b + MOST) | (c + MOST)) as u32 >= 2 * MOST as u32 {
            return false;
        }
        let [[bx, by], [cx, cy]] = sides(self.triangle);
        // A sub-pixel's change is this over the area.
        let (x, y) = (b * cy - c * by, c * bx - b * cx);
        let most = self.area << 3;
        if x.unsigned_abs() >= most || y.unsigned_abs() >= most {
            return false;
        }
        self.depths = [b, c];
        self.recip = reciprocal(self.area);
        true
    }
}

/// How much of the second and the third vertex there is in a pixel's centre, 16 fractional bits.
struct Weights([i32; 2]);

impl Weights {
    /// From an edge function's values at the centre, and one over the area.
    #[inline(always)]
    fn new(functions: [i32; 2], area: &Reciprocal) -> Self {
        // Of normalised numbers the upper 16 bits.
        Self(functions.map(|f| {
            let product = ((f as u32) << area.shift >> 16) * (area.mantissa as u32 >> 15);
            ((product + (1 << 14)) >> 15) as i32
        }))
    }

    /// Of a value of the first vertex with 16 fractional bits, and differences with 4, of 15 bits.
    #[inline(always)]
    fn value(&self, first: u32, [b, c]: Differences) -> u32 {
        let Self([wb, wc]) = self;
        first.wrapping_add_signed((wb * b + wc * c) >> 4)
    }
}
