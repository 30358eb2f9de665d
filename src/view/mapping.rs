//! Points from one space to the next and back, for what an application computes
//! itself: labels, hit tests, placing things under a finger. Drawing does not go
//! through here.
//!
//! Model space: an actor's own, in world units about its pivot. World space: the
//! scene's. View space: the eye at the origin, x to the right, y up, z towards the
//! viewer, so that what is seen has a negative z; world units. Normalised device
//! coordinates ([`Ndc`]): x and y from -1 to 1 across the picture, y up. Display
//! ([`DisplayPoint`]): pixels, y down.
//!
//! Each way is rounded once, to nearest, in the steps of the format it gives; what
//! goes beyond a format's range saturates, as do lines of sight steeper than 1024 to
//! 1.

use fixed::types::I8F24;

use super::ViewFrame;
use crate::math::{MAX_SCREEN, SUBPX_BITS, SubPx, Unit3, Vec3, normalise};
use crate::scene::Place;

/// A point in the picture whatever its size. Steps of 2^-24.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Ndc {
    /// -1 at the left side, 1 at the right one.
    pub x: I8F24,
    /// -1 at the bottom, 1 at the top.
    pub y: I8F24,
    /// 1 at the near plane. Perspective: near / distance, so 0 is infinitely far.
    /// Parallel: 0 at the far plane.
    pub depth: I8F24,
}

/// A point on the screen.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct DisplayPoint {
    /// Pixels from the left side.
    pub x: SubPx,
    /// Pixels from the top.
    pub y: SubPx,
    /// As in [`Ndc`]; times 65535 it is what the depth buffer holds.
    pub depth: I8F24,
}

/// What a pixel's centre or another point of the screen sees.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Ray {
    /// The eye; for a parallel view, the point in the eye's plane.
    pub origin: Vec3,
    /// Away from the viewer.
    pub direction: Unit3,
}

/// Fractional bits of [`Ndc`].
const NDC_BITS: i32 = 24;
/// Fractional bits of slopes against the line of sight.
const SLOPE_BITS: i32 = 28;

impl Place {
    /// From the actor's own space to the world.
    pub fn model_to_world(&self, model: Vec3) -> Vec3 {
        let turned = self.rotation.apply_wide(self.scaled(model.to_bits()));
        self.position.plus(turned.map(|c| round(c, 14)))
    }

    /// From the world to the actor's own space.
    pub fn world_to_model(&self, world: Vec3) -> Vec3 {
        let from_pivot = world.minus(self.position).map(|c| c << 13);
        let turned = self.rotation.transposed().apply_wide(from_pivot);
        let factor = i64::from(self.scale.to_bits().max(1));
        // 24 fractional bits of the factor, 13 of the vector.
        let model = turned.map(|c| divide(c.saturating_mul(1 << 11), factor));
        saturated(model)
    }
}

impl ViewFrame {
    /// From the world to the eye's space.
    pub fn world_to_view(&self, world: Vec3) -> Vec3 {
        let from_eye = world.minus(self.eye).map(|c| c << 13);
        saturated(self.rotation.apply_wide(from_eye).map(|c| round(c, 13)))
    }

    /// From the eye's space to the world.
    pub fn view_to_world(&self, view: Vec3) -> Vec3 {
        let wide = view.to_bits().map(|c| i64::from(c) << 13);
        let turned = self.rotation.transposed().apply_wide(wide);
        self.eye.plus(turned.map(|c| round(c, 13)))
    }

    /// From the eye's space to the picture; `None` at the eye and behind it.
    pub fn view_to_ndc(&self, view: Vec3) -> Option<Ndc> {
        let [x, y, z] = view.to_bits().map(i64::from);
        let distance = -z;
        if self.perspective && distance <= 0 {
            return None;
        }
        let across = |v: i64, axis: Axis| {
            let (mantissa, half) = self.axis(axis);
            let wide = v * mantissa;
            // A world length has 16 fractional bits.
            let divisor = if self.perspective { distance } else { 1 << 16 };
            // As many bits of the quotient as there are.
            let up = wide.unsigned_abs().leading_zeros().saturating_sub(2);
            let slope = divide(wide << up, divisor);
            // Sub-pixels are this by 2^(exponent - 31).
            let units = shift(slope, self.lens.exponent - 31 + NDC_BITS - up as i32);
            fixed(divide(units, half))
        };
        Some(Ndc {
            x: across(x, Axis::X),
            y: across(y, Axis::Y),
            depth: self.depth(distance),
        })
    }

