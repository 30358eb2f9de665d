//! Triangles of surfaces whose attributes may as well be interpolated along the screen: their
//! pixels are shaded one by one, in the ways that a light level goes. Most of a fine mesh are,
//! and runs, which [`draw_surface`](super::draw_surface) hands on, cost more than their few pixels.

use super::attribute::Attribute;
use super::attributes::Attributes;
use super::gradient::{Gradient, Plane, SmallPlane};
use super::run::{RUN_FRACTION, Values};
use super::scan::{Shape, Span, Stepped, scan};
use super::small::{Planes, Rows, Steps, is_small, turned};
use super::triangle::{Drawn, Seen, Sides, shown, sort};
use crate::frame::{Stored, Target};
use crate::math::{Depth, SUBPX_BITS, keep_rolled};
use crate::vertex::ScreenVertex;

/// What is done with pixels. Not a closure, because that is not inlined where it is called.
pub trait ShadePixel<const A: usize, C> {
    /// What stands at a screen column and row instead of `behind`, if the surface has that pixel;
    /// depth (16.16, and half a unit more) and attributes as in a [`Run`](super::Run).
    fn pixel(
        &self,
        begun: &Self::Begun,
        place: [i32; 2],
        depth: u32,
        values: &Values<A>,
        behind: C,
    ) -> Option<C>;

    /// Whether what lies behind its pixels is hidden by them.
    fn hides(&self) -> bool;

    /// By how much light may differ from corner to corner, in 1/64 of a level, at most 255 of
    /// them; 0 where attributes are the same on the screen and in space.
    fn contrast(&self, corners: &[Values<A>; 3]) -> u32;

    /// Whether a triangle with so many columns and so much area, doubled, in sub-pixels squared,
    /// may go pixel by pixel.
    #[inline(always)]
    fn suits(_columns: i32, _area: u64) -> bool {
        true
    }

    /// What is known of a triangle's corners.
    type Corners;

    /// Sets the attributes of the corners, which are 0 before; `None` if the triangle does not
    /// go pixel by pixel.
    fn set(&self, corners: &mut [Values<A>; 3]) -> Option<Self::Corners>;

    /// What is known of a triangle before its first pixel.
    type Begun;

    /// The same once it is known how depth and attributes change.
    fn begin(
        &self,
        corners: &Self::Corners,
        depth: Gradient,
        values: [Gradient; A],
    ) -> Option<Self::Begun>;
}

/// Draws a triangle if it shows one of `sides`, pixel by pixel; `None` if its attributes have to
/// be interpolated in space, or exceed the formats.
#[inline(never)]
pub fn draw_shaded<const A: usize, C: Stored, S: ShadePixel<A, C>>(
    target: &mut Target<'_, C>,
    triangle: [&ScreenVertex; 3],
    sides: Sides,
    shade: &S,
) -> Option<Drawn> {
    let seen = match shown(target, triangle, sides) {
        Ok(seen) => seen,
        Err(drawn) => return Some(drawn),
    };
    let small = is_small(&seen, target);
    let [[left, _], [right, _]] = seen.bounds;
    if !S::suits((right - left) >> SUBPX_BITS, seen.area.unsigned_abs()) {
        return None;
    }
    let mut values = [[0; A]; 3];
    // Not moved, which is a copy.
    let known = shade.set(&mut values);
    let known = known.as_ref()?;
    if bends(triangle, || shade.contrast(&values)) {
        return None;
    }
    let [a, b, c] = triangle;
    let [va, vb, vc] = &values;
    let with = [(a, va), (b, vb), (c, vc)];
    let done = if small {
        fill_small(target, with, &seen, shade, known)
    } else {
        fill_large(target, with, &seen, shade, known)
    };
    done.then(|| seen.filled())
}

/// A vertex with its attributes.
type With<'a, const A: usize> = (&'a ScreenVertex, &'a Values<A>);

/// Whether interpolation along the screen may be off by a level: see [`super::perspective`]. In
/// narrow triangles as well: where all are narrow, it would show.
#[inline(always)]
fn bends(triangle: [&ScreenVertex; 3], contrast: impl FnOnce() -> u32) -> bool {
    let [a, b, c] = triangle.map(|v| v.z().to_bits() >> 4);
    let (near, far) = (a.max(b).max(c), a.min(b).min(c));
    let depths = near - far;
    // 14 bits, and 16.
    const MOST: u32 = 255 << 6;
    const LEVEL: u32 = 2 + 6;
    depths * MOST > far << LEVEL && contrast() * depths > far << LEVEL
}

