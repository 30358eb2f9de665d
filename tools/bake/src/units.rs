//! Scene units to world units, and numbers to the blob's formats.

use fixel_scene::{Camera, Projection, Reach, Scene};
use glam::DVec3;

use crate::error::{BakeError, Problem, Spot};

/// World units are at most this far from the origin, which leaves an
/// application four times that to move things in.
const REACH: f64 = 8192.0;

/// World units from scene units: moved to the scene's middle if that is far from
/// the origin, and scaled by a power of two so that the scene uses the range of a
/// world length with room around it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Units {
    /// World units are scene units times 2 to this power.
    pub exponent: i32,
    /// The world's origin: whole numbers of `2^centre_exponent` scene units.
    pub centre: [i32; 3],
    /// See `centre`.
    pub centre_exponent: i32,
}

impl Units {
    pub(crate) fn new(scene: &Scene) -> Self {
        let own = scene.viewports.iter().filter_map(|v| v.camera.as_ref());
        let cameras: Vec<&Camera> = own.chain([&scene.camera]).collect();
        let reach = Reach::of(scene);
        let actors = reach.actors.iter().map(|(c, r)| (DVec3::from(*c), *r));
        let views = reach.views.iter().map(|view| (DVec3::from(*view), 0.0));
        let spheres: Vec<(DVec3, f64)> = actors.chain(views).collect();
        let low = spheres
            .iter()
            .map(|(c, r)| *c - *r)
            .fold(DVec3::INFINITY, DVec3::min);
        let high = spheres
            .iter()
            .map(|(c, r)| *c + *r)
            .fold(DVec3::NEG_INFINITY, DVec3::max);
        let (middle, half) = ((low + high) / 2.0, (high - low).max_element() / 2.0);

        // A coarse power of two, so that binary fractions stay what they are.
        let centre_exponent = if half > 0.0 {
            half.log2().floor() as i32
        } else {
            0
        };
        let far_away = middle.length() > half && half > 0.0;
        let unit = f64::exp2(f64::from(centre_exponent));
        let centre = if far_away {
            (middle / unit).round()
        } else {
            DVec3::ZERO
        };
        let fits = centre.abs().max_element() < f64::from(i32::MAX);
        let centre = if fits { centre } else { DVec3::ZERO };
        let origin = centre * unit;

        let mut reach: f64 = spheres
            .iter()
            .map(|(c, r)| (*c - origin).length() + r)
            .fold(0.0, f64::max);
        for camera in cameras {
            match camera.projection {
                Projection::Perspective { .. } => reach = reach.max(camera.clipping_range[0]),
                Projection::Parallel { parallel_scale } => reach = reach.max(parallel_scale),
            }
        }
        let exponent = if reach > 0.0 {
            (REACH / reach).log2().floor()
        } else {
            0.0
        };
        Self {
            exponent: exponent.clamp(-120.0, 120.0) as i32,
            centre: centre.to_array().map(|c| c as i32),
            centre_exponent,
        }
    }

    /// The world's origin in scene units.
    pub(crate) fn origin(&self) -> DVec3 {
        DVec3::from(self.centre.map(f64::from)) * f64::exp2(f64::from(self.centre_exponent))
    }

    /// A length in world units, in scene units.
    pub(crate) fn scene_length(&self, length: f64) -> f64 {
        length * f64::exp2(-f64::from(self.exponent))
    }

    /// Raw bits of a place in the world.
    pub(crate) fn place(&self, spot: Spot<'_>, place: DVec3) -> Result<[i32; 3], BakeError> {
        self.vector(spot, place - self.origin())
    }

    /// Raw bits of a world length, rounded to nearest.
    pub(crate) fn length(&self, spot: Spot<'_>, length: f64) -> Result<i32, BakeError> {
        let problem = || Problem::Range {
            what: spot.what.into(),
            value: length,
            most: self.scene_length(f64::from(i32::MAX) / 65536.0),
        };
        let bits = self.bits(length);
        bits.ok_or_else(|| problem().at(spot.element))
    }

    /// The same, if they hold it.
    pub(crate) fn bits(&self, length: f64) -> Option<i32> {
        let bits = (length * f64::exp2(f64::from(self.exponent + 16))).round();
        (bits.abs() < f64::from(i32::MAX)).then_some(bits as i32)
    }

    /// Raw bits of a way from one place to another.
    pub(crate) fn vector(&self, spot: Spot<'_>, point: DVec3) -> Result<[i32; 3], BakeError> {
        Ok([
            self.length(spot, point.x)?,
            self.length(spot, point.y)?,
            self.length(spot, point.z)?,
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
