//! Vertices onto a mesh's grid.

use fixel::scene::layout::GRID_HALF;
use glam::{DVec3, IVec3};

/// A meshlet's vertices are at most this many steps from its base.
const MEMBER_HALF: f64 = 32766.0;

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
    /// The finest grid on which the mesh and each cluster's box fit.
    pub(crate) fn new(mesh: Bounds, clusters: impl Iterator<Item = Bounds>) -> Self {
        let cluster = clusters.map(|b| b.half()).fold(0.0, f64::max);
        let mesh_half = mesh.half().max(f64::MIN_POSITIVE);
        let finest = (MEMBER_HALF / cluster.max(f64::MIN_POSITIVE))
            .min((f64::from(GRID_HALF) - 65536.0) / mesh_half);
        let exponent = finest.log2().floor().clamp(-60.0, 60.0) as i32;
        let step = f64::exp2(f64::from(-exponent));
        Self {
            exponent,
            centre: (mesh.middle() / step).round() * step,
        }
    }

    /// The nearest grid point.
    pub(crate) fn snap(&self, p: DVec3) -> IVec3 {
        ((p - self.centre) * f64::exp2(f64::from(self.exponent)))
            .round()
            .as_ivec3()
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

    fn half(&self) -> f64 {
        ((self.high - self.low) / 2.0).max_element().max(0.0)
    }

    fn middle(&self) -> DVec3 {
        if self.low.x > self.high.x {
            DVec3::ZERO
        } else {
            (self.low + self.high) / 2.0
        }
    }
}
