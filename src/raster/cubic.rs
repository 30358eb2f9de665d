//! Spans of surfaces that are asked for a texel a pixel, and no more: in runs that are longer than others,
//! along cubics. Those that hide all that is behind them come here if they are all seen.
//!
//! With r = (N1 - N0) / N1 of nearness at a run's ends, an attribute has gone
//! t + t (1 - t) r / (1 - (1 - t) r) of its change after the part t of the run. What is near to that:
//!
//! ```text
//! t + t (1 - t) (p - q t)        p = r + r^2 + 0.848 r^3 + 0.631 r^4        q = r p
//! ```
//!
//! It is off by less than a 2500th if r is in -1/3..3/11, and than a 100,000th in -1/15..1/17. The
//! factors are fitted (the first two are 0.9986 for the wider range); q = r p makes it the same from
//! either end.

use super::footprint::Footprint;
use super::run::{Shade, Values};
use super::surface_planes::{Here, OVER, Surface};
use crate::math::{Depth, mul_high};

/// Fractional bits that changes of [`Fours`] have more than what changes.
pub const FINE: u32 = 2;

/// Attributes of pixels side by side, along lines of four pixels; where an outline is cut out by
/// the first two, those go along parabolas of four.
#[derive(Clone, Copy, Debug)]
pub struct Fours<const N: usize> {
    /// Of the first pixel.
    pub from: Values<N>,
    /// Their change from pixel to pixel, of the first four, [`FINE`]: modulo 2^32.
    pub step: Values<N>,
    /// How that changes to the next four, [`FINE`].
    pub bend: Values<N>,
    /// How that changes from four to four, [`FINE`].
    pub twist: Values<N>,
}

impl<const N: usize> Fours<N> {
    /// Those of the `number`th pixel, modulo `2^(32 - FINE)`; of outlines the first two.
    #[inline(always)]
    pub fn at(&self, number: i32, outlined: bool) -> Values<N> {
        let (fours, rest) = (number >> 2, number & 3);
        // Of the numbers below, and of their sums.
        let pairs = (fours * (fours - 1)) >> 1;
        let triples = pairs * (fours - 2) / 3;
        let mut at = self.from;
        let all = self.step.iter().zip(self.bend).zip(self.twist);
        for (at, ((step, bend), twist)) in at.iter_mut().zip(all) {
            let steps = step.wrapping_mul(number);
            let bends = bend.wrapping_mul(4 * pairs + fours * rest);
            let twists = twist.wrapping_mul(4 * triples + pairs * rest);
            let mut change = steps.wrapping_add(bends).wrapping_add(twists);
            if outlined {
                let bend = bend.wrapping_add(twist.wrapping_mul(fours));
                change = change.wrapping_add((bend >> 3).wrapping_mul(rest * (rest - 4)));
            }
            *at = at.wrapping_add(change >> FINE);
        }
        at
    }
}

/// Pixels side by side whose attributes go along cubics.
#[derive(Debug)]
pub struct Cubic<'t, const A: usize, C = u8> {
    /// Palette indices, or what else is [`Stored`](crate::frame::Stored).
    pub indices: &'t mut [C],
    /// Depths, as many, with that of the first pixel, 16.16, and its change a pixel; none if all
    /// are in place already.
    pub depths: Option<(&'t mut [Depth], (u32, i32))>,
    /// Screen column and row of the first pixel.
    pub place: [i32; 2],
    /// Attributes of the first one, and of the last or the one after it.
    pub ends: [Values<A>; 2],
    /// Attributes of all.
    pub fours: Fours<A>,
    /// What [`Shade::alike`] gave.
    pub alike: usize,
}

/// Pixels from a run's first to the next one's at most.
pub(super) const LONGEST: i32 = 128;

/// Where they are to be fewer, others are as good.
const FEWEST: i32 = 8;

