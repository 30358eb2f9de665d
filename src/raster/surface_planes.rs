//! Depth, nearness and attributes of a surface's triangle, row by row and run by run.

use super::attribute::Attribute;
use super::attributes::Attributes;
use super::corners::{Corners, SurfaceKind};
use super::cubic::LONGEST;
use super::footprint::Footprint;
use super::gradient::Plane;
use super::nearer::put_nearer;
use super::run::{LONGEST_RUN, MOST_ATTRIBUTES, Path, RUN_FRACTION, Run, Shade, Values};
use super::scan::{Shape, Span, Stepped};
use crate::frame::Stored;
use crate::math::{HALF_PX, Reciprocal, SUBPX_BITS, mul_high, reciprocal};

/// A quantity that is linear on the screen, at the centre of one pixel, and its
/// change a pixel: 16 fractional bits.
#[derive(Clone, Copy, Default)]
pub(super) struct Linear {
    at: i64,
    pub x: i64,
    pub y: i64,
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

    /// The whole part `columns` (below 2^14 either way) to the right. In two 32-bit
    /// halves: what lies inside the triangle is in range.
    #[inline(always)]
    pub fn at(&self, columns: i32) -> i32 {
        let low = |v: i64| (v & 0xffff) as i32;
        let high = |v: i64| (v >> 16) as i32;
        let rest = low(self.x) * columns + low(self.at);
        high(self.at)
            .wrapping_add(high(self.x).wrapping_mul(columns))
            .wrapping_add(rest >> 16)
    }
}

/// A triangle's depth, nearness and attributes on one row.
#[derive(Clone, Copy)]
pub(super) struct Surface<const A: usize> {
    depth: Attribute,
    pub nearness: Linear,
    /// 1 / (change of nearness a pixel, without its sign), in perspective.
    pub over_change: Reciprocal,
    pub attributes: [Linear; A],
    /// What the attributes were divided by.
    pub shifts: [i8; A],
    /// Changes a pixel and a row of what footprints need in perspective, whole parts: of the first
    /// two attributes, and of nearness.
    pub changes: [[i32; 3]; 2],
    pub kind: SurfaceKind,
    pub perspective: bool,
}

impl<const A: usize> Stepped for Surface<A> {
    fn advance(&mut self) {
        self.depth.advance();
        self.nearness.at = self.nearness.at.wrapping_add(self.nearness.y);
        let count = self.count();
        for attribute in self.attributes.iter_mut().take(count) {
            attribute.at = attribute.at.wrapping_add(attribute.y);
        }
    }
}

/// Pixels from a run's first to the next one's at most, a power of two.
const RUN: i32 = LONGEST_RUN as i32 - 1;

/// `2^31 / n`, rounded to nearest; for 1, as near to it as fits.
pub(super) const OVER: [i32; LONGEST as usize + 1] = {
    let mut table = [0; LONGEST as usize + 1];
    let mut n = 2;
    table[1] = i32::MAX;
    while n <= LONGEST as usize {
        #[expect(clippy::indexing_slicing, reason = "evaluated by the compiler")]
        {
            table[n] = (((1u64 << 32) / n as u64 + 1) >> 1) as i32;
        }
        n += 1;
    }
    table
};

impl<const A: usize> Surface<A> {
    pub(super) fn new(shape: &Shape<'_>, corners: &Corners<A>, row: i32) -> Option<Self> {
        let plane = &Plane::new(shape.sorted, shape.area);
        let mut surface = Self {
            depth: Attributes::depth(shape, row)?,
            nearness: Linear::default(),
            over_change: Reciprocal::default(),
            attributes: [Linear::default(); A],
            shifts: [0; A],
            changes: [[0; 3]; 2],
            kind: corners.kind,
            perspective: corners.perspective,
        };
        if corners.perspective {
            // A bit less, so that differences fit.
            let nearness = corners.nearness.map(|n| n >> 1);
            surface.nearness = Linear::new(plane, shape, nearness, row)?;
            // Rounded up.
            let change = (surface.nearness.x.unsigned_abs() >> 16) as u32 + 1;
            surface.over_change = reciprocal(change);
        }
        let slots = surface.attributes.iter_mut().zip(&mut surface.shifts);
        for (which, (attribute, shift)) in slots.enumerate().take(corners.kind.attributes) {
            let (values, down) = corners.products(which);
            *attribute = Linear::new(plane, shape, values, row)?;
            *shift = down as i8;
        }
        if corners.kind.footprint {
            surface.changes = surface.changes_of_planes();
        }
        Some(surface)
    }

