//! From the world to an actor's grid.

use crate::math::{Rotation, Scaled, Unit3, Vec3, scaled_reciprocal};
use crate::scene::{Actor, Place};

/// Where an actor's grid is, for what has a place in the world: lights.
#[derive(Clone, Copy, Debug)]
pub struct ModelFrame {
    /// World to model directions.
    to_model: Rotation,
    /// The grid's centre in the world.
    centre: Vec3,
    /// Raw world bits a grid step.
    step: Scaled,
    /// Grid steps a raw world bit.
    per_bit: Scaled,
}

impl ModelFrame {
    /// All zero: no actor's.
    pub(super) const ZERO: Self = Self {
        to_model: Rotation { rows: [[0; 3]; 3] },
        centre: Vec3::ZERO,
        step: Scaled::ZERO,
        per_bit: Scaled::ZERO,
    };

    /// Of an actor at `place`.
    pub fn new(actor: &Actor, place: &Place) -> Self {
        if !cfg!(feature = "light") {
            return Self::ZERO;
        }
        let centre = place.rotation.apply_wide(place.scaled(actor.offset));
        let (mantissa, exponent) = place.step(actor);
        let step = Scaled::new(mantissa, exponent - 31 + 16);
        Self {
            to_model: place.rotation.transposed(),
            centre: place.position.plus(centre.map(|c| (c + (1 << 13)) >> 14)),
            step,
            per_bit: scaled_reciprocal(step),
        }
    }

    /// Directions of the world to directions of the model.
    #[cfg(feature = "ray")]
    pub fn world_to_model(&self) -> &Rotation {
        &self.to_model
    }

    /// The grid's centre in the world.
    #[cfg(feature = "ray")]
    pub fn centre(&self) -> Vec3 {
        self.centre
    }

    /// Raw world bits a grid step, and grid steps a raw world bit.
    #[cfg(feature = "ray")]
    pub fn scales(&self) -> (Scaled, Scaled) {
        (self.step, self.per_bit)
    }

    /// World units (not raw bits) a grid step.
    pub fn step(&self) -> Scaled {
        Scaled::new(self.step.mantissa(), self.step.exponent() - 16)
    }

    /// A direction of the world in the model.
    pub fn direction(&self, world: Unit3) -> Unit3 {
        self.to_model.apply(world)
    }

    /// A place in grid steps from the grid's centre, rounded down; held to 2^40.
    pub fn place(&self, world: Vec3) -> [i64; 3] {
        // 34 bits, and 24 of the factor.
        let factor = i64::from(self.per_bit.mantissa() >> 8);
        let exponent = self.per_bit.exponent() + 8;
        let turned = self.to_model.apply_wide(world.minus(self.centre));
        turned.map(|c| {
            let product = c * factor;
            let steps = if exponent >= 0 {
                product.saturating_mul(1i64 << exponent.min(40))
            } else {
                product >> exponent.unsigned_abs().min(63)
            };
            steps.clamp(-(1 << 40), 1 << 40)
        })
    }
}
