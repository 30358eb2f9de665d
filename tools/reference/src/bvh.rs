//! A bounding-volume hierarchy over view-space triangles: median splits of the
//! centres along the widest axis. It only saves time; what is met is decided
//! by [`crate::ray`] alone, so boxes are taken a little too large.

use crate::geometry::Face;
use crate::ray::Ray;
use glam::DVec3;

const LEAF_FACES: usize = 4;

/// Relative to a box's largest coordinate: far above the rounding of the box
/// test (a few 1e-16), far below any box's use.
const SLACK: f64 = 1e-12;

/// The hierarchy.
#[derive(Debug)]
pub(crate) struct Bvh {
    nodes: Vec<Node>,
    /// Face indices, in the order of the leaves.
    order: Vec<u32>,
}

#[derive(Debug)]
struct Node {
    low: DVec3,
    high: DVec3,
    kind: Kind,
}

#[derive(Debug)]
enum Kind {
    /// A range of `order`.
    Leaf { start: usize, end: usize },
    /// The first child is the next node; this is the second.
    Inner { second: usize },
}

impl Bvh {
    /// Builds it over all faces.
    pub fn new(faces: &[Face]) -> Self {
        let mut bvh = Self {
            nodes: Vec::new(),
            order: (0..faces.len() as u32).collect(),
        };
        if !faces.is_empty() {
            let centre = |f: &Face| f.corners[0] + f.corners[1] + f.corners[2];
            let centres: Vec<DVec3> = faces.iter().map(centre).collect();
            bvh.split(faces, &centres, 0, faces.len());
        }
        bvh
    }

    fn split(&mut self, faces: &[Face], centres: &[DVec3], start: usize, end: usize) {
        let range = &mut self.order[start..end];
        let corners = range.iter().flat_map(|i| faces[*i as usize].corners);
        let (low, high) = bounds(corners);
        let slack = DVec3::splat(SLACK * low.abs().max(high.abs()).max_element());
        let (low, high) = (low - slack, high + slack);
        if end - start <= LEAF_FACES {
            self.nodes.push(Node {
                low,
                high,
                kind: Kind::Leaf { start, end },
            });
            return;
        }
        let (first, last) = bounds(range.iter().map(|i| centres[*i as usize]));
        let axis = (last - first).max_position();
        let middle = range.len() / 2;
        range.select_nth_unstable_by(middle, |a, b| {
            centres[*a as usize][axis].total_cmp(&centres[*b as usize][axis])
        });
        let node = self.nodes.len();
        self.nodes.push(Node {
            low,
            high,
            kind: Kind::Inner { second: 0 },
        });
        self.split(faces, centres, start, start + middle);
        self.nodes[node].kind = Kind::Inner {
            second: self.nodes.len(),
        };
        self.split(faces, centres, start + middle, end);
    }

    /// Calls `visit` with each face that the ray may meet at a distance in
    /// `near..=limit`; `visit` returns the limit from then on.
    pub fn walk(&self, ray: &Ray, near: f64, mut limit: f64, mut visit: impl FnMut(usize) -> f64) {
        let mut stack = Vec::with_capacity(64);
        if !self.nodes.is_empty() {
            stack.push(0);
        }
        while let Some(index) = stack.pop() {
            let node = &self.nodes[index];
            if !node.may_meet(ray, near, limit) {
                continue;
            }
            match node.kind {
                Kind::Leaf { start, end } => {
                    for face in &self.order[start..end] {
                        limit = visit(*face as usize);
                    }
                }
                Kind::Inner { second } => {
                    let first = index + 1;
                    let nearer_first = self.nodes[first].low.z <= self.nodes[second].low.z;
                    stack.extend(if nearer_first {
                        [second, first]
                    } else {
                        [first, second]
                    });
                }
            }
        }
    }
}

impl Node {
    /// Slab test over the distance along the line of sight.
    fn may_meet(&self, ray: &Ray, near: f64, limit: f64) -> bool {
        let mut enter = near.max(self.low.z);
        let mut leave = limit.min(self.high.z);
        for axis in 0..2 {
            let low = self.low[axis] - ray.origin[axis];
            let high = self.high[axis] - ray.origin[axis];
            let slope = ray.slope[axis];
            if slope == 0.0 {
                if low > 0.0 || high < 0.0 {
                    return false;
                }
            } else {
                let (a, b) = (low / slope, high / slope);
                enter = enter.max(a.min(b));
                leave = leave.min(a.max(b));
            }
        }
        enter <= leave
    }
}

fn bounds(points: impl Iterator<Item = DVec3>) -> (DVec3, DVec3) {
    let empty = (DVec3::INFINITY, DVec3::NEG_INFINITY);
    points.fold(empty, |(low, high), p| (low.min(p), high.max(p)))
}
