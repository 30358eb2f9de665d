//! Triangles that cross a plane. In: three [`ClipVertex`] and the planes of an
//! [`ActorView`]. Out: the polygon that is left, projected. Used by `render`
//! for the few triangles whose vertices carry an outcode.
//!
//! Sutherland and Hodgman, "Reentrant polygon clipping" (1974), in clip space,
//! against near, far and the four sides of the range of screen positions. What
//! is merely off the screen is not clipped but scissored, so that its edges do
//! not move.

use crate::vertex::{ClipVertex, ScreenVertex, guard, outcode, outside, project};
use crate::view::ActorView;

/// A triangle gains at most one vertex a plane.
pub const MOST_VERTICES: usize = 9;

/// A clipped triangle: a convex polygon on the screen, in the triangle's
/// winding.
#[derive(Clone, Copy, Debug)]
pub struct Polygon {
    vertices: [ScreenVertex; MOST_VERTICES],
    count: usize,
}

impl Polygon {
    /// The vertices; fewer than 3 if nothing is left.
    pub fn vertices(&self) -> &[ScreenVertex] {
        self.vertices.get(..self.count).unwrap_or_default()
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
pub fn clip(view: &ActorView, triangle: [ClipVertex; 3]) -> Polygon {
    let mut points = heapless::Vec::<ClipVertex, MOST_VERTICES>::from_iter(triangle);
    for plane in PLANES {
        let inside = |v: &ClipVertex| signed_distance(view, plane, v) >= 0;
        if points.iter().all(inside) {
            continue;
        }
        let mut kept = heapless::Vec::<ClipVertex, MOST_VERTICES>::new();
        let Some(mut before) = points.last().copied() else {
            break;
        };
        for point in &points {
            if inside(&before) != inside(point) {
                // From the inner to the outer end, so that both triangles of an
                // edge find the same point.
                let (inner, outer) = if inside(point) {
                    (point, &before)
                } else {
                    (&before, point)
                };
                let _ = kept.push(crossing(view, plane, inner, outer));
            }
            if inside(point) {
                let _ = kept.push(*point);
            }
            before = *point;
        }
        points = kept;
    }
    let mut polygon = Polygon {
        vertices: [ScreenVertex::default(); MOST_VERTICES],
        count: 0,
    };
    for (slot, point) in polygon.vertices.iter_mut().zip(&points) {
        *slot = project(view, &held(view, point));
        polygon.count += 1;
    }
    polygon
}

/// How far inside a plane a vertex is, in units of that plane.
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
fn crossing(view: &ActorView, plane: u8, inner: &ClipVertex, outer: &ClipVertex) -> ClipVertex {
    let (from, to) = (
        signed_distance(view, plane, inner),
        signed_distance(view, plane, outer),
    );
    let span = (from - to).max(1);
    // 34 bits at most: brought to 30 so that the products fit.
    let down = (34 - span.leading_zeros() as i32).max(0);
    let (from, span) = (from >> down, span >> down);
    let part = |a: i32, b: i32| {
        let way = (i64::from(b) - i64::from(a)) * from;
        let way = (way + span / 2).checked_div_euclid(span).unwrap_or(0);
        (i64::from(a) + way) as i32
    };
    ClipVertex {
        x: part(inner.x, outer.x),
        y: part(inner.y, outer.y),
        distance: part(inner.distance, outer.distance),
        level: part(inner.level, outer.level),
    }
}

/// A vertex on a plane may have rounded to its outer side: taken back.
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