impl<const A: usize> Surface<A> {
    /// Draws pixels of a span, as far as that goes along cubics; says how many of the first ones.
    /// `depths` are none if all are in place.
    #[inline(never)]
    pub(super) fn cubics<C>(
        &self,
        (mut indices, mut depths): (&mut [C], Option<&mut [Depth]>),
        ([mut left, row], column): ([i32; 2], i32),
        (from, footprint): (&Here<A>, &Footprint),
        shade: &impl Shade<A, C>,
    ) -> usize {
        let (mut from, mut footprint, mut drawn) = (*from, *footprint, 0);
        while !indices.is_empty() {
            let (alike, count) =
                self.alike(indices.len(), left - column, (&from, &footprint), shade);
            let Some((mut all, rest)) = indices.split_at_mut_checked(count) else {
                break;
            };
            while let Some(last) = all.len().checked_sub(1) {
                let pixels = self.reach(&from);
                if pixels < FEWEST {
                    return drawn;
                }
                let pixels = pixels.min(last as i32);
                let to = self.here(left - column + pixels, &from);
                // The last run has its last pixel too.
                let count = pixels as usize + usize::from(pixels as usize == last);
                let Some((here, rest)) = all.split_at_mut_checked(count) else {
                    return drawn;
                };
                let depths = depths.as_deref_mut().map(|depths| {
                    let depths = depths.get_mut(drawn..drawn + count).unwrap_or_default();
                    (depths, self.depth(left - column))
                });
                let mut fours = self.fours(&from, &to, pixels);
                if self.kind.outlined {
                    // Parabolas start where they are.
                    let exact = fours.from.iter_mut().zip(from.values);
                    exact.take(2).for_each(|(at, exact)| *at = exact);
                }
                let run = Cubic {
                    indices: here,
                    depths,
                    place: [left, row],
                    ends: [from.values, to.values],
                    fours,
                    alike,
                };
                if !shade.cubic(run) {
                    return drawn;
                }
                left += count as i32;
                drawn += count;
                (all, from) = (rest, to);
            }
            indices = rest;
            if !indices.is_empty() {
                (from, footprint) = self.start(left - column);
            }
        }
        drawn
    }

    /// What pixels to a span's end have in common for [`Shade::cubic`], and how many of the first
    /// ones.
    #[inline(always)]
    fn alike<C>(
        &self,
        pixels: usize,
        columns: i32,
        (from, footprint): (&Here<A>, &Footprint),
        shade: &impl Shade<A, C>,
    ) -> (usize, usize) {
        if !self.kind.footprint || pixels <= 1 {
            return shade.alike(footprint, &Footprint::default(), pixels);
        }
        // Where nearness changes by no more than a quarter, footprints are good along a line.
        let mut last = pixels as i32 - 1;
        let nearness = self.nearness.at(columns + last).max(1) as u32;
        if self.perspective && nearness.abs_diff(from.nearness) > nearness.min(from.nearness) >> 2 {
            last = last.min(self.reach(from));
        }
        let (_, to) = self.start(columns + last);
        let step = self.footprint_step(*footprint, to, last);
        shade.alike(footprint, &step, last as usize + 1)
    }

    /// How many pixels a cubic is good for, in whole fours: nearness grows by less than 3/8 or
    /// shrinks by less than a quarter; of outlines by less than a 16th either way.
    #[inline(always)]
    fn reach(&self, here: &Here<A>) -> i32 {
        if !self.perspective {
            return LONGEST;
        }
        let mut room = here.nearness >> 2;
        if self.kind.outlined {
            room >>= 2;
        } else if self.nearness.x > 0 {
            room += room >> 1;
        }
        let over = self.over_change;
        // room * mantissa * 2^(shift - 62)
        let pixels = mul_high(room as i32, over.mantissa) >> (30 - over.shift as i32).max(0);
        pixels.min(LONGEST) & !3
    }

