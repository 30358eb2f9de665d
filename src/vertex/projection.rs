//! Clip coordinates to the screen.

use super::{ClipVertex, Rest, ScreenVertex};
use crate::math::{FineDepth, FineLevel, MAX_SCREEN, Reciprocal, SubPx, mul_high, reciprocal};
use crate::view::{ActorView, DepthMap, PerspectiveDepth};

/// Outcode bits: a vertex with any of them set cannot be projected as it is
/// (near, far) or would leave the range of screen positions (the others).
pub mod outside {
    /// Nearer than the near plane.
    pub const NEAR: u8 = 1;
    /// Farther than the far plane.
    pub const FAR: u8 = 2;
    /// Far to the left.
    pub const LEFT: u8 = 4;
    /// Far to the right.
    pub const RIGHT: u8 = 8;
    /// Far above.
    pub const ABOVE: u8 = 16;
    /// Far below.
    pub const BELOW: u8 = 32;
}

/// The outcode of clip coordinates.
#[inline(always)]
pub(crate) fn outcode(view: &ActorView, [x, y, distance]: [i32; 3]) -> u8 {
    let mut code = 0;
    if distance < view.near {
        code |= outside::NEAR;
    }
    if distance > view.far {
        code |= outside::FAR;
    }
    let guard = guard(view, distance);
    if x < guard.wrapping_neg() {
        code |= outside::LEFT;
    }
    if x > guard {
        code |= outside::RIGHT;
    }
    if y < guard.wrapping_neg() {
        code |= outside::ABOVE;
    }
    if y > guard {
        code |= outside::BELOW;
    }
    code
}

/// The largest clip x and y that project to within
/// [`MAX_SCREEN`](crate::math::MAX_SCREEN); 0 at or behind the eye.
#[inline(always)]
pub(crate) fn guard(view: &ActorView, distance: i32) -> i32 {
    let shift = view.guard_shift;
    if !view.perspective {
        return view.parallel_guard;
    }
    let distance = distance.max(0);
    if shift >= 0 {
        // Clip coordinates have at most 31 - shift bits.
        distance << (shift as u32).min(15)
    } else {
        distance >> shift.wrapping_neg().min(31)
    }
}

/// Projects a vertex that is within all planes; others get their outcode and no
/// position. Positions and depth are rounded to nearest.
#[inline(never)]
pub fn project(view: &ActorView, vertex: &ClipVertex) -> ScreenVertex {
    let clip = [vertex.x, vertex.y, vertex.distance];
    let outside = outcode(view, clip);
    let level = FineLevel::from_bits(vertex.level as u16);
    if outside != 0 {
        return ScreenVertex::beyond(outside).lit(level);
    }
    project_inside(view, clip).lit(level)
}

/// The same for clip coordinates that are known to be within all planes; not lit.
#[inline(always)]
pub fn project_inside(view: &ActorView, clip: [i32; 3]) -> ScreenVertex {
    if let Some(perspective) = Perspective::of(view) {
        return perspective.project_inside(clip);
    }
    let [x, y, distance] = clip;
    let z = view.depth.depth(distance, Reciprocal::default());
    screen_vertex(view, [view.parallel(x), view.parallel(y)], z)
}

/// A view in perspective, as a loop over vertices wants it: with nothing to choose.
pub(super) struct Perspective<'a> {
    view: &'a ActorView,
    depth: PerspectiveDepth,
}

impl<'a> Perspective<'a> {
    /// `None` of a parallel view.
    #[inline(always)]
    pub(super) fn of(view: &'a ActorView) -> Option<Self> {
        match view.depth {
            DepthMap::Perspective(depth) => Some(Self { view, depth }),
            DepthMap::Parallel { .. } => None,
        }
    }

    /// See [`project_inside`].
    #[inline(always)]
    pub(super) fn project_inside(&self, [x, y, distance]: [i32; 3]) -> ScreenVertex {
        let (view, recip) = (self.view, reciprocal(distance as u32));
        let z = self.depth.depth(recip);
        // (v << up) * mantissa / 2^32 is v / distance * 2^(29 - guard_shift),
        // and a 64th of a sub-pixel is 2^-(6 + lens's exponent) of it, which
        // is MAX_SCREEN's bits less guard_shift.
        let up = (recip.shift as i32 - view.guard_shift - 1).max(0) as u32;
        let divide = |v: i32| mul_high(v << up.min(31), recip.mantissa);
        screen_vertex(view, [divide(x), divide(y)], z)
    }
}

/// A vertex at 64ths of a sub-pixel from the screen's middle.
#[inline(always)]
fn screen_vertex(view: &ActorView, [x, y]: [i32; 2], z: FineDepth) -> ScreenVertex {
    let ([mx, my], (x, rest_x), (y, rest_y)) = (view.middle, split(x), split(y));
    let place = [x + mx, y + my].map(SubPx::from_bits);
    ScreenVertex::new(place, Rest::new(rest_x, rest_y), z)
}

/// Bits that a projected position has beyond a sub-pixel's.
const EXTRA_BITS: u32 = 6;

const _: () = assert!(30 - 1 - (MAX_SCREEN.ilog2()) == EXTRA_BITS);

/// The nearest sub-pixel, and what is left in the units of [`Rest`].
#[inline(always)]
fn split(v: i32) -> (i32, i32) {
    let nearest = (v + (1 << (EXTRA_BITS - 1))) >> EXTRA_BITS;
    (
        nearest,
        (v - (nearest << EXTRA_BITS)) >> (EXTRA_BITS - Rest::BITS),
    )
}