    /// How many attributes there are: known beforehand to kernels of their own.
    #[inline(always)]
    pub(super) fn count(&self) -> usize {
        if A < MOST_ATTRIBUTES {
            A
        } else {
            self.kind.attributes
        }
    }

    /// Hands on a span in runs, or in longer ones if that is enough.
    #[inline(always)]
    pub(super) fn runs<C: Stored>(&self, span: Span<'_, C>, column: i32, shade: &impl Shade<A, C>) {
        let Span {
            mut indices,
            mut depths,
            place: [mut left, row],
        } = span;
        let (mut from, mut footprint) = self.start(left - column);
        let mut seen = 0;
        if shade.solid() {
            let (z, dz) = self.depth(left - column);
            seen = put_nearer(depths, z, dz);
        }
        if shade.cubics() && (seen == indices.len() || !shade.solid()) {
            let pixels = (&mut *indices, (!shade.solid()).then_some(&mut *depths));
            let place = ([left, row], column);
            let drawn = self.cubics(pixels, place, (&from, &footprint), shade);
            (indices, depths) = match (indices.get_mut(drawn..), depths.get_mut(drawn..)) {
                (Some(rest), Some(rest_depths)) if !rest.is_empty() => (rest, rest_depths),
                _ => return,
            };
            if drawn != 0 {
                left += drawn as i32;
                seen = seen.saturating_sub(drawn);
                (from, footprint) = self.start(left - column);
            }
        }
        loop {
            let depth = self.depth(left - column);
            let last = indices.len() as i32 - 1;
            let pixels = self.run(&from).min(last);
            let to = self.here(left - column + pixels, &from);
            let path = self.path(&from, &to, pixels);
            // The last run has its last pixel too.
            let count = if pixels == last { last + 1 } else { pixels };
            let next = self.footprint(&to);
            let footprint_step = self.footprint_step(footprint, next, pixels);
            let (Some(here), Some(here_depths)) = (
                indices.get_mut(..count as usize),
                depths.get_mut(..count as usize),
            ) else {
                return;
            };
            let drawn = shade.run(Run {
                indices: here,
                depths: here_depths,
                place: [left, row],
                depth,
                seen: seen.min(count as usize),
                path,
                footprint,
                footprint_step,
            });
            (indices, depths) = match (indices.get_mut(drawn..), depths.get_mut(drawn..)) {
                (Some(rest), Some(rest_depths)) if !rest.is_empty() => (rest, rest_depths),
                _ => return,
            };
            left += drawn as i32;
            seen = seen.saturating_sub(drawn);
            if seen == 0 && shade.solid() {
                let (z, dz) = self.depth(left - column);
                seen = put_nearer(depths, z, dz);
            }
            (from, footprint) = (to, next);
            if drawn as i32 != pixels {
                (from, footprint) = self.start(left - column);
            }
        }
    }

    /// The depth `columns` to the right, 16.16, and its change a pixel.
    #[inline(always)]
    pub(super) fn depth(&self, columns: i32) -> (u32, i32) {
        (self.depth.at(columns), self.depth.gradient.x)
    }

    /// What is `columns` to the right, and its footprint. There once: it is long.
    #[inline(never)]
    pub(super) fn start(&self, columns: i32) -> (Here<A>, Footprint) {
        let here = self.here(columns, &Here::default());
        (here, self.footprint(&here))
    }

    /// How many pixels a parabola is good for: nearness changes by less than a quarter
    /// (of outlines a 32nd), so that the parabola is off by less than a 200th (a 12,800th)
    /// of the run's change. In runs of 64 pixels nearness changes by less than a 32nd, so that they are
    /// off by no more than most of 32 are.
    #[inline(always)]
    fn run(&self, here: &Here<A>) -> i32 {
        if !self.perspective {
            return RUN;
        }
        // Rounded up.
        let change = (self.nearness.x.unsigned_abs() >> 16) as u32 + 1;
        if change <= here.nearness >> (5 + RUN.ilog2()) && !self.kind.outlined {
            return RUN;
        }
        let (room, mut bits) = if self.kind.outlined {
            (here.nearness >> 5, RUN.ilog2() - 2)
        } else {
            (here.nearness >> 2, RUN.ilog2() - 1)
        };
        while bits > 0 && change > room >> bits {
            bits -= 1;
        }
        1 << bits
    }

