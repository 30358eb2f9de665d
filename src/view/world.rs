//! Places in the world, for geometry that belongs to no actor.

use super::{ActorView, ViewFrame};
use crate::math::{Factor, Rotation, Vec3};
use crate::scene::{Actor, Place, Scene};

/// A grid step is 2^-4 world units, so that the least radius that a mesh has (2^20 steps)
/// spans the world and what moves in it.
const STEP_BITS: u32 = 4;

/// Fractional bits of a place beyond those of a grid step.
const DOWN: u32 = 16 - STEP_BITS;

impl ActorView {
    /// The view of an actor without a mesh whose space is the world, of one material.
    pub fn of_world(frame: &ViewFrame, scene: &Scene<'_>, material: u16) -> Self {
        let actor = Actor {
            mesh: u16::MAX,
            material,
            position: [0; 3],
            orientation: [0; 3],
            offset: [0; 3],
            step_mantissa: 1 << 31,
            step_exponent: -(STEP_BITS as i32),
            parent: None,
            still: true,
            part: false,
        };
        let place = Place {
            position: Vec3::ZERO,
            rotation: Rotation::IDENTITY,
            scale: Factor::ONE,
        };
        Self::new(frame, scene, &actor, &place)
    }

    /// Clip coordinates of a place, if this is the world's view: rounded to nearest,
    /// `x`, `y` and the distance, below 2^28.
    pub fn world_to_clip(&self, place: Vec3) -> [i32; 3] {
        let place = place.to_bits().map(i64::from);
        let mut clip = [0; 3];
        for (clip, (row, constant)) in clip.iter_mut().zip(self.rows.iter().zip(self.constants)) {
            // 31 bits of a place, 24 of a row: a place has 12 bits more than a grid step.
            let products = row.iter().zip(place).map(|(r, c)| i64::from(*r) * c);
            let sum = (products.sum::<i64>() >> DOWN).saturating_add(constant);
            let half = 1 << (self.row_fraction - 1);
            *clip = (sum.saturating_add(half) >> self.row_fraction) as i32;
        }
        clip
    }
}
