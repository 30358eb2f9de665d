//! Rays through the pixels of a viewport.

use super::ray::{FAR, Ray, moved};
use super::screen::TileRays;
use crate::math::{
    Reciprocal, Rect, SUBPX_BITS, Scaled, Unit3, Vec3, mul_high_u, reciprocal, unit,
};
use crate::scene::PlacedViewport;
use crate::view::{DepthMap, ViewFrame};

/// Fractional bits of what changes from pixel to pixel.
const FINE: u32 = 40;
/// The same of a parallel view, beyond raw bits: with 31 of those as many as turning
/// takes.
const FINE_PLACE: u32 = 15;

/// A view, ready to cast rays. What changes linearly with the pixel is worked out once;
/// for a perspective it is the direction, of which the part along the line of sight is
/// 1, for a parallel view the place.
#[derive(Clone, Copy, Debug)]
pub(super) struct RayCamera {
    perspective: bool,
    eye: [i32; 3],
    sight: Unit3,
    /// In the middle of pixel (0, 0): of directions the upper half has 30 bits, of places
    /// there are [`FINE_PLACE`] fractional bits of a raw bit.
    first: [i64; 3],
    /// Changes a pixel to the right and down.
    across: [i64; 3],
    down: [i64; 3],
    /// Right shift that brought directions of [`FINE`] fractional bits to 30 bits.
    shift: u32,
    /// Distances along the line of sight, raw world bits.
    near: i64,
    far: i64,
    /// Between these distances along any ray it is between the planes.
    within: [u32; 2],
    depth: DepthMap,
    frame: ViewFrame,
}

/// A camera's ray, not clipped yet.
#[derive(Clone, Copy, Debug)]
pub(super) struct Cast {
    pub ray: Ray,
    /// Of a perspective, distance along the line of sight for one along the ray, times
    /// `2^-(FINE - shift)`.
    per_length: Scaled,
}

impl RayCamera {
    /// That of a viewport. By itself: it takes much of the stack for a short while.
    #[inline(never)]
    pub(super) fn of(viewport: &PlacedViewport) -> Self {
        Self::new(&ViewFrame::of(viewport))
    }

    /// How the viewport is seen.
    pub(super) fn frame(&self) -> &ViewFrame {
        &self.frame
    }

    fn new(frame: &ViewFrame) -> Self {
        let [mx, my] = frame.lens.mantissas.map(|m| i64::from(m.max(1)));
        let fraction = if frame.perspective {
            FINE as i32
        } else {
            16 + FINE_PLACE as i32
        };
        // A pixel is 2^12 sub-pixels, which are mantissa / 2^31 * 2^exponent.
        let up = SUBPX_BITS as i32 + 31 - frame.lens.exponent + fraction;
        let step = |m: i64| divide_up(up, m);
        let (step_x, step_y) = (step(mx), -step(my));
        // From the middle of the picture to that of pixel (0, 0), in half pixels.
        let half = |size: u16, step: i64| (1 - i64::from(size)) * step / 2;
        let (x, y) = (half(frame.width, step_x), half(frame.height, step_y));
        let to_world = frame.rotation.transposed();
        let held = |v: i64| v.clamp(-(1 << 46), 1 << 46);
        let turned = |x: i64, y: i64, z: i64| to_world.apply_wide([held(x), held(y), z]);
        let [right, _, back] = frame.rotation.rows;
        let mut sight = back.map(|c| -c);
        let shear = i64::from(frame.shear) << (FINE - 30);
        if !frame.perspective && shear != 0 {
            let mut sheared = sight;
            for (c, r) in sheared.iter_mut().zip(right) {
                *c = c.saturating_sub(crate::math::mul_q30(frame.shear, r));
            }
            sight = unit(sheared).map_or(sight, |(unit, _)| unit);
        }
        let first = if frame.perspective {
            turned(x - shear, y, -(1 << FINE))
        } else {
            turned(x, y, 0)
        };
        let (across, down) = (turned(step_x, 0, 0), turned(0, step_y, 0));
        // The largest direction.
        let corners = [(0, 0), (1, 0), (0, 1), (1, 1)].map(|(right, bottom)| {
            let (columns, rows) = (
                i64::from(frame.width) * right,
                i64::from(frame.height) * bottom,
            );
            let all = first.into_iter().zip(across).zip(down);
            all.fold(0, |m, ((c, x), y)| {
                m | (c + x * columns + y * rows).unsigned_abs()
            })
        });
        let bits = 64 - corners.iter().fold(1, |m, c| m | c).leading_zeros();
        let shift = bits.saturating_sub(30);
        // To the upper half.
        let upper = |v: [i64; 3]| {
            if frame.perspective {
                v.map(|c| c << (32 - shift.min(32)))
            } else {
                v
            }
        };
        let (first, across, down) = (upper(first), upper(across), upper(down));
        let near = if frame.perspective {
            frame.near
        } else {
            frame.near.clamp(-(1 << 30), 1 << 30)
        };
        let mut camera = Self {
            perspective: frame.perspective,
            eye: frame.eye.to_bits(),
            sight,
            first,
            across,
            down,
            shift,
            near,
            far: frame.far,
            within: [FAR, 0],
            frame: *frame,
            depth: DepthMap::new(
                frame,
                16,
                frame.near.clamp(i32::MIN.into(), i32::MAX.into()) as i32,
            ),
        };
        if frame.perspective {
            camera.within = camera.between_planes();
        }
        camera
    }

