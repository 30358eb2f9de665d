//! Maps between spaces, tagged so that only matching ones compose.

use core::marker::PhantomData;

use super::rotation::turned;
use super::{Angle, Rotation, Unit3, Vec3, World as Length, cross, normalise};

/// Model space: an actor's own.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Model {}
/// World space: the scene's.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum World {}
/// View space: the eye at the origin, looking along -z, y up.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum View {}
/// Clip space: before the division by w.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Clip {}

/// Something that a [`Transform`] maps from or to.
pub trait Space: Copy {}
impl Space for Model {}
impl Space for World {}
impl Space for View {}
impl Space for Clip {}

/// An affine map from one space to another: a 3x3 part whose Q30 entries share
/// one power of two, and a translation in Q32. Composition and application
/// round at 2^-28 of the largest entry.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Transform<From: Space, To: Space> {
    linear: [[i32; 3]; 3],
    exponent: i32,
    translation: [i64; 3],
    spaces: PhantomData<(From, To)>,
}

impl<From: Space, To: Space> Transform<From, To> {
    fn new(linear: [[i32; 3]; 3], exponent: i32, translation: [i64; 3]) -> Self {
        Self {
            linear,
            exponent,
            translation,
            spaces: PhantomData,
        }
    }

    /// Leaves everything in place.
    pub fn identity() -> Self {
        Self::rotation(&Rotation::IDENTITY)
    }

    /// A move.
    pub fn translation(by: Vec3) -> Self {
        Self::new(
            Rotation::IDENTITY.rows,
            0,
            by.to_bits().map(|c| i64::from(c) << 16),
        )
    }

    /// A turn about the origin.
    pub fn rotation(rotation: &Rotation) -> Self {
        Self::new(rotation.rows, 0, [0; 3])
    }

    /// A turn by `angle` about an axis through `point` that is parallel to x.
    pub fn rotation_about_x_through(point: Vec3, angle: Angle) -> Self {
        let there = Transform::<From, From>::translation(Vec3::from_bits(
            point.to_bits().map(i32::wrapping_neg),
        ));
        let back = Transform::<To, To>::translation(point);
        there
            .then(&Self::rotation(&Rotation::about_x(angle)))
            .then(&back)
    }

    /// Factors along the axes; negative ones reflect.
    pub fn scale(x: Length, y: Length, z: Length) -> Self {
        let d = |c: Length| i64::from(c.to_bits()) << 32; // Q48
        let rows = [[d(x), 0, 0], [0, d(y), 0], [0, 0, d(z)]];
        let (linear, exponent) = fit(rows, 12);
        Self::new(linear, exponent, [0; 3])
    }

    /// First `self`, then `next`.
    #[must_use]
    pub fn then<Next: Space>(&self, next: &Transform<To, Next>) -> Transform<From, Next> {
        let [[a, b, c], [d, e, f], [g, h, i]] = self.linear.map(|row| row.map(i64::from));
        let columns = [[a, d, g], [b, e, h], [c, f, i]];
        let product = next.linear.map(|row| {
            let [x, y, z] = row.map(i64::from);
            columns.map(|[p, q, r]| (x * p).wrapping_add(y * q).wrapping_add(z * r))
        });
        let (linear, exponent) = fit(product, self.exponent.saturating_add(next.exponent));
        Transform::new(linear, exponent, next.apply_q32(self.translation))
    }

    fn apply_q32(&self, point: [i64; 3]) -> [i64; 3] {
        let mut out = self.translation;
        for (sum, row) in out.iter_mut().zip(self.linear) {
            *sum = sum.saturating_add(shift(turned(row, point), self.exponent));
        }
        out
    }

    /// Where a point goes, rounded to nearest; saturates outside the range of
    /// [`Length`].
    pub fn apply(&self, point: Vec3) -> Vec3 {
        let wide = self.apply_q32(point.to_bits().map(|c| i64::from(c) << 16));
        Vec3::from_bits(wide.map(|c| {
            let rounded = c.saturating_add(1 << 15) >> 16;
            rounded.clamp(i64::from(i32::MIN), i64::from(i32::MAX)) as i32
        }))
    }
}

impl Transform<World, View> {
    /// The frame of an eye at `position` that looks at `focal_point`: x to the
    /// right, y up, z from the focal point to the eye. `None` if the two
    /// coincide or `view_up` is parallel to the line of sight.
    pub fn look_at(position: Vec3, focal_point: Vec3, view_up: Vec3) -> Option<Self> {
        let rotation = view_rotation(position, focal_point, view_up)?;
        let from_eye =
            Self::translation(Vec3::from_bits(position.to_bits().map(i32::wrapping_neg)));
        Some(from_eye.then(&Transform::<View, View>::rotation(&rotation)))
    }
}

/// World to view directions; see [`Transform::look_at`].
#[inline(never)]
pub(crate) fn view_rotation(position: Vec3, focal_point: Vec3, view_up: Vec3) -> Option<Rotation> {
    let z: Unit3 = normalise(position.minus(focal_point))?;
    let up: Unit3 = normalise(view_up.to_bits().map(i64::from))?;
    let x = normalise(cross(up, z))?;
    let y = normalise(cross(z, x))?;
    Some(Rotation { rows: [x, y, z] })
}

/// Brings Q60 entries to Q30 with a common power of two: the largest ends in
/// 2^29..=2^30, so that rotations keep exponent 0.
fn fit(rows: [[i64; 3]; 3], exponent: i32) -> ([[i32; 3]; 3], i32) {
    let largest = rows
        .iter()
        .flatten()
        .fold(0, |m: u64, c| m.max(c.unsigned_abs()));
    let mut extra = 0;
    while largest >> extra > 1 << 60 {
        extra += 1;
    }
    while extra > -30 && largest != 0 && largest << -extra.min(0) < 1 << 59 {
        extra -= 1;
    }
    let down = 30 + extra;
    let half = if down > 0 { 1i64 << (down - 1) } else { 0 };
    (
        rows.map(|row| row.map(|c| (c.saturating_add(half) >> down) as i32)),
        exponent.saturating_add(extra),
    )
}

fn shift(v: i64, by: i32) -> i64 {
    if by >= 0 {
        v.saturating_mul(1i64 << by.min(62))
    } else {
        v >> by.saturating_neg().min(63)
    }
}
