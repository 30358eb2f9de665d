//! Triangles that cross a plane. In: three [`ClipVertex`] and the planes of an
//! [`ActorView`]. Out: the polygon that is left, projected. Used by `render`
//! and `immediate` for the few triangles whose vertices carry an outcode.
//!
//! Sutherland and Hodgman, "Reentrant polygon clipping" (1974), in clip space,
//! against near, far and the four sides of the range of screen positions. What
//! is merely off the screen is not clipped but scissored, so that its edges do
//! not move.
#![expect(
    clippy::arithmetic_side_effects,
    reason = "clip coordinates and weights are held to what fits the 64 bits of their products; tests stop at overflow"
)]

use crate::math::{keep_rolled, rolled};
use crate::vertex::{ClipVertex, ScreenVertex, guard, outcode, outside, project};
use crate::view::ActorView;

/// A triangle gains at most one vertex a plane.
pub const MOST_VERTICES: usize = 9;

/// A clipped triangle: a convex polygon on the screen, in the triangle's
/// winding.
#[derive(Clone, Copy, Debug)]
pub struct Polygon {
    vertices: [ScreenVertex; MOST_VERTICES],
    cuts: [Cut; MOST_VERTICES],
    count: usize,
}

/// Where a vertex of a clipped triangle is in it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Cut {
    /// Distance along the line of sight.
    pub distance: i32,
    /// Weights of the triangle's corners in space, [`WEIGHT_BITS`] fractional bits;
    /// their sum is 1 to within rounding.
    pub weights: [i32; 3],
}

/// Fractional bits of a [`Cut`]'s weights.
pub const WEIGHT_BITS: u32 = 29;

/// A vertex on the way through the planes.
#[derive(Clone, Copy)]
struct Point {
    vertex: ClipVertex,
    weights: [i32; 3],
}

impl Polygon {
    /// The vertices; fewer than 3 if nothing is left.
    pub fn vertices(&self) -> &[ScreenVertex] {
        self.vertices.get(..self.count).unwrap_or_default()
    }

    /// Where they are in the triangle.
    pub fn cuts(&self) -> &[Cut] {
        self.cuts.get(..self.count).unwrap_or_default()
    }
}

/// The planes in the order they are taken.
const PLANES: [u8; 6] = [
    outside::NEAR,
    outside::FAR,
    outside::LEFT,
    outside::RIGHT,
    outside::ABOVE,
    outside::BELOW,
];

/// Clips a triangle against all planes.
#[inline(never)]
pub fn clip(view: &ActorView, triangle: [ClipVertex; 3]) -> Polygon {
    const ONE: i32 = 1 << WEIGHT_BITS;
    let corners = [[ONE, 0, 0], [0, ONE, 0], [0, 0, ONE]];
    let corners = triangle.into_iter().zip(corners);
    let corners = corners.map(|(vertex, weights)| Point { vertex, weights });
    let mut points = heapless::Vec::<Point, MOST_VERTICES>::from_iter(corners);
    for plane in PLANES {
        let inside = |p: &Point| signed_distance(view, plane, &p.vertex) >= 0;
        if points.iter().all(inside) {
            continue;
        }
        let mut kept = heapless::Vec::<Point, MOST_VERTICES>::new();
        let Some(mut before) = points.last() else {
            break;
        };
        let mut was_inside = inside(before);
        for point in &points {
            let is_inside = inside(point);
            if was_inside != is_inside {
                // From the inner to the outer end, so that both triangles of an
                // edge find the same point.
                let (inner, outer) = if is_inside {
                    (point, before)
                } else {
                    (before, point)
                };
                let _ = kept.push(crossing(view, plane, inner, outer));
            }
            if is_inside {
                let _ = kept.push(*point);
            }
            (before, was_inside) = (point, is_inside);
        }
        points = kept;
    }
    let mut polygon = Polygon {
        vertices: [ScreenVertex::default(); MOST_VERTICES],
        cuts: [Cut::default(); MOST_VERTICES],
        count: 0,
    };
    let slots = polygon.vertices.iter_mut().zip(&mut polygon.cuts);
    for ((vertex, cut), point) in slots.zip(&points) {
        let held = held(view, &point.vertex);
        *vertex = project(view, &held);
        *cut = Cut {
            distance: held.distance,
            weights: point.weights,
        };
        polygon.count += 1;
    }
    polygon
}

