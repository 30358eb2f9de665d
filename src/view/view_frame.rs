//! The camera, ready for use.

use crate::math::{Rotation, SUBPX_BITS, Vec3, World, keep_rolled, square_root, view_rotation};
use crate::scene::{Camera, PlacedViewport, Projection};

/// Screen distance per view-space ratio (perspective: x / w; parallel: x in
/// world units): `mantissa / 2^31 * 2^exponent` in raw sub-pixels, the larger
/// mantissa in 2^29..2^31. With square pixels it is the same for x and y.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Lens {
    /// Folded into the clip rows of x and y.
    pub mantissas: [i32; 2],
    /// Applied when a clip coordinate becomes a screen position.
    pub exponent: i32,
}

/// A camera with its screen.
#[derive(Clone, Copy, Debug)]
pub struct ViewFrame {
    /// World to view directions.
    pub rotation: Rotation,
    /// Where the eye is.
    pub eye: Vec3,
    /// Focal length or scale.
    pub lens: Lens,
    /// Whether things shrink with distance.
    pub perspective: bool,
    /// Distance of the near plane, raw world bits, below 2^43; at least 1 for
    /// perspective.
    pub near: i64,
    /// Distance of the far plane, raw world bits, above `near`; [`i64::MAX`]: none.
    pub far: i64,
    /// How much further right things appear with each unit of distance: Q30, at
    /// most 0.6 either way.
    pub shear: i32,
    /// Screen width in pixels.
    pub width: u16,
    /// Screen height in pixels.
    pub height: u16,
}

impl ViewFrame {
    /// The view of `camera` on a screen of `width` x `height` pixels (at most
    /// 2048 each). A camera whose line of sight has no direction looks along
    /// -z; an up vector along the line of sight is replaced.
    pub fn new(camera: &Camera, width: u16, height: u16) -> Self {
        Self::magnified(camera, width, height, [1, 1])
    }

    /// The view into a viewport, as if it were a screen of its own.
    pub fn of(viewport: &PlacedViewport) -> Self {
        let rect = &viewport.rect;
        let (width, height) = (rect.width(), rect.height());
        let view = Self::magnified(&viewport.camera, width, height, viewport.magnified);
        view.sheared(&viewport.camera, viewport.shear)
    }

    /// One of two eyes: beside the camera, with a picture that is sheared so that
    /// what is as far away as the focal point stays in place (VTK's stereo; there
    /// is no vertical parallax, as there would be from turned cameras).
    fn sheared(self, camera: &Camera, shear: i32) -> Self {
        if !cfg!(feature = "viewports") || shear == 0 {
            return self;
        }
        // A quarter of the distance has 31 bits, a sum of its squares 64.
        let sight = camera.focal_point.minus(camera.position);
        let squared = sight.map(|c| ((c >> 2) * (c >> 2)).unsigned_abs());
        let distance = i64::from(square_root(squared.iter().sum())) << 2;
        let aside = (distance * i64::from(shear)) >> 30;
        let [right, ..] = self.rotation.rows;
        let [x, y, z] = camera.position.to_bits().map(i64::from);
        let [rx, ry, rz] = right.map(|c| (i64::from(c) * aside + (1 << 29)) >> 30);
        let place = [x + rx, y + ry, z + rz];
        let held = place.map(|c| c.clamp(i32::MIN.into(), i32::MAX.into()) as i32);
        Self {
            eye: Vec3::from_bits(held),
            shear,
            ..self
        }
    }

    /// Whether it is one of two eyes'.
    pub(super) fn is_sheared(&self) -> bool {
        // Without the feature there are none.
        cfg!(feature = "viewports") && self.shear != 0
    }

    #[inline(never)]
    fn magnified(camera: &Camera, width: u16, height: u16, magnified: [u32; 2]) -> Self {
        let up_instead = Vec3::from_ints(0, 0, 1);
        let x_up = Vec3::from_ints(1, 0, 0);
        let ups = [camera.view_up, up_instead, x_up];
        let mut rotations = ups.iter().filter_map(|up| {
            keep_rolled();
            view_rotation(camera.position, camera.focal_point, *up)
        });
        let rotation = rotations.next().unwrap_or(Rotation::IDENTITY);
        let half_height = u64::from(height.clamp(1, 2048)) << (SUBPX_BITS - 1);
        // 24 and 16 are the fractional bits of the divisors.
        let (perspective, divisor, fraction) = match camera.projection {
            Projection::Perspective { tan_half_angle } => (true, tan_half_angle.to_bits(), 24),
            Projection::Parallel { half_height: scale } => {
                (false, scale.to_bits().max(1) as u32, 16)
            }
        };
        let lens = Lens::new(half_height, divisor, fraction, magnified);
        let raw = |distance: World| i64::from(distance.to_bits()) << camera.range_exponent.min(11);
        let least = if perspective { 1 } else { i64::MIN };
        let near = raw(camera.near).max(least);
        let far = if perspective && camera.far == World::MAX {
            i64::MAX
        } else {
            raw(camera.far)
        };
        Self {
            rotation,
            eye: camera.position,
            lens,
            perspective,
            near,
            far: far.max(near.saturating_add(1)),
            shear: 0,
            width,
            height,
        }
    }
}

impl Lens {
    /// `half_height / (divisor / 2^fraction)`; `half_height` at most 2^23. Across
    /// it is larger by the ratio `magnified`, of numbers below 2^23.
    #[inline(never)]
    fn new(half_height: u64, divisor: u32, fraction: i32, magnified: [u32; 2]) -> Self {
        let quotient = (half_height << 41) / u64::from(divisor.max(1));
        let bits = 64 - quotient.leading_zeros() as i32;
        let mantissa = if bits > 31 {
            quotient >> (bits - 31)
        } else {
            quotient << (31 - bits)
        };
        // Without the feature there are no viewports to stretch a picture to.
        let mantissa_x = if cfg!(feature = "viewports") {
            let [across, down] = magnified.map(|m| u64::from(m.max(1)));
            (mantissa * across).checked_div(down).unwrap_or(0)
        } else {
            mantissa
        };
        // If it is wider than high, both lose a bit for each doubling.
        let over = (64 - mantissa_x.leading_zeros() as i32 - 31).max(0);
        Self {
            mantissas: [mantissa_x >> over, mantissa >> over].map(|m| m as i32),
            exponent: bits - (41 - fraction) + over,
        }
    }
}
