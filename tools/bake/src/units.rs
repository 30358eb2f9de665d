//! Scene units to world units, and numbers to the blob's formats.

use fixel_scene::{Actor, Mesh, Projection, Scene};
use glam::DVec3;

use crate::BakeError;

/// World units are at most this far from the origin, which leaves an
/// application four times that to move things in.
const REACH: f64 = 8192.0;

/// The power of two that takes scene units to world units: as fine a world as
/// holds the scene with room around it.
pub(crate) fn world_exponent(scene: &Scene) -> i32 {
    let mut reach: f64 = 0.0;
    let mut include = |length: f64| reach = reach.max(length);
    let camera = &scene.camera;
    let [near, far] = camera.clipping_range;
    for point in [camera.position, camera.focal_point] {
        include(DVec3::from(point).length());
    }
    include(near.abs());
    if let Projection::Parallel { parallel_scale } = camera.projection {
        include(parallel_scale);
        include(far.abs());
        include(far - near);
    }
    for actor in &scene.actors {
        include(actor_reach(actor, &scene.meshes[actor.mesh]));
    }
    if reach > 0.0 {
        (REACH / reach).log2().floor().clamp(-120.0, 120.0) as i32
    } else {
        0
    }
}

/// How far from the world's origin a point of the actor can be, however turned.
fn actor_reach(actor: &Actor, mesh: &Mesh) -> f64 {
    let (origin, scale) = (DVec3::from(actor.origin), DVec3::from(actor.scale));
    let pivot = DVec3::from(actor.position) + origin;
    let radius = mesh
        .positions
        .iter()
        .map(|p| ((DVec3::from(*p) - origin) * scale).length())
        .fold(0.0, f64::max);
    pivot.length() + radius
}

/// World units from scene units.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Units {
    pub exponent: i32,
}

impl Units {
    /// Raw bits of a world length, rounded to nearest.
    pub(crate) fn length(&self, what: &str, length: f64) -> Result<i32, BakeError> {
        let bits = (length * f64::exp2(f64::from(self.exponent + 16))).round();
        if bits.abs() < f64::from(i32::MAX) {
            Ok(bits as i32)
        } else {
            Err(BakeError::Range {
                what: what.into(),
                value: length,
            })
        }
    }

    /// Raw bits of a place.
    pub(crate) fn point(&self, what: &str, point: DVec3) -> Result<[i32; 3], BakeError> {
        Ok([
            self.length(what, point.x)?,
            self.length(what, point.y)?,
            self.length(what, point.z)?,
        ])
    }
}

/// Degrees in 2^-32 turns, rounded to nearest.
pub(crate) fn turns(degrees: f64) -> u32 {
    let turns = degrees / 360.0;
    ((turns - turns.floor()) * f64::exp2(32.0)).round() as u64 as u32
}

/// `mantissa * 2^(exponent - 31)` with a mantissa in 2^31..2^32.
pub(crate) fn mantissa_exponent(value: f64) -> (u32, i32) {
    let mut exponent = value.log2().floor() as i32;
    let mut mantissa = (value * f64::exp2(f64::from(31 - exponent))).round();
    // log2 may round across a power of two.
    while mantissa >= f64::exp2(32.0) {
        exponent += 1;
        mantissa = (value * f64::exp2(f64::from(31 - exponent))).round();
    }
    while mantissa < f64::exp2(31.0) {
        exponent -= 1;
        mantissa = (value * f64::exp2(f64::from(31 - exponent))).round();
    }
    (mantissa as u32, exponent)
}

/// The direction in Q30.
pub(crate) fn unit_q30(direction: DVec3) -> [i32; 3] {
    let one = f64::exp2(30.0);
    (direction.normalize_or_zero() * one)
        .to_array()
        .map(|c| c.round() as i32)
}
