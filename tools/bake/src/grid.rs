//! A mesh's grid.

use fixel::scene::layout::{GRID_HALF, MOST_SHIFT};
use glam::DVec3;

/// A meshlet's vertices are at most this many of its own steps from its base:
/// 16 bits, less what rounding and snapping may add.
const MEMBER_HALF: f64 = 32760.0;

/// For each axis, the power of two of grid steps that vertices are on.
pub(crate) type Shifts = [u8; 3];

/// A mesh's grid: a power of two as its step, so that places which are binary
/// fractions stay exact.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Grid {
    /// The step is 2 to minus this.
    pub exponent: i32,
    /// Grid point (0, 0, 0): a whole number of steps from the mesh's origin.
    pub centre: DVec3,
}

impl Grid {
    /// The finest grid that holds a mesh with these bounds, as if it were at least
    /// `least` from its middle to its side: a single point needs no finer one.
    pub(crate) fn new(mesh: Bounds, least: f64) -> Self {
        let half = mesh.half().max_element().max(least);
        // Room for the rounding of the centre and the snapping of vertices.
        let finest = (f64::from(GRID_HALF) - 1024.0) / half;
        let exponent = finest.log2().floor().clamp(-60.0, 60.0) as i32;
        let coarse = f64::exp2(f64::from(i32::from(MOST_SHIFT) - exponent));
        // A multiple of the coarsest step that a meshlet may have.
        Self {
            exponent,
            centre: (mesh.middle() / coarse).round() * coarse,
        }
    }

    /// In steps from the grid's centre.
    pub(crate) fn steps(&self, p: DVec3) -> DVec3 {
        (p - self.centre) * f64::exp2(f64::from(self.exponent))
    }

    /// The finest steps for a meshlet with these bounds.
    pub(crate) fn shifts(&self, meshlet: Bounds) -> Shifts {
        let half = meshlet.half() * f64::exp2(f64::from(self.exponent));
        half.to_array().map(|half| {
            let needed = (half / MEMBER_HALF).max(1.0).log2().ceil();
            needed.clamp(0.0, f64::from(MOST_SHIFT)) as u8
        })
    }
}

/// A box.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Bounds {
    low: DVec3,
    high: DVec3,
}

impl Bounds {
    pub(crate) fn of(points: impl Iterator<Item = DVec3>) -> Self {
        let empty = Self {
            low: DVec3::INFINITY,
            high: DVec3::NEG_INFINITY,
        };
        points.fold(empty, |b, p| Self {
            low: b.low.min(p),
            high: b.high.max(p),
        })
    }

    fn half(&self) -> DVec3 {
        ((self.high - self.low) / 2.0).max(DVec3::ZERO)
    }

    fn middle(&self) -> DVec3 {
        if self.low.x > self.high.x {
            DVec3::ZERO
        } else {
            (self.low + self.high) / 2.0
        }
    }
}
