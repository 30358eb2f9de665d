//! What changes over a triangle: depth, and level or level times depth.

use super::attribute::Attribute;
use super::gradient::Plane;
use super::perspective;
use super::scan::{Shape, Stepped};
use crate::math::SUBPX_BITS;
use crate::vertex::ScreenVertex;

/// What changes over a triangle, at the centre of one pixel: the top vertex's
/// column in the current row.
#[derive(Clone, Copy)]
pub(super) struct Attributes {
    pub z: Attribute,
    pub level: Attribute,
}

impl Attributes {
    /// Depth alone.
    pub(super) fn depth(shape: &Shape<'_>, row: i32) -> Option<Attribute> {
        Self::new(shape, None, row).map(|at| at.z)
    }

    pub(super) fn depth_and_level(shape: &Shape<'_>, row: i32) -> Option<Self> {
        let levels = shape.sorted.map(|v| i32::from(v.level().to_bits()));
        Self::new(shape, Some((levels, 6)), row)
    }

    /// Depth, and level times depth instead of the level.
    pub(super) fn for_perspective(shape: &Shape<'_>, row: i32) -> Option<Self> {
        let products = shape.sorted.map(perspective::level_times_depth);
        // Whole units of 2^-30 are fine enough: no further fraction.
        let both = Self::new(shape, Some((products, 16)), row)?;
        Some(Self {
            level: both.level.unrounded_value(),
            ..both
        })
    }

    /// Depth, and what else there is at the vertices, with its fractional bits; `None` if a
    /// gradient exceeds the format.
    #[inline(never)]
    fn new(shape: &Shape<'_>, level: Option<([i32; 3], i32)>, row: i32) -> Option<Self> {
        let plane = Plane::new(shape.sorted, shape.area);
        let [top, ..] = shape.sorted;
        let place = [top.x().to_bits(), top.y().to_bits()];
        let depths = shape.sorted.map(|v| v.z().to_bits() as i32);
        let [a, b, c] = depths;
        let gradient = plane.gradient(b - a, c - a, 4)?;
        let mut z = Attribute::new((a as u32) << (16 - 4), gradient, place, row);
        let level = match level {
            Some(([a, b, c], fraction)) => {
                let gradient = plane.gradient(b - a, c - a, fraction)?;
                Attribute::new((a as u32) << (16 - fraction), gradient, place, row)
            }
            None => Attribute::ZERO,
        };
        if z.gradient.is_steep() {
            z = steep_depth(shape.sorted, shape.area, depths, row)?;
        }
        Some(Self { z, level })
    }
}

impl Stepped for Attribute {
    #[inline(always)]
    fn advance(&mut self) {
        self.advance();
    }
}

impl Stepped for Attributes {
    #[inline(always)]
    fn advance(&mut self) {
        self.z.advance();
        self.level.advance();
    }
}

/// The depth of a face so steep that the rounding of its vertices would show: its
/// plane goes through the vertices as they were. `None` where that might leave
/// the range of depths, as at the near plane: such a triangle goes pixel by pixel. On
/// `row`, in the first vertex's column.
#[cold]
#[inline(never)]
pub(super) fn steep_depth(
    vertices: [&ScreenVertex; 3],
    area: i64,
    values: [i32; 3],
    row: i32,
) -> Option<Attribute> {
    // A gradient of 2^15 units a pixel over half a sub-pixel: 4 units.
    const ROOM: i32 = 8 << 4;
    if values
        .iter()
        .any(|z| !(ROOM..=(65535 << 4) - ROOM).contains(z))
    {
        return None;
    }
    let (plane, place) = Plane::unrounded(vertices, area)?;
    let [a, b, c] = values;
    let gradient = plane.gradient(b - a, c - a, 4)?;
    let [first, ..] = vertices;
    let column = first.x().to_bits() >> SUBPX_BITS;
    Some(Attribute::unrounded(
        (a as u32) << 12,
        gradient,
        place,
        [column, row],
    ))
}