    /// From the picture to the eye's space; `None` for a perspective depth that is
    /// not above 0.
    pub fn ndc_to_view(&self, ndc: Ndc) -> Option<Vec3> {
        let depth = i64::from(ndc.depth.to_bits());
        let distance = if self.perspective {
            if depth <= 0 {
                return None;
            }
            divide(self.near.min(1 << 38) << NDC_BITS, depth)
        } else {
            let range = self.far.saturating_sub(self.near);
            let depth = depth.clamp(-2 << NDC_BITS, 2 << NDC_BITS);
            // 43 bits and 25, in two products.
            let (high, low) = (range >> 20, range & 0xf_ffff);
            let from_far = ((high * depth) >> 4) + round(low * depth, NDC_BITS);
            self.far.saturating_sub(from_far)
        };
        let [sx, sy] = self.slopes(ndc);
        let place = |slope: i64| {
            if self.perspective {
                scale(slope, distance)
            } else {
                // A parallel view's slope is a length.
                round(slope, SLOPE_BITS - 16)
            }
        };
        Some(saturated([place(sx), place(sy), -distance]))
    }

    /// From the picture to pixels.
    pub fn ndc_to_display(&self, ndc: Ndc) -> DisplayPoint {
        let pixels = |c: i64, axis: Axis| {
            let (_, half) = self.axis(axis);
            let from_middle = round(c * half, NDC_BITS);
            let most = i64::from(MAX_SCREEN) * 8;
            SubPx::from_bits((half + from_middle).clamp(-most, most) as i32)
        };
        let (x, y) = (i64::from(ndc.x.to_bits()), i64::from(ndc.y.to_bits()));
        DisplayPoint {
            x: pixels(x, Axis::X),
            y: pixels(-y, Axis::Y),
            depth: ndc.depth,
        }
    }

    /// From pixels to the picture.
    pub fn display_to_ndc(&self, display: DisplayPoint) -> Ndc {
        let part = |pixels: SubPx, axis: Axis| {
            let (_, half) = self.axis(axis);
            divide((i64::from(pixels.to_bits()) - half) << NDC_BITS, half)
        };
        Ndc {
            x: fixed(part(display.x, Axis::X)),
            y: fixed(-part(display.y, Axis::Y)),
            depth: display.depth,
        }
    }

    /// Where a point of the world is on the screen; `None` at the eye and behind it.
    /// Whether it is within the picture and before the far plane is for the caller to
    /// see.
    pub fn world_to_display(&self, world: Vec3) -> Option<DisplayPoint> {
        let ndc = self.view_to_ndc(self.world_to_view(world))?;
        Some(self.ndc_to_display(ndc))
    }

    /// Which point of the world is at a place and depth of the screen; `None` for a
    /// perspective depth that is not above 0.
    pub fn display_to_world(&self, display: DisplayPoint) -> Option<Vec3> {
        let view = self.ndc_to_view(self.display_to_ndc(display))?;
        Some(self.view_to_world(view))
    }

    /// The line of sight through a place of the screen; the middle of pixel (x, y)
    /// is (x + 0.5, y + 0.5). The direction is off by less than 2^-24.
    pub fn ray(&self, x: SubPx, y: SubPx) -> Ray {
        let depth = I8F24::ZERO;
        let [sx, sy] = self.slopes(self.display_to_ndc(DisplayPoint { x, y, depth }));
        let to_world = self.rotation.transposed();
        let ahead = -1i64 << SLOPE_BITS;
        if self.perspective {
            // Within the 47 bits that turning takes.
            let direction = to_world.apply_wide([sx, sy, ahead].map(|c| c << 8));
            return Ray {
                origin: self.eye,
                direction: normalise(direction).unwrap_or_default(),
            };
        }
        let aside = to_world.apply_wide([sx, sy, 0]);
        Ray {
            origin: self.eye.plus(aside.map(|c| round(c, SLOPE_BITS - 16))),
            direction: to_world.apply([0, 0, -1 << 30]),
        }
    }

