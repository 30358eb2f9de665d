//! A bounding sphere against the view's sides, and the rows it may touch.

use super::Visible;
use crate::math::{SUBPX_BITS, reciprocal};
use crate::view::ActorView;

/// What a sphere of `radius` grid steps about a point with clip coordinates
/// `base` may touch, and what is `reach` pixels off it; `None` if it is beyond a side.
pub(super) fn extent(
    view: &ActorView,
    base: [i32; 3],
    radius: i32,
    height: u16,
    reach: u16,
) -> Option<Visible> {
    let [x, y, distance] = base.map(i64::from);
    // Rounded up, and 2 for the coordinate's own rounding.
    let grown = |length: i32| ((i64::from(radius) * i64::from(length)) >> view.row_fraction) + 2;
    let [_, length_y, length_d] = view.row_lengths;
    let (reach_y, reach_d) = (grown(length_y), grown(length_d));
    let (near, far) = (i64::from(view.near), i64::from(view.far));
    if distance + reach_d < near || distance - reach_d > far {
        return None;
    }
    let [side_x, side_y] = view.side_lengths;
    let [half_width, half_height] = view.middle.map(i64::from);
    let off = i64::from(reach) << SUBPX_BITS;
    let edge = |half, side| {
        let at = view.side_at(half + off, distance);
        at.saturating_add(grown(side) + 2)
    };
    if x.abs() > edge(half_width, side_x) || y.abs() > edge(half_height, side_y) {
        return None;
    }

    let nearest = (distance - reach_d).max(near).min(i32::MAX.into()) as i32;
    let farthest = (distance + reach_d).max(near).min(i32::MAX.into()) as i32;
    // The top is highest at the near end if it is above the middle, and so on.
    let (top, bottom) = (y - reach_y, y + reach_y);
    let top = screen(view, top, if top < 0 { nearest } else { farthest }) + half_height;
    let bottom = screen(view, bottom, if bottom > 0 { nearest } else { farthest }) + half_height;
    let row = |v: i64| (v >> SUBPX_BITS).clamp(0, i64::from(height)) as u16;
    let (first_row, end_row) = (
        row(top - off - 4),
        row(bottom + off + 4 + (1 << SUBPX_BITS)),
    );
    if first_row >= end_row {
        return None;
    }
    let ordered_by = if view.material.is_blended() {
        distance.max(near).min(i32::MAX.into()) as i32
    } else {
        nearest
    };
    let depth = view.depth.depth(ordered_by, reciprocal(ordered_by as u32));
    Some(Visible {
        first_row,
        end_row,
        nearness: (depth.to_bits() >> 4) as u16,
    })
}

/// A clip coordinate in sub-pixels from the middle, to within 2; held to 2^40.
#[inline(never)]
fn screen(view: &ActorView, v: i64, distance: i32) -> i64 {
    if !view.perspective {
        return i64::from(view.parallel(v.clamp(i32::MIN.into(), i32::MAX.into()) as i32)) >> 6;
    }
    let recip = reciprocal(distance as u32);
    let v = v.clamp(i32::MIN.into(), i32::MAX.into());
    let down = 62 - recip.shift as i32 - view.lens.exponent;
    let product = v * i64::from(recip.mantissa);
    let screen = if down >= 0 {
        product >> down.min(63)
    } else {
        product.saturating_mul(1 << down.wrapping_neg().min(62))
    };
    screen.clamp(-(1 << 40), 1 << 40)
}
