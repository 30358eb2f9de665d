//! Triangles of surfaces that need more than a light level: any few attributes,
//! interpolated in perspective and handed on in runs of pixels.
//!
//! Each attribute times 1 / distance, and 1 / distance itself, are linear on the
//! screen. They are held in 64 bits, exact to 2^-28 of their largest value, and
//! divided at the ends of runs so short that a straight line between does not show
//! (Heckbert and Moreton, "Interpolation for polygon texture mapping and shading",
//! 1991).

use super::attributes::Attributes;
use super::gradient::{Plane, places};
use super::scan::{Kernel, Shape, Span, Stepped, scan};
use super::sliver::{WEIGHT_BITS, mix, weights};
use super::triangle::{Drawn, Sides, shown, sort};
use crate::frame::Target;
use crate::math::{Depth, HALF_PX, SUBPX_BITS, mul_high, reciprocal};
use crate::vertex::ScreenVertex;

/// Attributes that a surface has at most.
pub const MOST_ATTRIBUTES: usize = 11;

/// One number for each attribute; those past the surface's count mean nothing.
pub type Values = [i32; MOST_ATTRIBUTES];

/// Fractional bits of an attribute in a [`Run`].
pub const RUN_FRACTION: u32 = 14;

/// What a corner of a triangle has besides its place on the screen.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Corner {
    /// Distance along the line of sight, at least 1, in any unit; the same at all
    /// corners for interpolation along the screen.
    pub distance: i32,
    /// Within -2^15..=2^15.
    pub attributes: Values,
}

/// Pixels side by side, with what is drawn there.
#[derive(Debug)]
pub struct Run<'t> {
    /// Palette indices.
    pub indices: &'t mut [u8],
    /// Depths; as many.
    pub depths: &'t mut [Depth],
    /// Screen column and row of the first pixel.
    pub place: [i32; 2],
    /// Depth of the first pixel, 16.16, and its change a pixel.
    pub depth: (u32, i32),
    /// Attributes of the first pixel, [`RUN_FRACTION`] fractional bits.
    pub from: Values,
    /// Their change a pixel.
    pub step: Values,
    /// Change of the first two from row to row at the first pixel, where asked for.
    pub down: [i32; 2],
}

impl Run<'_> {
    /// Goes through the pixels that are nearer than what stands there. `shade` gets
    /// the pixel's number in the run, the first `N` attributes and the index there,
    /// and gives the new one; the depth follows if `solid`.
    #[inline(always)]
    pub fn draw<const N: usize>(
        &mut self,
        solid: bool,
        mut shade: impl FnMut(i32, &[i32; N], u8) -> Option<u8>,
    ) {
        let (mut z, dz) = self.depth;
        let (mut values, mut steps) = ([0; N], [0; N]);
        values.iter_mut().zip(self.from).for_each(|(v, c)| *v = c);
        steps.iter_mut().zip(self.step).for_each(|(v, c)| *v = c);
        let pixels = self.indices.iter_mut().zip(self.depths.iter_mut());
        for ((pixel, depth), number) in pixels.zip(0..) {
            let here = (z >> 16) as Depth;
            if here > *depth
                && let Some(index) = shade(number, &values, *pixel)
            {
                *pixel = index;
                if solid {
                    *depth = here;
                }
            }
            z = z.wrapping_add_signed(dz);
            for (value, step) in values.iter_mut().zip(steps) {
                *value = value.wrapping_add(step);
            }
        }
    }
}

/// What a surface is made of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SurfaceKind {
    /// Attributes in use.
    pub attributes: usize,
    /// Whether runs say how the first two change from row to row.
    pub footprint: bool,
}

/// Draws a triangle if it shows one of `sides`, run by run; `corners` is asked for
/// only then, in the order of the vertices.
#[inline(never)]
pub fn draw_surface(
    target: &mut Target<'_>,
    triangle: [&ScreenVertex; 3],
    sides: Sides,
    kind: SurfaceKind,
    corners: &mut dyn FnMut() -> [Corner; 3],
    shade: &mut dyn FnMut(&mut Run<'_>),
) -> Drawn {
    let (area, rows) = match shown(target, triangle, sides) {
        Ok(shown) => shown,
        Err(drawn) => return drawn,
    };
    let [a, b, c] = triangle;
    let [ka, kb, kc] = corners();
    let (sorted, area) = sort([(a, ka), (b, kb), (c, kc)], area);
    let corners = Corners::new(sorted.each_ref().map(|(_, corner)| corner), kind);
    let shape = Shape {
        sorted: sorted.map(|(v, _)| v),
        area,
        rows,
        perspective: corners.perspective,
    };
    let mut kernel = Runs {
        shape: &shape,
        corners: &corners,
        shade,
    };
    scan(target, &shape, &mut kernel);
    Drawn::Filled
}

/// The kernel.
struct Runs<'a, 's> {
    shape: &'a Shape<'a>,
    corners: &'a Corners,
    shade: &'s mut dyn FnMut(&mut Run<'_>),
}

impl Kernel for Runs<'_, '_> {
    type Planes = Surface;

    fn setup(&self, plane: &Plane, row: i32) -> Option<Surface> {
        Surface::new(plane, self.shape, self.corners, row)
    }

