//! Polygons into triangles: a fan where the polygon is convex, ears cut off
//! one by one where it is not (G. Meisters, "Polygons have ears", 1975).
//!
//! Own code for the faces of meshes, not the `earcut` crate, because that one
//! drops corners that lie on a straight line: where the neighbour has a vertex
//! there, the surface would have cracks. Polygons with holes go through the
//! crate; see [`super::primitive`].

use std::collections::HashSet;

use glam::{DVec2, DVec3};

use super::{MAX_COORDINATE, Soup};

/// Cutting ears takes time by the square of the corners.
const MAX_EARS: usize = 10_000;

/// Room for the corners of a polygon, used again by the next.
#[derive(Debug, Default)]
pub(super) struct Polygons {
    corners: Vec<(u32, DVec2)>,
}

/// Whether a position can be worked with.
pub(super) fn is_sane(position: &[f64; 3]) -> bool {
    position.iter().all(|x| x.abs() <= MAX_COORDINATE)
}

impl Polygons {
    /// Adds the triangles of one polygon: one for each corner beyond two.
    /// Corners are indices into the soup's positions.
    pub fn push(&mut self, soup: &mut Soup, corners: &[u32]) {
        let first = soup.triangles.len();
        self.triangulate(&soup.positions, corners, &mut soup.triangles);
        let added = &soup.triangles[first..];
        if added.len() > 1 {
            let outline = corners.iter().zip(corners.iter().cycle().skip(1));
            let outline: HashSet<[u32; 2]> = outline.map(|(a, b)| sorted([*a, *b])).collect();
            let sides = added.iter().flat_map(|triangle| sides(*triangle));
            let inner = sides.map(sorted).filter(|side| !outline.contains(side));
            soup.diagonals.extend(inner);
        }
    }

    fn triangulate(&mut self, positions: &[[f64; 3]], corners: &[u32], out: &mut Vec<[u32; 3]>) {
        if let [a, b, c] = *corners {
            out.push([a, b, c]);
            return;
        }
        self.flatten(positions, corners);
        let convex = (0..corners.len()).all(|at| self.turn(at) >= 0.0);
        if !convex && corners.len() <= MAX_EARS {
            while self.corners.len() > 3 {
                let ear = self.ear();
                let (before, after) = self.beside(ear);
                out.push([before, ear, after].map(|at| self.corners[at].0));
                self.corners.remove(ear);
            }
        }
        for at in 2..self.corners.len() {
            out.push([0, at - 1, at].map(|at| self.corners[at].0));
        }
    }

    /// Corners in the plane that sees most of the polygon, counter-clockwise.
    fn flatten(&mut self, positions: &[[f64; 3]], corners: &[u32]) {
        let points: Vec<DVec3> = corners
            .iter()
            .map(|&corner| positions[corner as usize].into())
            .collect();
        let next = points.iter().cycle().skip(1);
        // Newell's normal.
        let normal: DVec3 = points
            .iter()
            .zip(next)
            .map(|(a, b)| (*a - points[0]).cross(*b - points[0]))
            .sum();
        let size = normal.abs();
        let flat = |p: &DVec3| {
            if size.z >= size.x && size.z >= size.y {
                DVec2::new(p.x, p.y * normal.z.signum())
            } else if size.x >= size.y {
                DVec2::new(p.y, p.z * normal.x.signum())
            } else {
                DVec2::new(p.z, p.x * normal.y.signum())
            }
        };
        self.corners.clear();
        self.corners
            .extend(corners.iter().copied().zip(points.iter().map(flat)));
    }

    fn beside(&self, at: usize) -> (usize, usize) {
        let count = self.corners.len();
        ((at + count - 1) % count, (at + 1) % count)
    }

    /// Positive at a convex corner.
    fn turn(&self, at: usize) -> f64 {
        let (before, after) = self.beside(at);
        let [a, b, c] = [before, at, after].map(|at| self.corners[at].1);
        (b - a).perp_dot(c - b)
    }

    /// A corner whose triangle holds no other corner; the first convex one,
    /// or the first, if the polygon crosses itself and has no ear.
    fn ear(&self) -> usize {
        let convex = || (0..self.corners.len()).filter(|&at| self.turn(at) > 0.0);
        convex()
            .find(|&at| self.is_empty(at))
            .or_else(|| convex().next())
            .unwrap_or(0)
    }

    fn is_empty(&self, at: usize) -> bool {
        let (before, after) = self.beside(at);
        let [a, b, c] = [before, at, after].map(|at| self.corners[at].1);
        self.corners.iter().enumerate().all(|(other, (_, p))| {
            let own = [before, at, after].contains(&other) || [a, b, c].contains(p);
            own || (b - a).perp_dot(*p - a) < 0.0
                || (c - b).perp_dot(*p - b) < 0.0
                || (a - c).perp_dot(*p - c) < 0.0
        })
    }
}

/// A triangle's sides, each from its corner on.
pub(super) fn sides([a, b, c]: [u32; 3]) -> [[u32; 2]; 3] {
    [[a, b], [b, c], [c, a]]
}

/// The same whichever way the side is gone.
pub(super) fn sorted([a, b]: [u32; 2]) -> [u32; 2] {
    [a.min(b), a.max(b)]
}

/// Adds the triangles of a strip: each corner with the two before it, every
/// other one turned round.
pub(super) fn strip(corners: &[u32], out: &mut Vec<[u32; 3]>) {
    for (at, corner) in corners.windows(3).enumerate() {
        let [a, b, c] = [corner[0], corner[1], corner[2]];
        out.push(if at % 2 == 0 { [a, b, c] } else { [b, a, c] });
    }
}
