//! The camera's moves. Their meanings are VTK's (`vtkCamera`), all in fixed point.
#![expect(
    clippy::arithmetic_side_effects,
    reason = "a camera's numbers of 32 bits, in 64; tests stop at overflow"
)]

use super::{Camera, Projection};
use crate::math::{Angle, Factor, Rotation, Unit3, Vec3, World, normalise, view_rotation};

impl Camera {
    /// Turns the eye about the focal point, round the view-up vector: a positive
    /// angle moves it to its right. Rounded to nearest, 2^-17 world units.
    pub fn azimuth(&mut self, angle: Angle) {
        if let Some(up) = normalise(self.view_up.to_bits().map(i64::from)) {
            self.turn_eye(up, angle);
        }
    }

    /// Turns the eye about the focal point, round the picture's horizontal: a
    /// positive angle moves it up. The view-up vector stays, so that the view must
    /// not reach a pole; see [`Camera::level`].
    pub fn elevation(&mut self, angle: Angle) {
        if let Some([right, ..]) = self.axes() {
            self.turn_eye(right.map(i32::wrapping_neg), angle);
        }
    }

    /// Turns the view-up vector round the line of sight: a positive angle turns the
    /// picture counter-clockwise.
    pub fn roll(&mut self, angle: Angle) {
        let up = normalise(self.view_up.to_bits().map(i64::from));
        if let (Some([.., back]), Some(up)) = (self.axes(), up) {
            let sight = back.map(i32::wrapping_neg);
            self.view_up = Vec3::from_bits(Rotation::about(sight, angle).apply(up));
        }
    }

    /// Divides the distance from the eye to the focal point by `factor`: above 1
    /// the eye comes nearer. The clipping range stays. A factor of 0 does nothing.
    pub fn dolly(&mut self, factor: Factor) {
        let divisor = i64::from(factor.to_bits());
        let away = self.position.minus(self.focal_point).map(|c| {
            // 33 bits and 24.
            ((c << 24) + divisor / 2)
                .checked_div_euclid(divisor)
                .unwrap_or(c)
        });
        self.position = self.focal_point.plus(away);
    }

    /// Makes things larger by a narrower view: divides the angle of view by
    /// `factor`, or the parallel scale. A factor of 0 does nothing.
    pub fn zoom(&mut self, factor: Factor) {
        let divisor = u64::from(factor.to_bits());
        if divisor == 0 {
            return;
        }
        let divide = |v: u32| ((u64::from(v) << 24) + divisor / 2) / divisor;
        match &mut self.projection {
            Projection::Perspective { tan_half_angle } => {
                // Less than a quarter turn, so that it has a tangent.
                let half = Angle::of_tangent(tan_half_angle.to_bits()).to_bits();
                let half = divide(half).min((1 << 30) - (1 << 20)) as u32;
                let tangent = Angle::from_bits(half).tangent();
                *tan_half_angle = Factor::from_bits(tangent);
            }
            Projection::Parallel { half_height } => {
                let half = divide(half_height.to_bits().unsigned_abs());
                *half_height = World::from_bits(half.clamp(1, i32::MAX as u64) as i32);
            }
        }
    }

    /// Moves eye and focal point by `right` and `up` world units in the plane of the
    /// picture: what is seen moves to the left and down.
    pub fn pan(&mut self, right: World, up: World) {
        let Some([x, y, _]) = self.axes() else { return };
        let (right, up) = (i64::from(right.to_bits()), i64::from(up.to_bits()));
        let mut by = [0; 3];
        for (sum, (x, y)) in by.iter_mut().zip(x.into_iter().zip(y)) {
            *sum = (i64::from(x) * right + i64::from(y) * up + (1 << 29)) >> 30;
        }
        self.position = self.position.plus(by);
        self.focal_point = self.focal_point.plus(by);
    }

    /// Makes the view-up vector the picture's vertical (VTK's
    /// `OrthogonalizeViewUp`), so that elevations can add up past a pole.
    pub fn level(&mut self) {
        if let Some([_, up, _]) = self.axes() {
            self.view_up = Vec3::from_bits(up);
        }
    }

    /// Right, up and back; `None` if they are not defined.
    fn axes(&self) -> Option<[Unit3; 3]> {
        view_rotation(self.position, self.focal_point, self.view_up).map(|view| view.rows)
    }

    fn turn_eye(&mut self, axis: Unit3, angle: Angle) {
        // 33 bits, 13 more for what the turn rounds.
        let away = self.position.minus(self.focal_point).map(|c| c << 13);
        let turned = Rotation::about(axis, angle).apply_wide(away);
        self.position = self.focal_point.plus(turned.map(|c| (c + (1 << 12)) >> 13));
    }
}