    /// What is `columns` to the right; along many spans nearness is what it was before.
    #[inline(always)]
    pub(super) fn here(&self, columns: i32, before: &Here<A>) -> Here<A> {
        let mut values = [0; A];
        let all = self.attributes.iter().zip(self.shifts);
        let all = all.take(self.count()).zip(&mut values);
        let (mut nearness, mut recip) = (before.nearness, before.recip);
        if self.perspective {
            nearness = self.nearness.at(columns).max(1) as u32;
            if nearness != before.nearness {
                recip = reciprocal(nearness);
            }
            for ((attribute, shift), value) in all {
                *value = quotient(attribute.at(columns), recip, shift);
            }
        } else {
            for ((attribute, _), value) in all {
                *value = attribute.at(columns);
            }
        }
        Here {
            nearness,
            recip,
            values,
        }
    }

    /// From one pixel to another, over `pixels` steps: a parabola with
    /// the ends and the middle of P / N, which is off a straight line by
    /// `change * t (1 - t) (N1 - N0) / N` after the part t of the run.
    #[inline(always)]
    fn path(&self, from: &Here<A>, to: &Here<A>, pixels: i32) -> Path<A> {
        let (mut steps, mut bends) = ([0; A], [0; A]);
        let ends = from.values.iter().zip(&to.values);
        let all = steps.iter_mut().zip(&mut bends).zip(ends);
        let all = all.take(self.count());
        // In the middle, 31 fractional bits: from the end, where 1 / N is known. One step
        // has no middle. Below a half, as the run was chosen by it.
        let nearer = to.nearness.wrapping_sub(from.nearness) as i32;
        let high = mul_high(nearer, to.recip.mantissa);
        let ratio = high << ((to.recip.shift + 1) & 31);
        // r / (1 - r / 2), by its first three terms; mul_high halves.
        let square = mul_high(ratio, ratio);
        let cube = mul_high(square, ratio);
        let ratio = ratio.wrapping_add(square).wrapping_add(cube);
        let ratio = if pixels == 1 { 0 } else { ratio };
        let over = OVER.get(pixels as usize).copied().unwrap_or(0);
        for ((step, bend), (from, to)) in all {
            let change = to.wrapping_sub(*from);
            // At most a third of the change: four times its part a pixel fits.
            let off = mul_high(change, ratio) << 1;
            let own = mul_high(off << 1, over);
            *bend = -mul_high((own << 2).wrapping_add(pixels), over);
            // What rounding leaves off in the bend adds up to half the run's square: the step
            // makes up for it at the end, so that an eighth of the square is left in the
            // middle. Rounded as well.
            let bent = bend.wrapping_mul(pixels - 1) >> 1;
            *step = (mul_high(change, over) << 1 | 1).wrapping_sub(bent);
        }
        Path {
            from: from.values,
            step: steps,
            bend: bends,
        }
    }
}

/// A surface at one pixel.
#[derive(Clone, Copy)]
pub(super) struct Here<const A: usize> {
    /// 1 / distance, and its reciprocal: in perspective alone.
    pub nearness: u32,
    pub recip: Reciprocal,
    /// The attributes, [`RUN_FRACTION`] fractional bits.
    pub values: Values<A>,
}

impl<const A: usize> Default for Here<A> {
    fn default() -> Self {
        Self {
            nearness: 0,
            recip: Reciprocal::default(),
            values: [0; A],
        }
    }
}

/// An attribute from its product with nearness (half of it, as it is held), with
/// [`RUN_FRACTION`] fractional bits.
#[inline(always)]
pub(super) fn quotient(product: i32, recip: Reciprocal, shift: i8) -> i32 {
    // product * 2^shift / (2 * half): high * 2^(32 + shift + recip.shift - 62 - 1).
    let high = mul_high(product, recip.mantissa);
    // Within -31..=31, as shifts are.
    let up = i32::from(shift) + recip.shift as i32 - 31 + RUN_FRACTION as i32;
    if up >= 0 {
        high << (up & 31)
    } else {
        high >> (up.wrapping_neg() & 31)
    }
}
