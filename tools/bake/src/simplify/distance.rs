//! How far two surfaces are apart.

use fixel_scene::Mesh;
use glam::DVec3;
use rstar::{AABB, PointDistance, RTree, RTreeObject};

/// Most places of a surface that are looked at.
const PLACES: usize = 500_000;

/// A triangle in space.
struct Face([DVec3; 3]);

impl RTreeObject for Face {
    type Envelope = AABB<[f64; 3]>;

    fn envelope(&self) -> Self::Envelope {
        let [a, b, c] = self.0;
        AABB::from_corners(a.min(b).min(c).to_array(), a.max(b).max(c).to_array())
    }
}

impl PointDistance for Face {
    fn distance_2(&self, point: &[f64; 3]) -> f64 {
        let point = DVec3::from(*point);
        nearest(self.0, point).distance_squared(point)
    }
}

/// The place on a triangle that is nearest to a point (Ericson, "Real-Time Collision
/// Detection", 5.1.5).
fn nearest([a, b, c]: [DVec3; 3], p: DVec3) -> DVec3 {
    let (ab, ac) = (b - a, c - a);
    let along = |from: DVec3| (ab.dot(p - from), ac.dot(p - from));
    let ((d1, d2), (d3, d4), (d5, d6)) = (along(a), along(b), along(c));
    if d1 <= 0.0 && d2 <= 0.0 {
        return a;
    }
    if d3 >= 0.0 && d4 <= d3 {
        return b;
    }
    if d6 >= 0.0 && d5 <= d6 {
        return c;
    }
    let on_ab = d1 * d4 - d3 * d2;
    if on_ab <= 0.0 && d1 >= 0.0 && d3 <= 0.0 {
        return a + ab * (d1 / (d1 - d3));
    }
    let on_ac = d5 * d2 - d1 * d6;
    if on_ac <= 0.0 && d2 >= 0.0 && d6 <= 0.0 {
        return a + ac * (d2 / (d2 - d6));
    }
    let on_bc = d3 * d6 - d5 * d4;
    if on_bc <= 0.0 && d4 >= d3 && d5 >= d6 {
        return b + (c - b) * ((d4 - d3) / ((d4 - d3) + (d5 - d6)));
    }
    let sum = on_ab + on_ac + on_bc;
    a + ab * (on_ac / sum) + ac * (on_ab / sum)
}

/// A surface whose nearest place can be asked for.
pub(crate) struct Surroundings(RTree<Face>);

impl Surroundings {
    pub(crate) fn new(mesh: &Mesh) -> Self {
        Self(RTree::bulk_load(faces(mesh).map(Face).collect()))
    }

    /// How far a place is off the surface; 0 if it has no faces.
    pub(crate) fn distance(&self, place: DVec3) -> f64 {
        let place = place.to_array();
        let nearest = self.0.nearest_neighbor(place);
        nearest.map_or(0.0, |face| face.distance_2(&place).sqrt())
    }

    /// The greatest distance that places of a mesh have from the surface: its vertices, and
    /// within its faces so many more that there are about `places` in all.
    pub(crate) fn farthest(&self, mesh: &Mesh, places: usize) -> f64 {
        let corners = mesh.positions.iter().map(|p| DVec3::from(*p));
        let cells = places as f64 / mesh.triangles.len().max(1) as f64;
        // An even number: the middles of sides are often the farthest.
        let cells = 2 * ((cells.sqrt() / 2.0).ceil() as u32).max(1);
        let within = faces(mesh).flat_map(|face| inside(face, cells));
        let every = places.div_ceil(PLACES).max(1);
        let all = corners.step_by(every).chain(within.step_by(every));
        all.fold(0.0, |farthest, place| {
            // Most are nearer than the farthest up to now, which is soon seen.
            let around = (place.to_array(), farthest * farthest);
            let is_nearer = |(place, squared)| {
                let mut within = self.0.locate_within_distance(place, squared);
                within.next().is_some()
            };
            if is_nearer(around) {
                farthest
            } else {
                farthest.max(self.distance(place))
            }
        })
    }
}

fn faces(mesh: &Mesh) -> impl Iterator<Item = [DVec3; 3]> {
    let corner = |v: u32| DVec3::from(mesh.positions[v as usize]);
    mesh.triangles.iter().map(move |t| t.map(corner))
}

/// Places on a triangle and its sides, not its corners: those of a net of `cells` a side.
fn inside([a, b, c]: [DVec3; 3], cells: u32) -> impl Iterator<Item = DVec3> {
    let at = move |i: u32, j: u32| {
        let part = |n: u32| f64::from(n) / f64::from(cells);
        a + (b - a) * part(i) + (c - a) * part(j)
    };
    let all = (0..=cells).flat_map(move |i| (0..=cells - i).map(move |j| (i, j)));
    let is_corner = move |i: u32, j: u32| i == cells || j == cells || i + j == 0;
    all.filter(move |(i, j)| !is_corner(*i, *j))
        .map(move |(i, j)| at(i, j))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_nearest_place_is_on_the_triangle_and_nearer_than_any_other() {
        let face = [DVec3::ZERO, DVec3::X * 2.0, DVec3::new(0.5, 1.5, 0.5)];
        for i in 0..1000 {
            let part = |n: i32| f64::from((i * n) % 101) / 25.0 - 2.0;
            let point = DVec3::new(part(7), part(31), part(53));
            let found = nearest(face, point).distance(point);
            let others = inside(face, 40).chain(face);
            let least = others
                .map(|p| p.distance(point))
                .fold(f64::INFINITY, f64::min);
            assert!(found <= least + 1e-12 && least <= found + 0.05, "{point}");
        }
    }

    #[test]
    fn a_plane_above_another_is_as_far_as_it_is_high() {
        let square = |height: f64, size: f64| Mesh {
            positions: [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]]
                .map(|[x, z]| [x * size, height, z * size])
                .to_vec(),
            triangles: vec![[0, 1, 2], [0, 2, 3]],
            ..Mesh::default()
        };
        let low = Surroundings::new(&square(0.0, 1.0));
        assert_eq!(low.farthest(&square(0.25, 1.0), 100), 0.25);
        // A larger one hangs over at its corners.
        let found = low.farthest(&square(0.0, 2.0), 100);
        assert!((found - 2f64.sqrt()).abs() < 1e-12);
    }
}