/// Fills a small triangle; `false` if its attributes exceed the formats.
#[inline(always)]
fn fill_small<const A: usize, C: Stored, S: ShadePixel<A, C>>(
    target: &mut Target<'_, C>,
    triangle: [With<'_, A>; 3],
    seen: &Seen,
    shade: &S,
    known: &S::Corners,
) -> bool {
    let with = turned(triangle, seen);
    let triangle = with.map(|(v, _)| v);
    let mut rows = Rows::new(target, seen);
    if !rows.find(triangle) {
        return true;
    }
    let mut planes = Planes::ZERO;
    let values = with.map(|(_, values)| values);
    let set = planes.set(triangle, seen, rows.place(), |plane, place| {
        beside(plane, values, place)
    });
    if !set {
        return false;
    }
    let begun = shade.begin(known, planes.depth_change(), planes.changes());
    let Some(begun) = &begun else {
        return false;
    };
    for row in rows.all() {
        if let Some((span, steps)) = rows.span(row, &planes, target) {
            pixels(span, steps, shade, begun);
        }
    }
    true
}

/// The attributes of a small triangle.
#[inline(always)]
fn beside<const A: usize>(
    plane: &SmallPlane,
    [a, b, c]: [&Values<A>; 3],
    place: [i32; 2],
) -> Option<[Attribute; A]> {
    let mut all = [Attribute::ZERO; A];
    for (((attribute, a), b), c) in all.iter_mut().zip(a).zip(b).zip(c) {
        let [whole, b, c] = [a, b, c].map(|v| v >> RUN_FRACTION);
        let gradient = plane.value(b - whole, c - whole)?;
        *attribute = Attribute::beside(*a as u32, gradient, place).unrounded_value();
        keep_rolled();
    }
    Some(all)
}

/// Fills a triangle of any size; `false` if its attributes exceed the formats.
#[inline(never)]
fn fill_large<const A: usize, C: Stored, S: ShadePixel<A, C>>(
    target: &mut Target<'_, C>,
    triangle: [With<'_, A>; 3],
    seen: &Seen,
    shade: &S,
    known: &S::Corners,
) -> bool {
    let (sorted, flipped) = sort(triangle);
    let shape = Shape {
        sorted: sorted.map(|(v, _)| v),
        area: if flipped { -seen.area } else { seen.area },
        rows: seen.rows,
        perspective: false,
    };
    let values = sorted.map(|(_, values)| values);
    let [top, ..] = shape.sorted;
    let column = top.x().to_bits() >> SUBPX_BITS;
    let (first, _) = shape.rows;
    let Some(planes) = Stepping::new(&shape, values, first) else {
        return false;
    };
    let changes = planes.values.each_ref().map(|value| value.gradient);
    let begun = shade.begin(known, planes.z.gradient, changes);
    let Some(begun) = &begun else {
        return false;
    };
    scan(
        target,
        &shape,
        |row| Some(planes.on(row - first)),
        |span, at| {
            let [left, _] = span.place;
            pixels(span, at.steps(left - column), shade, begun);
        },
        |_| {},
    );
    true
}

/// What changes over a triangle, on one row, at the top vertex's column.
#[derive(Clone, Copy)]
struct Stepping<const A: usize> {
    z: Attribute,
    values: [Attribute; A],
}

impl<const A: usize> Stepped for Stepping<A> {
    fn advance(&mut self) {
        self.z.advance();
        self.values.iter_mut().for_each(Attribute::advance);
    }
}

impl<const A: usize> Stepping<A> {
    fn new(shape: &Shape<'_>, [a, b, c]: [&Values<A>; 3], row: i32) -> Option<Self> {
        let plane = Plane::new(shape.sorted, shape.area);
        let [top, ..] = shape.sorted;
        let place = [top.x().to_bits(), top.y().to_bits()];
        let mut values = [Attribute::ZERO; A];
        for (((attribute, a), b), c) in values.iter_mut().zip(a).zip(b).zip(c) {
            let [whole, b, c] = [a, b, c].map(|v| v >> RUN_FRACTION);
            // Gradients have 16 fractional bits of fourfold values.
            let fraction = 16 - RUN_FRACTION as i32;
            let gradient = plane.gradient(b - whole, c - whole, fraction)?;
            *attribute = Attribute::new(*a as u32, gradient, place, row).unrounded_value();
        }
        let z = Attributes::depth(shape, row)?;
        Some(Self { z, values })
    }

    /// The same some rows below.
    fn on(&self, rows: i32) -> Self {
        Self {
            z: self.z.lower(rows),
            values: self.values.map(|v| v.lower(rows)),
        }
    }

    #[inline(always)]
    fn steps(&self, columns: i32) -> Steps<A> {
        let values = self.values.each_ref();
        Steps {
            z: (self.z.at(columns), self.z.gradient.x),
            values: values.map(|v| v.at(columns) as i32),
            change: values.map(|v| v.gradient.x),
        }
    }
}

/// A row's pixels.
#[inline(always)]
fn pixels<const A: usize, C: Stored, S: ShadePixel<A, C>>(
    span: Span<'_, C>,
    mut steps: Steps<A>,
    shade: &S,
    begun: &S::Begun,
) {
    let ([mut column, row], hides) = (span.place, shade.hides());
    let (mut z, dz) = steps.z;
    for (pixel, depth) in span.indices.iter_mut().zip(span.depths) {
        let here = (z >> 16) as Depth;
        if here > *depth
            && let Some(shaded) = shade.pixel(begun, [column, row], z, &steps.values, *pixel)
        {
            *pixel = shaded;
            if hides {
                *depth = here;
            }
        }
        column += 1;
        z = z.wrapping_add_signed(dz);
        for (value, change) in steps.values.iter_mut().zip(steps.change) {
            *value = value.wrapping_add(change);
        }
        keep_rolled();
    }
}
