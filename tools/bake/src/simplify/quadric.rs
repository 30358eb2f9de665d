//! What a vertex costs where it is put: the quadric error of Garland and Heckbert,
//! "Surface simplification using quadric error metrics" (1997), with attributes as Hoppe,
//! "New quadric metric for simplifying meshes with appearance attributes" (1999).

use std::ops::AddAssign;

use glam::{DMat3, DVec3};

/// Most attributes of a corner: a normal, a colour, a place in a texture.
pub(super) const ATTRIBUTES: usize = 8;

/// Squared distances to planes: `p A p + 2 b p + c`.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Quadric {
    a: DMat3,
    b: DVec3,
    c: f64,
}

impl Quadric {
    pub(super) const ZERO: Self = Self {
        a: DMat3::ZERO,
        b: DVec3::ZERO,
        c: 0.0,
    };

    /// `weight (g p + d)^2`.
    pub(super) fn of(g: DVec3, d: f64, weight: f64) -> Self {
        let scaled = g * weight;
        Self {
            a: DMat3::from_cols(scaled * g.x, scaled * g.y, scaled * g.z),
            b: scaled * d,
            c: weight * d * d,
        }
    }

    pub(super) fn at(&self, p: DVec3) -> f64 {
        (p.dot(self.a * p) + 2.0 * p.dot(self.b) + self.c).max(0.0)
    }

    /// Where it is least, near `middle` in directions in which it is all but the same.
    pub(super) fn least(&self, middle: DVec3) -> Option<DVec3> {
        let trace = self.a.x_axis.x + self.a.y_axis.y + self.a.z_axis.z;
        let pull = trace * PULL;
        let a = self.a + DMat3::from_diagonal(DVec3::splat(pull));
        let place = a.inverse() * (middle * pull - self.b);
        place.is_finite().then_some(place)
    }
}

/// How strongly a place is pulled to the middle of what becomes it, over what the planes pull.
const PULL: f64 = 1e-4;

impl AddAssign for Quadric {
    fn add_assign(&mut self, other: Self) {
        self.a += other.a;
        self.b += other.b;
        self.c += other.c;
    }
}

/// What faces cost that meet in a corner with attributes: each attribute is a linear
/// function of the place on a face, `g p + d`, and the corner's is the best for all faces.
#[derive(Clone, Copy, Debug)]
pub(super) struct Fit {
    plain: Quadric,
    area: f64,
    g: [DVec3; ATTRIBUTES],
    d: [f64; ATTRIBUTES],
}

impl Fit {
    pub(super) const ZERO: Self = Self {
        plain: Quadric::ZERO,
        area: 0.0,
        g: [DVec3::ZERO; ATTRIBUTES],
        d: [0.0; ATTRIBUTES],
    };

    /// A face with attributes at its corners, of which `count` count.
    pub(super) fn of_face(
        [p, q, r]: [DVec3; 3],
        attributes: [&[f64; ATTRIBUTES]; 3],
        count: usize,
    ) -> Self {
        let mut fit = Self::ZERO;
        let (u, v) = (q - p, r - p);
        let across = u.cross(v);
        let doubled = across.length();
        let Some(normal) = across.try_normalize() else {
            return fit;
        };
        fit.area = doubled / 2.0;
        fit.plain = Quadric::of(normal, -normal.dot(p), fit.area);
        // Of two sides that are all but parallel the change across is not known.
        if doubled < 1e-6 * u.length_squared().max(v.length_squared()) {
            fit.area = 0.0;
            return fit;
        }
        // Gradients of the weights of q and r.
        let (along_u, along_v) = (v.cross(normal) / doubled, normal.cross(u) / doubled);
        for i in 0..count {
            let [at_p, at_q, at_r] = attributes.map(|a| a[i]);
            let g = along_u * (at_q - at_p) + along_v * (at_r - at_p);
            let d = at_p - g.dot(p);
            fit.plain += Quadric::of(g, d, fit.area);
            fit.g[i] = g * fit.area;
            fit.d[i] = d * fit.area;
        }
        fit
    }

    /// The best attributes at a place; those given if no face says anything.
    pub(super) fn attributes(&self, p: DVec3, held: &[f64; ATTRIBUTES]) -> [f64; ATTRIBUTES] {
        let mut all = *held;
        if self.area > 0.0 {
            for (i, value) in all.iter_mut().enumerate() {
                *value = (self.g[i].dot(p) + self.d[i]) / self.area;
            }
        }
        all
    }

    /// The area of the faces.
    pub(super) fn area(&self) -> f64 {
        self.area
    }

    /// What a place costs with the best attributes there.
    pub(super) fn quadric(&self, count: usize) -> Quadric {
        let mut quadric = self.plain;
        if self.area > 0.0 {
            for i in 0..count {
                quadric += Quadric::of(self.g[i], self.d[i], -1.0 / self.area);
            }
        }
        quadric
    }
}

impl AddAssign for Fit {
    fn add_assign(&mut self, other: Self) {
        self.plain += other.plain;
        self.area += other.area;
        for i in 0..ATTRIBUTES {
            self.g[i] += other.g[i];
            self.d[i] += other.d[i];
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn three_planes_meet_where_they_cost_least() {
        let corner = DVec3::new(0.25, -0.5, 2.0);
        let mut quadric = Quadric::ZERO;
        for normal in [DVec3::X, DVec3::Y, DVec3::new(0.6, 0.0, 0.8)] {
            quadric += Quadric::of(normal, -normal.dot(corner), 3.0);
        }
        let found = quadric.least(corner + DVec3::splat(0.1)).unwrap();
        assert!(found.distance(corner) < 1e-3, "{found}");
        assert!(quadric.at(corner) < 1e-12);
        assert!((quadric.at(corner + DVec3::Y) - 3.0).abs() < 1e-9);
    }

    #[test]
    fn attributes_that_are_linear_cost_nothing_and_stay() {
        let value = |p: DVec3| [p.x * 2.0 + 1.0, p.y, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0];
        let corners = [DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::new(1.0, 1.0, 0.0)];
        let mut fit = Fit::ZERO;
        for face in [[0, 1, 2], [1, 3, 2]] {
            let corners = face.map(|i: usize| corners[i]);
            let values = corners.map(value);
            fit += Fit::of_face(corners, values.each_ref(), 2);
        }
        let place = DVec3::new(0.3, 0.7, 0.0);
        assert!(fit.quadric(2).at(place) < 1e-12);
        let found = fit.attributes(place, &[9.0; ATTRIBUTES]);
        assert!((found[0] - 1.6).abs() < 1e-9 && (found[1] - 0.7).abs() < 1e-9);
        assert!(fit.quadric(2).at(place + DVec3::Z) > 0.9);
    }
}
