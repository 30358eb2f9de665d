//! How an attribute changes from pixel to pixel.

use crate::math::{Reciprocal, SUBPX_BITS, mul_high, reciprocal};
use crate::vertex::{Rest, ScreenVertex};

/// One over a triangle's doubled area, and its edges from the first vertex.
#[derive(Clone, Copy, Debug)]
pub(super) struct Plane {
    recip: Reciprocal,
    /// `area = (32-bit value) * 2^scale`.
    scale: i32,
    d1: [i32; 2],
    d2: [i32; 2],
    /// Fractional bits of the edges.
    bits: i32,
    /// No edge is longer than this, sub-pixels, to within a factor of two.
    size: i32,
}

/// Change of an attribute a pixel, 16 fractional bits.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Gradient {
    /// From pixel to pixel.
    pub x: i32,
    /// From row to row.
    pub y: i32,
}

/// Fractional bits of a place before rounding.
pub(super) const UNROUNDED_BITS: u32 = SUBPX_BITS + Rest::BITS;

/// A vertex's place before rounding.
fn unrounded(v: &ScreenVertex) -> Place {
    let [x, y] = v.rest().parts();
    [
        (v.x().to_bits() << Rest::BITS) + x,
        (v.y().to_bits() << Rest::BITS) + y,
    ]
}

/// A place before rounding, [`UNROUNDED_BITS`] fractional bits.
pub(super) type Place = [i32; 2];

/// The vertices' places before rounding and their doubled area, if that has the
/// sign of `area`; in a sliver it may not, and the rounded ones are given.
pub(super) fn places(sorted: [&ScreenVertex; 3], area: i64) -> ([Place; 3], i64) {
    unrounded_places(sorted, area).unwrap_or_else(|| {
        let wide = |v: &ScreenVertex| [v.x(), v.y()].map(|c| c.to_bits() << Rest::BITS);
        (sorted.map(wide), area << (2 * Rest::BITS))
    })
}

fn unrounded_places(sorted: [&ScreenVertex; 3], area: i64) -> Option<([Place; 3], i64)> {
    let places = sorted.map(unrounded);
    let [[ax, ay], [bx, by], [cx, cy]] = places;
    let side = |p: i32, q: i32| i64::from(p) - i64::from(q);
    let exact = side(bx, ax) * side(cy, ay) - side(cx, ax) * side(by, ay);
    let same_side = (exact > 0 && area > 0) || (exact < 0 && area < 0);
    same_side.then_some((places, exact))
}

/// Differences below this multiply to 30 bits and a sign, and add to 31.
const SMALL: i32 = 1 << 15;

impl Plane {
    /// For vertices with the doubled `area` (not 0; sub-pixels squared, its
    /// sign is that of the winding).
    #[inline(always)]
    pub(super) fn new([a, b, c]: [&ScreenVertex; 3], area: i64) -> Self {
        Self::of(
            [a, b, c].map(|v| [v.x().to_bits(), v.y().to_bits()]),
            area,
            SUBPX_BITS as i32,
        )
    }

    /// For the vertices as they were before rounding, and the first one's place;
    /// `None` if the doubled area differs in sign from `area`, as it may in a
    /// sliver.
    pub(super) fn unrounded(sorted: [&ScreenVertex; 3], area: i64) -> Option<(Self, Place)> {
        let (places, exact) = unrounded_places(sorted, area)?;
        let [first, ..] = places;
        Some((Self::of(places, exact, UNROUNDED_BITS as i32), first))
    }

    #[inline(never)]
    fn of([[ax, ay], [bx, by], [cx, cy]]: [[i32; 2]; 3], area: i64, bits: i32) -> Self {
        let mut d1 = [bx - ax, by - ay];
        let mut d2 = [cx - ax, cy - ay];
        if area < 0 {
            // Both numerators change sign with the area.
            d1 = d1.map(i32::wrapping_neg);
            d2 = d2.map(i32::wrapping_neg);
        }
        let positive = area.unsigned_abs();
        let scale = (32 - positive.leading_zeros() as i32).max(0);
        let size = [d1, d2].as_flattened().iter().fold(0, |m, d| m | d.abs());
        Self {
            recip: reciprocal((positive >> scale) as u32),
            scale,
            d1,
            d2,
            bits,
            size,
        }
    }

