//! One ray against one triangle, without gaps.
//!
//! Method: Woop, Benthin, Wald, "Watertight Ray/Triangle Intersection",
//! JCGT 2(1), 2013. The vertices are sheared so that the ray becomes the line
//! x = y = 0; each edge then is a 2D cross product of two sheared vertices.
//! Two triangles that share an edge shear the same two vertices to the same
//! values, so they see products that are exact negatives of each other. A
//! product that rounds to 0 is worked out exactly from the rounding errors
//! (Dekker's two-product, by fused multiply-add); thus every sign is exact
//! for the sheared vertices, which form a planar mesh without gaps.

use crate::bvh::Line;
use glam::DVec3;

/// A ray in view space that advances by 1 along the line of sight: at distance
/// `w` it is at `origin + w * slope`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Ray {
    /// x and y at w = 0.
    pub origin: [f64; 2],
    /// x and y gained a unit of w.
    pub slope: [f64; 2],
}

/// Where a ray's line meets a triangle.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Meeting {
    /// Distance along the line of sight; not yet limited to any range.
    pub w: f64,
    /// Weights of the three vertices, in 0..=1, sum 1; exact in 3D, so what is
    /// interpolated with them is perspective-correct.
    pub weights: [f64; 3],
    /// The vertices appear counter-clockwise along the ray.
    pub counter_clockwise: bool,
}

impl Ray {
    /// The same in view space: t is the distance along the line of sight.
    pub fn line(&self) -> Line {
        let ([x, y], [right, up]) = (self.origin, self.slope);
        Line {
            origin: DVec3::new(x, y, 0.0),
            direction: DVec3::new(right, up, 1.0),
        }
    }

    /// Meets a triangle given in view space. The line counts in both
    /// directions, so vertices behind the eye need no care.
    pub fn meet(&self, triangle: [DVec3; 3]) -> Option<Meeting> {
        let [a, b, c] = triangle.map(|v| self.shear(v));
        let edges = [edge(b, c), edge(c, a), edge(a, b)];
        let inside = edges[0].1 == edges[1].1 && edges[1].1 == edges[2].1;
        if !inside {
            return None;
        }
        let sum = edges[0].0 + edges[1].0 + edges[2].0;
        if sum == 0.0 {
            return None;
        }
        let weights = edges.map(|(value, _)| value / sum);
        let w =
            weights[0] * triangle[0].z + weights[1] * triangle[1].z + weights[2] * triangle[2].z;
        Some(Meeting {
            w,
            weights,
            counter_clockwise: edges[0].1,
        })
    }

    /// Weights of a triangle's vertices where the ray's line meets its plane, inside
    /// or out of it; sum 1.
    pub fn weights(&self, triangle: [DVec3; 3]) -> [f64; 3] {
        weights(triangle.map(|v| self.shear(v)))
    }

    /// A vertex relative to the ray at the vertex's own distance.
    fn shear(&self, v: DVec3) -> [f64; 2] {
        [
            (v.x - self.origin[0]) - self.slope[0] * v.z,
            (v.y - self.origin[1]) - self.slope[1] * v.z,
        ]
    }
}

/// Weights of three points of a plane whose mean is (0, 0); sum 1.
pub(crate) fn weights([a, b, c]: [[f64; 2]; 3]) -> [f64; 3] {
    let edges = [edge(b, c), edge(c, a), edge(a, b)].map(|(value, _)| value);
    let sum: f64 = edges.iter().sum();
    edges.map(|value| value / sum)
}

/// The cross product of two sheared vertices, and whether the ray passes left
/// of the edge from `a` to `b`. Swapping the vertices gives the exact negative
/// and the other side.
fn edge(a: [f64; 2], b: [f64; 2]) -> (f64, bool) {
    let (p, q) = (a[0] * b[1], a[1] * b[0]);
    let mut value = p - q;
    if value == 0.0 {
        value = a[0].mul_add(b[1], -p) - a[1].mul_add(b[0], -q);
    }
    let left = if value == 0.0 { a < b } else { value > 0.0 };
    (value, left)
}

#[cfg(test)]
mod tests {
    use super::*;

    const STRAIGHT: Ray = Ray {
        origin: [0.0, 0.0],
        slope: [0.0, 0.0],
    };

    #[test]
    fn a_shared_edge_has_opposite_sides() {
        let points = [
            [0.1, 0.3],
            [0.2, 0.6],
            [1e-9, 3e-9],
            [-0.7, -2.1],
            [0.0, 0.0],
        ];
        for a in points {
            for b in points.into_iter().filter(|b| *b != a) {
                assert_eq!(edge(a, b).0, -edge(b, a).0);
                assert_ne!(edge(a, b).1, edge(b, a).1);
            }
        }
    }

    #[test]
    fn a_product_that_rounds_to_zero_keeps_its_sign() {
        let tiny = 1.0 + f64::EPSILON;
        // 1 * 1 against (1 + e)(1 - e) = 1 - e^2.
        let (value, left) = edge([1.0, tiny], [1.0 - f64::EPSILON, 1.0]);
        assert!(value > 0.0 && left);
        assert_eq!(value, f64::EPSILON * f64::EPSILON);
    }

    #[test]
    fn weights_and_distance_are_those_of_the_point() {
        let triangle = [
            DVec3::new(-1.0, -1.0, 2.0),
            DVec3::new(3.0, -1.0, 6.0),
            DVec3::new(-1.0, 3.0, 10.0),
        ];
        let meeting = STRAIGHT.meet(triangle).unwrap();
        assert_eq!(meeting.weights, [0.5, 0.25, 0.25]);
        assert_eq!(meeting.w, 5.0);
        assert!(meeting.counter_clockwise);
        let [a, b, c] = triangle;
        assert!(!STRAIGHT.meet([a, c, b]).unwrap().counter_clockwise);
    }

    #[test]
    fn a_triangle_without_area_is_never_met() {
        let (a, b) = (DVec3::new(-1.0, -1.0, 1.0), DVec3::new(1.0, 1.0, 1.0));
        assert!(STRAIGHT.meet([a, b, b]).is_none());
        assert!(STRAIGHT.meet([a, a, a]).is_none());
        assert!(STRAIGHT.meet([a, b, DVec3::new(0.5, 0.5, 1.0)]).is_none());
    }
}
