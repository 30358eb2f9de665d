//! Light on what is drawn by call.

use crate::light::{Lit, ShortUnit, WorldLights, WorldSums, sum};
use crate::math::{Unit3, Vec3, cross, direction, normalise};
use crate::scene::{Camera, Dither, Material, Projection, Scene};
use crate::shade::{Lookup, Pixel, dithered};
use crate::view::ActorView;

/// Lights with a place or a colour, and where they are seen from.
#[derive(Clone, Copy, Debug)]
pub(super) struct Shine {
    lights: WorldLights,
    eye: Vec3,
    /// Of a parallel view: towards the eye.
    along: Option<ShortUnit>,
}

impl Shine {
    pub const NONE: Self = Self {
        lights: WorldLights::NONE,
        eye: Vec3::ZERO,
        along: None,
    };

    pub fn set(&mut self, scene: &Scene<'_>, view: &ActorView, camera: &Camera) {
        if !cfg!(feature = "light") {
            return;
        }
        self.lights.set(scene);
        self.eye = camera.position;
        if let Projection::Parallel { .. } = camera.projection {
            let [.., sight] = view.rows;
            // Distance grows away from the eye.
            let against = sight.map(i32::wrapping_neg);
            self.along = direction(against).map(|(unit, _)| unit);
        }
    }

    /// What a material gives back at a place.
    pub fn lit(&self, scene: &Scene<'_>, material: &Material, place: Vec3, normal: Unit3) -> Lit {
        let normal = normal.map(|c| (c + (1 << 15)) >> 16);
        let to_eye = self.eye.minus(place).map(|c| (c >> 2) as i32);
        let seen_from = self
            .along
            .or_else(|| direction(to_eye).map(|(unit, _)| unit));
        let mut sums = WorldSums::default();
        for (light, record) in self.lights.all().zip(scene.lights()) {
            if let Some(reach) = light.reaches(record.position, place.to_bits()) {
                let eye = seen_from.unwrap_or_default();
                sums.add(&light, material, normal, reach, eye);
            }
        }
        let parts = sums.parts(material, None);
        sum(parts.body, parts.gloss)
    }
}

/// The normal of a triangle, of length 1, towards those who see its corners go round
/// counter-clockwise; `None` of one without area.
pub(super) fn face_normal([a, b, c]: [Vec3; 3]) -> Option<Unit3> {
    let along = normalise(b.minus(a))?;
    let across = normalise(c.minus(a))?;
    normalise(cross(along, across))
}

/// The middle of a triangle, rounded down.
pub(super) fn middle(corners: [Vec3; 3]) -> Vec3 {
    let mut sums = [0i64; 3];
    for corner in corners {
        for (sum, c) in sums.iter_mut().zip(corner.to_bits()) {
            *sum += i64::from(c);
        }
    }
    // A third of 33 bits and a sign: 24 bits of it are enough for a place.
    Vec3::from_bits(sums.map(|sum| ((sum * 0x55_5555) >> 24) as i32))
}

/// A normal as faces have it in a blob; see
/// [`ModelLights::face_level`](crate::view::ModelLights::face_level).
pub(super) fn packed(normal: Unit3) -> u32 {
    let part = |c: i32| ((i64::from(c) * 511 + (1 << 29)) >> 30) as u32 & 0x3ff;
    let [x, y, z] = normal.map(part);
    x | y << 10 | z << 20
}

/// The palette entry of a colour, not dithered.
pub(super) fn nearest(scene: &Scene<'_>, lit: Lit) -> u8 {
    let pixel = Pixel {
        lookup: Lookup::Colours(scene.colours()),
        lit,
        place: [0; 2],
        texel: [0; 2],
    };
    dithered(&pixel, Dither::NONE)
}