    /// From one pixel to another, `pixels` to the right.
    #[inline(always)]
    fn fours(&self, from: &Here<A>, to: &Here<A>, pixels: i32) -> Fours<A> {
        let over = OVER.get(pixels as usize).copied().unwrap_or(0);
        let [bend, twist] = self.parts(from, to, pixels, over);
        // All but one bit that there is room for.
        let (factor, up) = if pixels <= 4 {
            (over, 1 + FINE)
        } else {
            (over << 2, FINE - 1)
        };
        // With f fours, twists add (f - 2) / 2 to the bend in the middle, bends and twists
        // (f - 1) / 2 and (f - 1) (f - 2) / 6 to the mean step.
        let bends = pixels - 4;
        let twists = (bends * (pixels - 8) * 683) >> 10;
        let mut fours = Fours {
            from: from.values,
            step: [0; A],
            bend: [0; A],
            twist: [0; A],
        };
        let ends = from.values.iter().zip(to.values);
        let all = fours.from.iter_mut().zip(&mut fours.step);
        let all = all.zip(&mut fours.bend).zip(&mut fours.twist).zip(ends);
        for ((((at, own_step), own_bend), own_twist), (from, to)) in all.take(self.count()) {
            let change = to.wrapping_sub(*from);
            let (middle, twist) = (mul_high(change, bend), mul_high(change, twist));
            // What rounding leaves off in the twist, the bend makes up for in the middle, and the
            // step for both at the end.
            let bend = middle.wrapping_sub(twist.wrapping_mul(pixels - 8) >> 3);
            *own_step = (mul_high(change, factor) << up | 1)
                .wrapping_sub(bend.wrapping_mul(bends) >> 3)
                .wrapping_sub(twist.wrapping_mul(twists) >> 6);
            (*own_bend, *own_twist) = (bend, twist);
            // Lines lie as much above the curve as below.
            let middle = middle.wrapping_add(twist);
            *at = at.wrapping_sub(middle.wrapping_add(middle >> 2) >> (2 + FINE));
        }
        fours
    }

    /// The bend in the middle and the twist of what changes by 1, 32 fractional bits and [`FINE`];
    /// `over` is 1 / pixels, 31 fractional bits.
    #[inline(always)]
    fn parts(&self, from: &Here<A>, to: &Here<A>, pixels: i32, over: i32) -> [i32; 2] {
        if pixels < 4 || !self.perspective {
            return [0; 2];
        }
        let nearer = to.nearness.wrapping_sub(from.nearness) as i32;
        let high = mul_high(nearer, to.recip.mantissa);
        let ratio = high << ((to.recip.shift + 1) & 31);
        if self.kind.outlined {
            return fine_parts(ratio, over);
        }
        // 16 fractional bits, but for 17 of this and 31 of `over`.
        let short = (over + (1 << 13)) >> 14;
        let ratio = ((ratio >> 14) + 1) >> 1;
        let times = |a: i32, b: i32| a.wrapping_mul(b) >> 16;
        let sum = times(ratio, 41364) + 55580;
        let sum = times(ratio, times(ratio, sum) + 65442) + 65448;
        let p = times(ratio, sum);
        let q = times(ratio, p);
        // Four pixels' second differences, 4 (q - 2 p) / n^2 in the middle and 96 q / n^3: first
        // without one n, 31 fractional bits.
        let bend = (q - 2 * p).wrapping_mul(short);
        let twist = (q.wrapping_mul(short) >> 14).wrapping_mul(3 * short);
        [bend, twist].map(|part| mul_high(part, over) << 4)
    }
}

/// The same for outlines, where nearness changes less, which leaves room for two bits more: from r
/// and 1 / pixels, 31 fractional bits both.
#[inline(never)]
fn fine_parts(ratio: i32, over: i32) -> [i32; 2] {
    // 18 fractional bits.
    let ratio = ((ratio >> 12) + 1) >> 1;
    let times = |a: i32, b: i32| a.wrapping_mul(b) >> 18;
    let sum = times(ratio, 41364) + 55580;
    let sum = times(ratio, times(ratio, sum) + (1 << 16)) + (1 << 16);
    let p = ratio.wrapping_mul(sum) >> 16;
    let q = times(ratio, p);
    // Of long runs a shorter number than `over` has too few bits.
    let bend = mul_high((q - 2 * p) << 13, over) << 3;
    let twist = mul_high(3 * mul_high(q << 17, over), over) << 7;
    [mul_high(bend, over) << 4, mul_high(twist, over)]
}
