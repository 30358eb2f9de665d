//! A camera as the blob holds it: in the header, and in viewports that have
//! their own.

use fixed::types::U8F24;

use super::records::{i, u, w};
use super::{Camera, Field, Projection, Record};
use crate::math::{Vec3, World};

/// The numbers of a camera.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct CameraRecord {
    /// Eye, raw [`World`] bits.
    pub position: [i32; 3],
    /// What is in the middle of the picture.
    pub focal_point: [i32; 3],
    /// Which way is up.
    pub view_up: [i32; 3],
    /// 0: perspective, 1: parallel.
    pub projection: u8,
    /// Perspective: tangent of half the vertical angle of view, in 2^-24.
    /// Parallel: half the picture's height, raw world bits.
    pub half_height: u32,
    /// Power of two that `near` and `far` are in: 0..=11. Not 0 only where a
    /// parallel view's range is far larger than its scene.
    pub range_exponent: u8,
    /// Distance of the near plane, raw world bits; above 0 for perspective.
    pub near: i32,
    /// Distance of the far plane; `i32::MAX`: none (perspective only).
    pub far: i32,
}

impl Record for CameraRecord {
    type Words = [u32; 13];

    fn from_words(words: &Self::Words) -> Self {
        let [p0, p1, p2, f0, f1, f2, u0, u1, u2, kind, half, near, far] = *words;
        let [projection, range_exponent, ..] = kind.to_ne_bytes();
        Self {
            position: [i(p0), i(p1), i(p2)],
            focal_point: [i(f0), i(f1), i(f2)],
            view_up: [i(u0), i(u1), i(u2)],
            projection,
            half_height: u(half),
            range_exponent,
            near: i(near),
            far: i(far),
        }
    }

    fn to_words(&self) -> Self::Words {
        let [p0, p1, p2] = self.position.map(w);
        let [f0, f1, f2] = self.focal_point.map(w);
        let [u0, u1, u2] = self.view_up.map(w);
        let kind = u32::from_ne_bytes([self.projection, self.range_exponent, 0, 0]);
        let half = self.half_height.to_le();
        let (near, far) = (w(self.near), w(self.far));
        [p0, p1, p2, f0, f1, f2, u0, u1, u2, kind, half, near, far]
    }
}

impl CameraRecord {
    /// The first number out of its range, if any.
    pub(super) fn out_of_range(&self) -> Option<(Field, i64)> {
        let perspective = self.projection == 0;
        let largest = if perspective {
            u32::MAX
        } else {
            i32::MAX as u32
        };
        let nearest = if perspective { 1 } else { i64::from(i32::MIN) };
        let differs = i64::from(self.position != self.focal_point);
        let has_up = i64::from(self.view_up != [0; 3]);
        let checks = [
            (Field::Projection, self.projection.into(), 0, 1),
            (Field::ViewAngle, self.half_height.into(), 1, largest.into()),
            (
                Field::ClippingRange,
                self.near.into(),
                nearest,
                i64::from(self.far).wrapping_sub(1),
            ),
            (Field::ClippingRange, self.range_exponent.into(), 0, 11),
            (Field::Camera, differs, 1, 1),
            (Field::Camera, has_up, 1, 1),
        ];
        let bad = checks
            .iter()
            .find(|(_, value, least, most)| !(least..=most).contains(&value));
        bad.map(|(field, value, ..)| (*field, *value))
    }

    /// Ready for a pose.
    pub fn camera(&self) -> Camera {
        Camera {
            position: Vec3::from_bits(self.position),
            focal_point: Vec3::from_bits(self.focal_point),
            view_up: Vec3::from_bits(self.view_up),
            projection: if self.projection == 0 {
                Projection::Perspective {
                    tan_half_angle: U8F24::from_bits(self.half_height),
                }
            } else {
                Projection::Parallel {
                    half_height: World::from_bits(self.half_height as i32),
                }
            },
            near: World::from_bits(self.near),
            far: World::from_bits(self.far),
            range_exponent: self.range_exponent,
        }
    }
}