    /// See [`RayCamera::is_within`]: the near plane is farthest along a ray in a corner.
    fn between_planes(&self) -> [u32; 2] {
        let (width, height) = (self.frame.width.into(), self.frame.height.into());
        let mut nearest = 0;
        for (column, row) in [(-1, -1), (width, -1), (-1, height), (width, height)] {
            let mut cast = self.cast(&self.at(column, row));
            self.clip(&mut cast);
            nearest = cast.ray.near.max(nearest);
        }
        let far = self.far.clamp(0, FAR.into()) as u32;
        [nearest + (nearest >> 10) + 64, far - (far >> 10)]
    }

    /// Where all rays start, of a perspective.
    pub(super) fn eye(&self) -> Option<[i32; 3]> {
        self.perspective.then_some(self.eye)
    }

    /// The rays of a tile, of a perspective.
    pub(super) fn tile(&self, tile: &Rect) -> Option<TileRays> {
        if !self.perspective {
            return None;
        }
        // Twice the way from the middle of pixel (0, 0).
        let twice = |low: u16, high: u16| i64::from(low) + i64::from(high) - 1;
        let (x, y) = (twice(tile.left, tile.right), twice(tile.top, tile.bottom));
        let mut middle = self.first;
        for ((c, across), down) in middle.iter_mut().zip(self.across).zip(self.down) {
            // The way to a corner of the picture and back may have 64 bits, the sum has 62.
            let way = (across >> 1).wrapping_mul(x);
            *c = c
                .wrapping_add(way)
                .wrapping_add((down >> 1).wrapping_mul(y));
        }
        let changes = self.across.iter().chain(&self.down);
        let bits = 64 - changes.fold(1, |m, c| m | c.unsigned_abs()).leading_zeros();
        let up = 30 - bits as i32;
        let change = |c: i64| if up >= 0 { c << up } else { c >> -up } as i32;
        Some(TileRays {
            middle: middle.map(|c| (c >> 32) as i32),
            across: self.across.map(change),
            down: self.down.map(change),
            up: up + 32,
        })
    }

    /// Whether what is met at a distance along a ray, and nothing nearer, is surely between
    /// a perspective's near plane and its far one.
    #[inline(always)]
    pub(super) fn is_within(&self, distance: u32) -> bool {
        let [nearest, farthest] = self.within;
        nearest < distance && distance < farthest
    }

    /// The same as [`RayCamera::bounds`]; `None` of what reaches before the near
    /// plane.
    pub(super) fn bounds_ahead(&self, centre: [i32; 3], radius: i32) -> Option<Rect> {
        let off = Vec3::from_bits(centre).minus(self.frame.eye);
        let [.., back] = self.frame.rotation.apply_wide(off);
        let ahead = -back - i64::from(radius) > 64 + self.near.min(1 << 30);
        ahead.then(|| self.bounds(centre, radius))
    }

    /// Pixels outside of this see nothing of a sphere, raw world bits.
    #[inline(never)]
    pub(super) fn bounds(&self, centre: [i32; 3], radius: i32) -> Rect {
        let frame = &self.frame;
        let all = Rect::of_size(frame.width, frame.height);
        let off = Vec3::from_bits(centre).minus(frame.eye);
        let [x, y, back] = frame.rotation.apply_wide(off);
        let (distance, radius) = (-back, i64::from(radius) + 16);
        let [mx, my] = frame.lens.mantissas.map(i64::from);
        let shear = i64::from(frame.shear);
        let x = x + ((shear * distance) >> 30);
        let reach = if shear == 0 { radius } else { 2 * radius };
        let (nearest, farthest) = (distance - radius, distance + radius);
        if farthest < self.near {
            return Rect::of_size(0, 0);
        }
        if self.perspective && nearest < 16 {
            return all;
        }
        // Pixels from the middle, rounded down. Of a perspective given with 20 fractional
        // bits, of a parallel view in raw world bits: 31 of either reach beyond any picture.
        let fraction = if self.perspective { 20 } else { 16 };
        let pixels = |ratio: i64, m: i64| {
            let down = 31 + fraction + SUBPX_BITS as i32 - frame.lens.exponent;
            let product = ratio.clamp(-(1 << 31), 1 << 31) * m;
            product >> down.clamp(0, 63)
        };
        let ratio = |side: i64| {
            if !self.perspective {
                return side;
            }
            let distance = if side > 0 { nearest } else { farthest };
            (side << 20).checked_div_euclid(distance).unwrap_or(0)
        };
        let span = |middle: i64, reach: i64, m: i64, size: u16| {
            let (size, half) = (i64::from(size), i64::from(size) / 2);
            let low = -pixels(ratio(reach - middle), m) + half - 2;
            let high = pixels(ratio(middle + reach), m) + half + 3;
            [low, high].map(|c| c.clamp(0, size) as u16)
        };
        let [left, right] = span(x, reach, mx, frame.width);
        let [top, bottom] = span(-y, radius, my, frame.height);
        Rect {
            left,
            top,
            right,
            bottom,
        }
    }

