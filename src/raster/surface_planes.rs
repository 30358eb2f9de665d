//! Depth, nearness and attributes of a surface's triangle, row by row and run by run.

use super::attributes::Attributes;
use super::corners::{AFFINE_FRACTION, Corners, SurfaceKind};
use super::gradient::Plane;
use super::run::{LONGEST_RUN, MOST_ATTRIBUTES, RUN_FRACTION, Run, Values};
use super::scan::{Shape, Span, Stepped};
use crate::math::{HALF_PX, Reciprocal, SUBPX_BITS, mul_high, reciprocal};

/// From a [`Linear`] of such an attribute to [`RUN_FRACTION`].
const AFFINE_DOWN: u32 = 16 + AFFINE_FRACTION - RUN_FRACTION;

/// A quantity that is linear on the screen, at the centre of one pixel, and its
/// change a pixel: 16 fractional bits.
#[derive(Clone, Copy, Default)]
struct Linear {
    at: i64,
    x: i64,
    y: i64,
}

impl Linear {
    /// From its values at the sorted vertices to the pixel in the top one's column
    /// and in `row`.
    fn new(plane: &Plane, shape: &Shape<'_>, [a, b, c]: [i32; 3], row: i32) -> Option<Self> {
        const FRACTION: i32 = (1 << SUBPX_BITS) - 1;
        let [x, y] = plane.wide_gradient(b.checked_sub(a)?, c.checked_sub(a)?)?;
        let [top, ..] = shape.sorted;
        let (px, py) = (top.x().to_bits(), top.y().to_bits());
        let own =
            |gradient: i64, p: i32| (gradient * i64::from(HALF_PX - (p & FRACTION))) >> SUBPX_BITS;
        let rows = i64::from(row - (py >> SUBPX_BITS));
        let at = (i64::from(a) << 16) + own(x, px) + own(y, py) + y * rows;
        Some(Self { at, x, y })
    }

    /// The whole part `columns` to the right.
    fn at(&self, columns: i32) -> i64 {
        self.at.wrapping_add(self.x.wrapping_mul(columns.into()))
    }
}

/// A triangle's depth, nearness and attributes on one row.
#[derive(Clone, Copy)]
pub(super) struct Surface {
    depth: Attributes,
    nearness: Linear,
    attributes: [Linear; MOST_ATTRIBUTES],
    /// What the attributes were divided by.
    shifts: [i8; MOST_ATTRIBUTES],
    kind: SurfaceKind,
    perspective: bool,
}

impl Stepped for Surface {
    fn advance(&mut self) {
        self.depth.advance();
        self.nearness.at = self.nearness.at.wrapping_add(self.nearness.y);
        for attribute in self.attributes.iter_mut().take(self.kind.attributes) {
            attribute.at = attribute.at.wrapping_add(attribute.y);
        }
    }
}

/// Pixels from a run's first to the next one's at most, a power of two.
const RUN: i32 = LONGEST_RUN as i32 - 1;

/// `2^31 / n`, rounded to nearest.
const OVER: [i32; RUN as usize] = {
    let mut table = [0; RUN as usize];
    let mut n = 2;
    while n < RUN as usize {
        #[expect(clippy::indexing_slicing, reason = "evaluated by the compiler")]
        {
            table[n] = (((1u64 << 32) / n as u64 + 1) >> 1) as i32;
        }
        n += 1;
    }
    table
};

impl Surface {
    pub(super) fn new(
        plane: &Plane,
        shape: &Shape<'_>,
        corners: &Corners,
        row: i32,
    ) -> Option<Self> {
        let mut surface = Self {
            depth: Attributes::depth(plane, shape, row)?,
            nearness: Linear::default(),
            attributes: [Linear::default(); MOST_ATTRIBUTES],
            shifts: [0; MOST_ATTRIBUTES],
            kind: corners.kind,
            perspective: corners.perspective,
        };
        if corners.perspective {
            // A bit less, so that differences fit.
            let nearness = corners.nearness.map(|n| n >> 1);
            surface.nearness = Linear::new(plane, shape, nearness, row)?;
        }
        let slots = surface.attributes.iter_mut().zip(&mut surface.shifts);
        for (which, (attribute, shift)) in slots.enumerate().take(corners.kind.attributes) {
            let (values, down) = corners.products(which);
            *attribute = Linear::new(plane, shape, values, row)?;
            *shift = down as i8;
        }
        Some(surface)
    }