    fn draw(&mut self, span: Span<'_>, surface: &Surface) {
        let [top, ..] = self.shape.sorted;
        surface.runs(span, top.x.to_bits() >> SUBPX_BITS, self.shade);
    }

    fn sliver(&mut self, span: Span<'_>) {
        sliver(span, self.shape, self.corners, self.shade);
    }
}

/// The three corners, sorted, with 1 / distance.
struct Corners {
    kind: SurfaceKind,
    /// In units that bring the nearest to 30 or 31 bits; at least 1.
    nearness: [i32; 3],
    attributes: [Values; 3],
    perspective: bool,
}

impl Corners {
    fn new(sorted: [&Corner; 3], kind: SurfaceKind) -> Self {
        let reciprocals = sorted.map(|c| reciprocal(c.distance.max(1) as u32));
        let nearest = reciprocals.iter().fold(0, |m, r| m.max(r.shift));
        let nearness = reciprocals.map(|r| (r.mantissa >> (nearest - r.shift).min(30)).max(1));
        let [a, b, c] = sorted.map(|c| c.distance);
        Self {
            kind,
            nearness,
            attributes: sorted.map(|c| c.attributes),
            perspective: a != b || a != c,
        }
    }

    /// An attribute at the three corners, times nearness in perspective, in 30 bits
    /// and a sign, and the power of two that it was divided by.
    fn products(&self, which: usize) -> ([i32; 3], i32) {
        let mut values = [0; 3];
        for (value, all) in values.iter_mut().zip(&self.attributes) {
            *value = i64::from(all.get(which).copied().unwrap_or(0));
        }
        if !self.perspective {
            return (values.map(|v| (v << AFFINE_FRACTION) as i32), 0);
        }
        for (value, nearness) in values.iter_mut().zip(self.nearness) {
            *value *= i64::from(nearness);
        }
        let bits = values.iter().fold(0, |m, v| m | v.unsigned_abs());
        let down = (34 - bits.leading_zeros() as i32).max(0);
        (values.map(|v| (v >> down) as i32), down)
    }
}

/// Fractional bits of an attribute that is not divided.
const AFFINE_FRACTION: u32 = 13;
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
        let (px, py) = (top.x.to_bits(), top.y.to_bits());
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
struct Surface {
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

/// Pixels of a run at most, a power of two.
const RUN: i32 = 16;

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
    fn new(plane: &Plane, shape: &Shape<'_>, corners: &Corners, row: i32) -> Option<Self> {
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
    fn runs(&self, span: Span<'_>, column: i32, shade: &mut dyn FnMut(&mut Run<'_>)) {
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
    /// a 16th, so that the line is off by less than a 64th of the run's change.
    fn run(&self, columns: i32) -> i32 {
        if !self.perspective {
            return RUN;
        }
        let here = self.nearness.at(columns);
        let change = self.nearness.x.unsigned_abs();
        let room = here.unsigned_abs() >> 4;
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
fn quotient(product: i32, recip: crate::math::Reciprocal, shift: i8) -> i32 {
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

/// Hands on a span of a sliver, pixel by pixel.
#[cold]
#[inline(never)]
fn sliver(
    span: Span<'_>,
    shape: &Shape<'_>,
    corners: &Corners,
    shade: &mut dyn FnMut(&mut Run<'_>),
) {
    let (places, area) = places(shape.sorted, shape.area);
    let depths = shape.sorted.map(|v| i64::from(v.z.to_bits()));
    let Span {
        indices,
        depths: stored,
        place: [left, row],
    } = span;
    let pixels = indices.chunks_mut(1).zip(stored.chunks_mut(1));
    for ((index, depth), column) in pixels.zip(left..) {
        let weights = weights(places, area, [column, row]);
        let z = mix(depths, weights);
        let weights = in_space(corners, weights);
        let mut from = [0; MOST_ATTRIBUTES];
        for (which, value) in from.iter_mut().enumerate().take(corners.kind.attributes) {
            let all = corners.attributes.each_ref();
            let all = all.map(|all| i64::from(all.get(which).copied().unwrap_or(0)));
            *value = mix(all.map(|v| v << RUN_FRACTION), weights) as i32;
        }
        shade(&mut Run {
            indices: index,
            depths: depth,
            place: [column, row],
            depth: (((z as u32) << 12).wrapping_add(1 << 15), 0),
            from,
            step: [0; MOST_ATTRIBUTES],
            down: [0; 2],
        });
    }
}

/// Weights in space from those on the screen.
fn in_space(corners: &Corners, [wb, wc]: [i64; 2]) -> [i64; 2] {
    if !corners.perspective {
        return [wb, wc];
    }
    let [na, nb, nc] = corners.nearness.map(i64::from);
    let [a, b, c] = [((1 << WEIGHT_BITS) - wb - wc) * na, wb * nb, wc * nc];
    let whole = (a + b + c) >> WEIGHT_BITS;
    [b, c].map(|w| {
        let weight = w.checked_div(whole).unwrap_or(0);
        weight.clamp(-1 << WEIGHT_BITS, 2 << WEIGHT_BITS)
    })
}