    /// What changes linearly, in the middle of a pixel.
    #[inline(always)]
    pub(super) fn at(&self, column: i32, row: i32) -> [i64; 3] {
        let mut at = self.first;
        for ((at, x), y) in at.iter_mut().zip(self.across).zip(self.down) {
            *at += x * i64::from(column) + y * i64::from(row);
        }
        at
    }

    /// The same a pixel to the right.
    #[inline(always)]
    pub(super) fn right_of(&self, at: &[i64; 3]) -> [i64; 3] {
        let mut right = *at;
        for (c, x) in right.iter_mut().zip(self.across) {
            *c += x;
        }
        right
    }

    /// The same `offset` away, in 2^-16 pixels.
    pub(super) fn beside(&self, at: &[i64; 3], offset: [i32; 2]) -> [i64; 3] {
        let [dx, dy] = offset.map(i64::from);
        let mut beside = *at;
        for ((c, x), y) in beside.iter_mut().zip(self.across).zip(self.down) {
            // In two parts: all of it would be too wide.
            let part = |c: i64, d: i64| (c >> 16) * d + (((c & 0xffff) * d) >> 16);
            *c += part(x, dx) + part(y, dy);
        }
        beside
    }

    /// The ray through a place of the picture. Where it is clipped is found by
    /// [`RayCamera::clip`].
    #[inline(always)]
    pub(super) fn cast(&self, at: &[i64; 3]) -> Cast {
        if !self.perspective {
            let mut origin = moved(self.eye, self.sight, self.near as i32);
            for (c, at) in origin.iter_mut().zip(*at) {
                let aside = (at >> FINE_PLACE).clamp(i32::MIN.into(), i32::MAX.into());
                *c = c.saturating_add(aside as i32);
            }
            let far = self.far.saturating_sub(self.near);
            return Cast {
                ray: Ray {
                    origin,
                    direction: self.sight,
                    near: 0,
                    far: far.clamp(0, FAR.into()) as u32,
                    on: 0,
                },
                per_length: Scaled::ZERO,
            };
        }
        let direction = at.map(|c| (c >> 32) as i32);
        let (direction, per_length) = unit(direction).unwrap_or((self.sight, Scaled::new(1, 0)));
        Cast {
            ray: Ray {
                origin: self.eye,
                direction,
                near: 0,
                far: FAR,
                on: 0,
            },
            per_length,
        }
    }

    /// Distance along the line of sight for one along a perspective's ray, below 2^32.
    #[inline(always)]
    fn cosine(&self, cast: &Cast) -> u32 {
        // The part along the line of sight is 2^(FINE - shift).
        let bits = FINE - self.shift.min(FINE) + 32;
        cast.per_length.fixed(bits)
    }

    /// Has a ray begin at the near plane and end at the far one.
    #[inline(never)]
    pub(super) fn clip(&self, cast: &mut Cast) {
        if self.perspective {
            let recip = reciprocal(self.cosine(cast));
            cast.ray.near = along(self.near, recip);
            cast.ray.far = along(self.far, recip);
        }
    }

    /// The depth at a distance along a ray, as the rasteriser has it.
    #[inline(always)]
    pub(super) fn depth(&self, cast: &Cast, distance: u32) -> u16 {
        let sight = if self.perspective {
            mul_high_u(distance, self.cosine(cast)) as i32
        } else {
            (i64::from(distance) + self.near).clamp(i32::MIN.into(), i32::MAX.into()) as i32
        };
        let recip = reciprocal(sight.max(1) as u32);
        let fine = self.depth.depth(sight, recip).to_bits();
        ((fine + 8) >> 4).clamp(1, 65535) as u16
    }
}

/// From a distance along the line of sight to one along a ray, of which the reciprocal of
/// the cosine is given.
#[inline(always)]
fn along(sight: i64, recip: Reciprocal) -> u32 {
    let Ok(sight) = u32::try_from(sight) else {
        return FAR;
    };
    // recip has 62 - shift fractional bits, the cosine 32.
    let high = mul_high_u(sight, recip.mantissa as u32);
    let up = recip.shift + 2;
    if up >= high.leading_zeros() {
        return FAR;
    }
    high.wrapping_shl(up).min(FAR)
}

/// `2^up / divisor`, for a divisor below 2^31; saturates at 2^62.
fn divide_up(up: i32, divisor: i64) -> i64 {
    let quotient = (1i64 << 62) / divisor.max(1);
    let up = up - 62;
    if up >= 0 {
        quotient.saturating_mul(1i64 << up.min(62))
    } else {
        (quotient >> (up.wrapping_neg() - 1).min(62)).wrapping_add(1) >> 1
    }
}