    /// The gradient of an attribute that differs from the first vertex's by
    /// `v1` and `v2` at the others, in units with `fraction` fractional bits.
    /// `None` if it exceeds the format: the triangle is a sliver, thinner than
    /// two pixels.
    #[inline(never)]
    pub(super) fn gradient(&self, v1: i32, v2: i32, fraction: i32) -> Option<Gradient> {
        let ([x1, y1], [x2, y2]) = (self.d1, self.d2);
        let values = v1.abs() | v2.abs();
        // Or larger ones whose values differ less, if none is a sliver: below, what is
        // cut off is 4 times 2^-16 a pixel at most.
        let smooth = self.size < SMALL << 2 && values < SMALL >> 2 && self.is_wide();
        if (self.size | values) < SMALL || smooth {
            return Some(Gradient {
                x: self.divide_small(v1 * y2 - v2 * y1, fraction)?,
                y: self.divide_small(x1 * v2 - x2 * v1, fraction)?,
            });
        }
        let product = |a: i32, b: i32| i64::from(a) * i64::from(b);
        Some(Gradient {
            x: self.divide(product(v1, y2) - product(v2, y1), fraction)?,
            y: self.divide(product(x1, v2) - product(x2, v1), fraction)?,
        })
    }

    /// Whether the area is half a pixel or more.
    #[inline(always)]
    fn is_wide(&self) -> bool {
        self.scale > 0 || self.recip.shift <= 8
    }

    /// `n / |area|` a pixel, with 16 fractional bits, for `n` of at most 31 bits.
    #[inline(always)]
    fn divide_small(&self, n: i32, fraction: i32) -> Option<i32> {
        // n / area = high * 2^(32 + shift - scale - 62); a pixel is 2^bits units, and the result has 16 fractional bits.
        let high = mul_high(n, self.recip.mantissa);
        let up = self.recip.shift as i32 - self.scale - 30 + self.bits + 16 - fraction;
        if up <= 0 {
            return Some(high >> up.wrapping_neg().min(31));
        }
        let up = up.min(31);
        let shifted = high << up;
        (shifted >> up == high).then_some(shifted)
    }

    /// `n / |area|` a pixel, with 16 fractional bits.
    #[inline(never)]
    fn divide(&self, n: i64, fraction: i32) -> Option<i32> {
        // To 31 bits and a sign.
        let down = (33 - n.unsigned_abs().leading_zeros() as i32).max(0);
        let product = (n >> down) * i64::from(self.recip.mantissa);
        // n / area = product * 2^(down + shift - scale - 62); a pixel is
        // 2^bits units, and the result has 16 fractional bits.
        let up = down + self.recip.shift as i32 - self.scale - 62 + self.bits + (16 - fraction);
        if up >= 0 {
            let most = i64::from(i32::MAX) >> up.min(31);
            return (product.abs() <= most).then(|| (product << up.min(31)) as i32);
        }
        let by = up.wrapping_neg();
        if by > 62 {
            return Some(0);
        }
        i32::try_from((product + (1i64 << (by - 1))) >> by).ok()
    }

    /// The gradient of an attribute of up to 31 bits and a sign, whose differences
    /// fit as many: a pixel's change, 16 fractional bits. `None` above 2^30 a pixel.
    pub(super) fn wide_gradient(&self, v1: i32, v2: i32) -> Option<[i64; 2]> {
        let ([x1, y1], [x2, y2]) = (self.d1, self.d2);
        let product = |a: i32, b: i32| i64::from(a) * i64::from(b);
        Some([
            self.divide_wide(product(v1, y2) - product(v2, y1))?,
            self.divide_wide(product(x1, v2) - product(x2, v1))?,
        ])
    }

    /// `n / |area|` a pixel, with 16 fractional bits, below 2^46.
    fn divide_wide(&self, n: i64) -> Option<i64> {
        const MOST: i64 = 1 << 46;
        let down = (33 - n.unsigned_abs().leading_zeros() as i32).max(0);
        let product = (n >> down) * i64::from(self.recip.mantissa);
        let up = down + self.recip.shift as i32 - self.scale - 62 + self.bits + 16;
        let quotient = if up >= 0 {
            let up = up.min(31);
            (product.abs() <= MOST >> up).then_some(product << up)?
        } else {
            let by = up.wrapping_neg().min(62);
            (product + (1i64 << (by - 1))) >> by
        };
        (quotient.abs() <= MOST).then_some(quotient)
    }
}

/// The same for a triangle smaller than 16 pixels: 32-bit products are enough. Where
/// depths differ much, high halves of products are; what that cuts off is 2^-29 of the
/// largest product, so that of a triangle a thousand times longer than wide a depth is
/// off by a tenth at most.
#[derive(Clone, Copy, Debug)]
pub(super) struct SmallPlane {
    /// Of the area's size.
    recip: Reciprocal,
    d1: [i32; 2],
    d2: [i32; 2],
}

