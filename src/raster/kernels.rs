//! The kernels of surfaces that have a light level: what each sets up a triangle,
//! and which loop it runs a span.

use super::attributes::Attributes;
use super::gradient::Plane;
use super::perspective;
use super::scan::{Kernel, Shape, Span};
use super::sliver;
use super::span::{self, Fill};
use crate::math::SUBPX_BITS;

/// One palette index.
pub(super) struct Flat<'a> {
    pub shape: &'a Shape<'a>,
    pub index: u8,
}

impl Kernel for Flat<'_> {
    type Planes = Attributes;

    #[inline(always)]
    fn setup(&self, plane: &Plane, row: i32) -> Option<Attributes> {
        Attributes::depth(plane, self.shape, row)
    }

    #[inline(always)]
    fn draw(&mut self, span: Span<'_>, at: &Attributes) {
        let z = at.z.at(columns(self.shape, &span));
        span::flat(span.indices, span.depths, z, at.z.gradient.x, self.index);
    }

    fn sliver(&mut self, span: Span<'_>) {
        sliver::span(span, self.shape, Fill::Flat(self.index));
    }
}

/// Depth alone.
pub(super) struct DepthOnly<'a> {
    pub shape: &'a Shape<'a>,
}

impl Kernel for DepthOnly<'_> {
    type Planes = Attributes;

    #[inline(always)]
    fn setup(&self, plane: &Plane, row: i32) -> Option<Attributes> {
        Attributes::depth(plane, self.shape, row)
    }

    #[inline(always)]
    fn draw(&mut self, span: Span<'_>, at: &Attributes) {
        let z = at.z.at(columns(self.shape, &span));
        span::depth(span.depths, z, at.z.gradient.x);
    }

    fn sliver(&mut self, span: Span<'_>) {
        sliver::span(span, self.shape, Fill::Depth);
    }
}

/// A light level, interpolated along the screen.
pub(super) struct Gouraud<'a> {
    pub shape: &'a Shape<'a>,
    pub shades: &'a [u8; 256],
}

impl Kernel for Gouraud<'_> {
    type Planes = Attributes;

    #[inline(always)]
    fn setup(&self, plane: &Plane, row: i32) -> Option<Attributes> {
        Attributes::depth_and_level(plane, self.shape, row)
    }

    #[inline(always)]
    fn draw(&mut self, span: Span<'_>, at: &Attributes) {
        let columns = columns(self.shape, &span);
        let z = (at.z.at(columns), at.z.gradient.x);
        let level = (at.level.at(columns), at.level.gradient.x);
        span::gouraud(span.indices, span.depths, z, level, self.shades);
    }

    fn sliver(&mut self, span: Span<'_>) {
        sliver::span(span, self.shape, Fill::Gouraud(self.shades));
    }
}

/// A light level, interpolated in perspective.
pub(super) struct InPerspective<'a> {
    pub shape: &'a Shape<'a>,
    pub shades: &'a [u8; 256],
}

impl Kernel for InPerspective<'_> {
    type Planes = Attributes;

    #[inline(always)]
    fn setup(&self, plane: &Plane, row: i32) -> Option<Attributes> {
        Attributes::for_perspective(plane, self.shape, row)
    }

    #[inline(always)]
    fn draw(&mut self, span: Span<'_>, at: &Attributes) {
        let columns = columns(self.shape, &span);
        let planes = (&at.z, &at.level);
        perspective::gouraud(span.indices, span.depths, planes, columns, self.shades);
    }

    fn sliver(&mut self, span: Span<'_>) {
        sliver::span(span, self.shape, Fill::Gouraud(self.shades));
    }
}

/// From the attributes' place, the top vertex's column, to a span's first pixel.
#[inline(always)]
fn columns(shape: &Shape<'_>, span: &Span<'_>) -> i32 {
    let [top, ..] = shape.sorted;
    let [left, _] = span.place;
    left - (top.x.to_bits() >> SUBPX_BITS)
}
