//! A bounding-volume hierarchy over boxes: median splits of their centres along the
//! widest axis. It only saves time; what is met is decided by the exact tests alone, so
//! boxes are taken a little too large.

use glam::DVec3;

const LEAF_BOXES: usize = 4;

/// Relative to a box's largest coordinate: far above the rounding of the box
/// test (a few 1e-16), far below any box's use.
const SLACK: f64 = 1e-12;

/// The hierarchy.
#[derive(Debug)]
pub(crate) struct Bvh {
    nodes: Vec<Node>,
    /// Numbers of the boxes, in the order of the leaves.
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

/// A line in any space: `origin + t * direction`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Line {
    /// Where t = 0.
    pub origin: DVec3,
    /// What is gained a unit of t; any length but 0.
    pub direction: DVec3,
}

impl Line {
    /// The place at `t`.
    pub fn at(&self, t: f64) -> DVec3 {
        self.origin + self.direction * t
    }
}

impl Bvh {
    /// Builds it over all boxes, each the lowest and the highest corner.
    pub fn new(boxes: &[[DVec3; 2]]) -> Self {
        let mut bvh = Self {
            nodes: Vec::new(),
            order: (0..boxes.len() as u32).collect(),
        };
        if !boxes.is_empty() {
            bvh.split(boxes, 0, boxes.len());
        }
        bvh
    }

    fn split(&mut self, boxes: &[[DVec3; 2]], start: usize, end: usize) {
        let range = &mut self.order[start..end];
        let [low, high] = bounds(range.iter().flat_map(|i| boxes[*i as usize]));
        let slack = DVec3::splat(SLACK * low.abs().max(high.abs()).max_element());
        let (low, high) = (low - slack, high + slack);
        if end - start <= LEAF_BOXES {
            self.nodes.push(Node {
                low,
                high,
                kind: Kind::Leaf { start, end },
            });
            return;
        }
        // Twice the centre.
        let centre = |i: &u32| boxes[*i as usize][0] + boxes[*i as usize][1];
        let [first, last] = bounds(range.iter().map(centre));
        let axis = (last - first).max_position();
        let middle = range.len() / 2;
        range.select_nth_unstable_by(middle, |a, b| centre(a)[axis].total_cmp(&centre(b)[axis]));
        let node = self.nodes.len();
        self.nodes.push(Node {
            low,
            high,
            kind: Kind::Inner { second: 0 },
        });
        self.split(boxes, start, start + middle);
        self.nodes[node].kind = Kind::Inner {
            second: self.nodes.len(),
        };
        self.split(boxes, start + middle, end);
    }

    /// Calls `visit` with each number whose box the line may meet at a t in
    /// `near..=limit`; `visit` returns the limit from then on.
    pub fn walk(
        &self,
        line: &Line,
        near: f64,
        mut limit: f64,
        mut visit: impl FnMut(usize) -> f64,
    ) {
        let mut stack = Vec::with_capacity(64);
        if !self.nodes.is_empty() {
            stack.push(0);
        }
        while let Some(index) = stack.pop() {
            let node: &Node = &self.nodes[index];
            if node.enter(line, near, limit).is_none() {
                continue;
            }
            match node.kind {
                Kind::Leaf { start, end } => {
                    for number in &self.order[start..end] {
                        limit = visit(*number as usize);
                    }
                }
                Kind::Inner { second } => {
                    let first = index + 1;
                    let enter = |child: usize| {
                        let found = self.nodes[child].enter(line, near, limit);
                        found.unwrap_or(f64::INFINITY)
                    };
                    let nearer_first = enter(first) <= enter(second);
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
    /// Slab test: where the line comes in, within the limits.
    fn enter(&self, line: &Line, near: f64, limit: f64) -> Option<f64> {
        let (mut enter, mut leave) = (near, limit);
        for axis in 0..3 {
            let low = self.low[axis] - line.origin[axis];
            let high = self.high[axis] - line.origin[axis];
            let slope = line.direction[axis];
            if slope == 0.0 {
                if low > 0.0 || high < 0.0 {
                    return None;
                }
            } else {
                let (a, b) = (low / slope, high / slope);
                enter = enter.max(a.min(b));
                leave = leave.min(a.max(b));
            }
        }
        (enter <= leave).then_some(enter)
    }
}

/// The box around points: lowest and highest corner.
pub(crate) fn bounds(points: impl IntoIterator<Item = DVec3>) -> [DVec3; 2] {
    let empty = [DVec3::INFINITY, DVec3::NEG_INFINITY];
    let wider = |[low, high]: [DVec3; 2], p: DVec3| [low.min(p), high.max(p)];
    points.into_iter().fold(empty, wider)
}