    /// Hands on a span in runs.
    pub(super) fn runs(&self, span: Span<'_>, column: i32, shade: &dyn Fn(&mut Run<'_>)) {
        let Span {
            mut indices,
            mut depths,
            place: [mut left, row],
        } = span;
        let z = &self.depth.z;
        let mut from = self.values(left - column);
        loop {
            let last = indices.len() as i32 - 1;
            let pixels = self.run(left - column).min(last);
            let to = self.values(left - column + pixels);
            let step = steps(&from, &to, pixels, self.kind.attributes);
            // The last run has its last pixel too.
            let count = if pixels == last { last + 1 } else { pixels };
            let Some((here, rest)) = indices.split_at_mut_checked(count as usize) else {
                return;
            };
            let Some((here_depths, rest_depths)) = depths.split_at_mut_checked(count as usize)
            else {
                return;
            };
            shade(&mut Run {
                indices: here,
                depths: here_depths,
                place: [left, row],
                depth: (z.at(left - column), z.gradient.x),
                from,
                step,
                down: if self.kind.footprint {
                    self.down(left - column, &from)
                } else {
                    [0; 2]
                },
            });
            if rest.is_empty() {
                return;
            }
            (indices, depths, left, from) = (rest, rest_depths, left + count, to);
        }
    }

    /// How many pixels a straight line is good for: nearness changes by less than
    /// a 16th (of outlines a 64th), so that the line is off by less than a 64th (a 256th)
    /// of the run's change.
    fn run(&self, columns: i32) -> i32 {
        if !self.perspective {
            return RUN;
        }
        let here = self.nearness.at(columns);
        let change = self.nearness.x.unsigned_abs();
        let room = here.unsigned_abs() >> if self.kind.outlined { 6 } else { 4 };
        let mut pixels = RUN;
        while pixels > 1 && change.saturating_mul(pixels as u64) > room {
            pixels >>= 1;
        }
        pixels
    }

    /// The attributes `columns` to the right, [`RUN_FRACTION`] fractional bits.
    fn values(&self, columns: i32) -> Values {
        let mut values = [0; MOST_ATTRIBUTES];
        let all = self.attributes.iter().zip(self.shifts);
        let all = all.take(self.kind.attributes).zip(&mut values);
        if !self.perspective {
            for ((attribute, _), value) in all {
                *value = (attribute.at(columns) >> AFFINE_DOWN) as i32;
            }
            return values;
        }
        let recip = reciprocal(((self.nearness.at(columns) >> 16) as i32).max(1) as u32);
        for ((attribute, shift), value) in all {
            let product = (attribute.at(columns) >> 16) as i32;
            *value = quotient(product, recip, shift);
        }
        values
    }

    /// The change of the first two from row to row: (P' - a N') / N for the
    /// attribute a = P / N.
    fn down(&self, columns: i32, from: &Values) -> [i32; 2] {
        let mut down = [0; 2];
        let all = self.attributes.iter().zip(self.shifts).zip(from);
        if !self.perspective {
            for (((attribute, _), _), down) in all.zip(&mut down) {
                *down = (attribute.y >> AFFINE_DOWN) as i32;
            }
            return down;
        }
        let recip = reciprocal(((self.nearness.at(columns) >> 16) as i32).max(1) as u32);
        let narrow = |v: i64| (v >> 16).clamp(-(1 << 30), 1 << 30) as i32;
        // How nearness changes in its own terms, 14 fractional bits.
        let ratio = quotient(narrow(self.nearness.y), recip, 1);
        for (((attribute, shift), from), down) in all.zip(&mut down) {
            let own = quotient(narrow(attribute.y), recip, shift);
            let lens = ((i64::from(*from) * i64::from(ratio)) >> RUN_FRACTION) as i32;
            *down = own.wrapping_sub(lens);
        }
        down
    }
}

/// An attribute from its product with nearness (half of it, as it is held), with
/// [`RUN_FRACTION`] fractional bits.
#[inline(always)]
fn quotient(product: i32, recip: Reciprocal, shift: i8) -> i32 {
    // product * 2^shift / (2 * half): high * 2^(32 + shift + recip.shift - 62 - 1).
    let high = mul_high(product, recip.mantissa);
    let up = i32::from(shift) + recip.shift as i32 - 31 + RUN_FRACTION as i32;
    if up >= 0 {
        high << up.min(31)
    } else {
        high >> up.wrapping_neg().min(31)
    }
}

/// The change a pixel over `pixels` steps.
fn steps(from: &Values, to: &Values, pixels: i32, count: usize) -> Values {
    let mut step = [0; MOST_ATTRIBUTES];
    let over = OVER.get(pixels as usize).copied().unwrap_or(0);
    for (step, (from, to)) in step.iter_mut().zip(from.iter().zip(to)).take(count) {
        let change = to.wrapping_sub(*from);
        *step = match pixels {
            ..=1 => change,
            RUN => change >> RUN.ilog2(),
            _ => mul_high(change, over) << 1,
        };
    }
    step
}