/// The part of a line between all planes, projected, and the weights of the line's ends
/// where it ends, as in [`Cut`]; the third one is 0.
pub fn clip_line(
    view: &ActorView,
    [a, b]: [ClipVertex; 2],
) -> Option<[(ScreenVertex, [i32; 3]); 2]> {
    const ONE: i32 = 1 << WEIGHT_BITS;
    let point = |vertex, weights| Point { vertex, weights };
    let (mut a, mut b) = (point(a, [ONE, 0, 0]), point(b, [0, ONE, 0]));
    for plane in PLANES {
        let inside = [&a, &b].map(|p| signed_distance(view, plane, &p.vertex) >= 0);
        match inside {
            [true, true] => {}
            [false, false] => return None,
            [true, false] => b = crossing(view, plane, &a, &b),
            [false, true] => a = crossing(view, plane, &b, &a),
        }
    }
    Some([a, b].map(|p| (project(view, &held(view, &p.vertex)), p.weights)))
}

/// How far inside a plane a vertex is, in units of that plane.
#[inline(never)]
fn signed_distance(view: &ActorView, plane: u8, v: &ClipVertex) -> i64 {
    let (x, y, distance) = (i64::from(v.x), i64::from(v.y), i64::from(v.distance));
    // The guard is linear in distance only in front of the eye, where it is
    // used: the near plane comes first.
    let guard = i64::from(guard(view, v.distance));
    match plane {
        outside::NEAR => distance - i64::from(view.near),
        outside::FAR => i64::from(view.far) - distance,
        outside::LEFT => guard + x,
        outside::RIGHT => guard - x,
        outside::ABOVE => guard + y,
        _ => guard - y,
    }
}

/// Where an edge crosses a plane.
#[inline(never)]
fn crossing(view: &ActorView, plane: u8, inner: &Point, outer: &Point) -> Point {
    let (a, b) = (&inner.vertex, &outer.vertex);
    let (from, to) = (
        signed_distance(view, plane, a),
        signed_distance(view, plane, b),
    );
    let span = (from - to).max(1);
    // 34 bits at most: brought to 30 so that the products fit.
    let down = (34 - span.leading_zeros() as i32).max(0);
    let (from, span) = (from >> down, span >> down);
    let all = |p: &Point| {
        let (ClipVertex { x, y, .. }, [wa, wb, wc]) = (p.vertex, p.weights);
        [x, y, p.vertex.distance, p.vertex.level, wa, wb, wc]
    };
    let mut parts = [[0; 2]; 7];
    for (pair, both) in parts.iter_mut().zip(all(inner).into_iter().zip(all(outer))) {
        *pair = [both.0, both.1];
    }
    for [part, other] in rolled(&mut parts) {
        let way = (i64::from(*other) - i64::from(*part)) * from;
        let way = (way + span / 2).checked_div_euclid(span).unwrap_or(0);
        *part = (i64::from(*part) + way) as i32;
        keep_rolled();
    }
    let [x, y, distance, level, weights @ ..] = parts.map(|[part, _]| part);
    let vertex = ClipVertex {
        x,
        y,
        distance,
        level,
    };
    Point { vertex, weights }
}

/// A vertex on a plane may have rounded to its outer side: taken back.
#[inline(never)]
fn held(view: &ActorView, v: &ClipVertex) -> ClipVertex {
    let mut v = *v;
    v.distance = v.distance.max(view.near).min(view.far);
    if outcode(view, [v.x, v.y, v.distance]) != 0 {
        let guard = guard(view, v.distance);
        v.x = v.x.max(-guard).min(guard);
        v.y = v.y.max(-guard).min(guard);
    }
    v
}