    /// The lens's mantissa and half the picture in sub-pixels.
    fn axis(&self, axis: Axis) -> (i64, i64) {
        let [mx, my] = self.lens.mantissas;
        let (mantissa, pixels) = match axis {
            Axis::X => (mx, self.width),
            Axis::Y => (my, self.height),
        };
        (
            mantissa.into(),
            i64::from(pixels.max(1)) << (SUBPX_BITS - 1),
        )
    }

    /// Right and up a distance of 1 (perspective), or in world units (parallel).
    fn slopes(&self, ndc: Ndc) -> [i64; 2] {
        let slope = |c: I8F24, axis: Axis| {
            let (mantissa, half) = self.axis(axis);
            let sub_pixels = i64::from(c.to_bits()) * half;
            let units = SLOPE_BITS - NDC_BITS + 31 - self.lens.exponent;
            shift_divide(sub_pixels, units, mantissa.max(1))
        };
        let [x, y] = [slope(ndc.x, Axis::X), slope(ndc.y, Axis::Y)];
        let most = if self.perspective { 1 << 38 } else { 1 << 46 };
        [x, y].map(|c| c.clamp(-most, most))
    }

    fn depth(&self, distance: i64) -> I8F24 {
        fixed(if self.perspective {
            divide(self.near.min(1 << 38) << NDC_BITS, distance)
        } else {
            let range = self.far.saturating_sub(self.near).max(1);
            let from_far = self.far.saturating_sub(distance);
            let from_far = from_far.clamp(-2 * range, 2 * range);
            // 36 bits of the 43 are enough.
            let down = 28u32.saturating_sub(range.leading_zeros());
            divide((from_far >> down) << NDC_BITS, range >> down)
        })
    }
}

#[derive(Clone, Copy)]
enum Axis {
    X,
    Y,
}

fn saturated(bits: [i64; 3]) -> Vec3 {
    Vec3::ZERO.plus(bits)
}

fn fixed(bits: i64) -> I8F24 {
    I8F24::from_bits(bits.clamp(i32::MIN.into(), i32::MAX.into()) as i32)
}

/// To nearest, upwards from the middle.
fn round(v: i64, bits: i32) -> i64 {
    v.saturating_add(1i64 << (bits - 1)) >> bits
}

/// To nearest; `divisor` above 0.
fn divide(v: i64, divisor: i64) -> i64 {
    let half = divisor / 2;
    v.saturating_add(half)
        .checked_div_euclid(divisor)
        .unwrap_or(0)
}

/// `v * 2^by / divisor`, with a divisor below 2^31.
fn shift_divide(v: i64, by: i32, divisor: i64) -> i64 {
    if by < 0 {
        return shift(divide(v, divisor), by);
    }
    let (first, then) = ((by - 31).max(0), by.min(31));
    let v = shift(v, first);
    let whole = v.div_euclid(divisor);
    let rest = v.rem_euclid(divisor);
    shift(whole, then).saturating_add(divide(rest << then, divisor))
}

fn shift(v: i64, by: i32) -> i64 {
    if by >= 0 {
        v.saturating_mul(1i64 << by.min(62))
    } else {
        round(v, by.wrapping_neg().min(62))
    }
}

/// `slope * distance`, of at most 2^38 each, in the units of the distance.
fn scale(slope: i64, distance: i64) -> i64 {
    let (high, low) = (distance >> 16, distance & 0xffff);
    // 38 and 22 bits; 38 and 16.
    let low = (slope * low) >> 16;
    round(
        slope.saturating_mul(high).saturating_add(low),
        SLOPE_BITS - 16,
    )
}