impl SmallPlane {
    /// For vertices counter-clockwise on the screen, with the doubled area's size: below
    /// 2^32 as that of the box around them is.
    #[inline(always)]
    pub(super) fn new([a, b, c]: [&ScreenVertex; 3], area: u32) -> Self {
        // 16 bits and a sign.
        let side = |v: &ScreenVertex| {
            [
                v.x().to_bits() - a.x().to_bits(),
                v.y().to_bits() - a.y().to_bits(),
            ]
        };
        Self {
            recip: reciprocal(area),
            d1: side(b),
            d2: side(c),
        }
    }

    /// The gradient of depths, 4 fractional bits, that differ from the first vertex's
    /// by `v1` and `v2`; `None` if it is steep.
    #[inline(always)]
    pub(super) fn depth(&self, v1: i32, v2: i32) -> Option<Gradient> {
        if are_wide(v1, v2) {
            return self.wide(v1, v2, 0, STEEP_BITS);
        }
        self.level(v1, v2)
    }

    /// The gradient of values within 2^16 either way, without fractional bits: with 14.
    /// `None` above 2^16 a pixel.
    #[inline(always)]
    pub(super) fn value(&self, v1: i32, v2: i32) -> Option<Gradient> {
        // Four times what depths have.
        const MORE: i32 = 2;
        if are_wide(v1, v2) {
            return self.wide(v1, v2, MORE, MOST_BITS);
        }
        self.narrow(v1, v2, MORE, MOST_BITS)
    }

    /// The gradient of levels, 4 fractional bits, that differ by less than 2^14; `None`
    /// if it would be steep for a depth.
    #[inline(always)]
    pub(super) fn level(&self, v1: i32, v2: i32) -> Option<Gradient> {
        self.narrow(v1, v2, 0, STEEP_BITS)
    }

    /// The same times `2^more`; `None` above `2^bits`.
    #[inline(always)]
    fn narrow(&self, v1: i32, v2: i32, more: i32, bits: i32) -> Option<Gradient> {
        let ([x1, y1], [x2, y2]) = (self.d1, self.d2);
        // n / area * 2^(12 + 16 - 4).
        let up = self.recip.shift as i32 - 6 + more;
        self.divide([v2 * y1 - v1 * y2, x2 * v1 - x1 * v2], up, bits)
    }

    /// The same where products exceed 31 bits.
    #[inline(never)]
    fn wide(&self, v1: i32, v2: i32, more: i32, bits: i32) -> Option<Gradient> {
        let [[x1, y1], [x2, y2]] = [self.d1, self.d2].map(|d| d.map(|side| side << 15));
        let (v1, v2) = (v1 << 11, v2 << 11);
        let x = mul_high(v2, y1) - mul_high(v1, y2);
        let y = mul_high(x2, v1) - mul_high(x1, v2);
        self.divide([x, y], self.recip.shift as i32 + more, bits)
    }

    /// `n * mantissa * 2^(up - 32)`, unless it is above `2^bits`.
    #[inline(always)]
    fn divide(&self, n: [i32; 2], up: i32, bits: i32) -> Option<Gradient> {
        // Within 30 bits and a sign.
        let [x, y] = n.map(|n| mul_high(n, self.recip.mantissa));
        let limit = 1 << (bits - up).clamp(0, 30);
        if ((x + limit) | (y + limit)) as u32 >= 2 * limit as u32 {
            return None;
        }
        let gradient = if up >= 0 {
            let up = up & 31;
            Gradient {
                x: x << up,
                y: y << up,
            }
        } else {
            let down = up.wrapping_neg() & 31;
            Gradient {
                x: x >> down,
                y: y >> down,
            }
        };
        Some(gradient)
    }
}

/// Whether products of differences would exceed 31 bits.
#[inline(always)]
fn are_wide(v1: i32, v2: i32) -> bool {
    const SMALL: i32 = 1 << 14;
    ((v1 + SMALL) | (v2 + SMALL)) as u32 >= 2 * SMALL as u32
}

/// Bits of the largest gradient that fits.
const MOST_BITS: i32 = 30;

/// A steep gradient's bits.
const STEEP_BITS: i32 = 16 + SUBPX_BITS as i32 - 2;

impl Gradient {
    /// Whether a vertex that is off by half a sub-pixel makes the attribute off
    /// by an eighth of a unit or more.
    #[inline(always)]
    pub(super) fn is_steep(&self) -> bool {
        const STEEP: u32 = 1 << STEEP_BITS;
        self.x.unsigned_abs() >= STEEP || self.y.unsigned_abs() >= STEEP
    }
}
