//! Scene units and world units.

use super::Scene;
use crate::math::Vec3;

impl Scene<'_> {
    /// Where a place of the scene file is in the world: the scene's middle taken off, if the
    /// scene lies far from its origin, and times a power of two
    /// ([`Scene::world_exponent`]). Exact, or rounded down; what is beyond the world saturates.
    ///
    /// For a placement that an application makes; what has a parent is in that one's space,
    /// for which [`Scene::world_length`] is right.
    pub fn world(&self, place: Vec3) -> Vec3 {
        let header = self.header();
        let mut bits = place.to_bits().map(i64::from);
        for (c, centre) in bits.iter_mut().zip(header.world_centre) {
            // 32 bits; beyond 2^47 it is far off any scene in these units.
            let centre = shifted(
                centre.into(),
                i32::from(header.centre_exponent).saturating_add(16),
            );
            *c = c.saturating_sub(centre);
        }
        Vec3::from_bits(bits.map(|c| saturated(shifted(c, header.world_exponent.into()))))
    }

    /// A vector of scene units in world units.
    pub fn world_length(&self, length: Vec3) -> Vec3 {
        let exponent = i32::from(self.world_exponent());
        let bits = length.to_bits().map(i64::from);
        Vec3::from_bits(bits.map(|c| saturated(shifted(c, exponent))))
    }
}

/// `v * 2^by`, which saturates or is rounded down.
fn shifted(v: i64, by: i32) -> i64 {
    if by >= 0 {
        v.saturating_mul(1 << by.min(62))
    } else {
        v >> by.wrapping_neg().min(63)
    }
}

fn saturated(v: i64) -> i32 {
    v.clamp(i32::MIN.into(), i32::MAX.into()) as i32
}
