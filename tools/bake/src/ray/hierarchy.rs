//! A hierarchy of boxes over a mesh's triangles: a binary tree by the surface-area
//! heuristic (Goldsmith and Salmon, "Automatic creation of object hierarchies for ray
//! tracing", 1987; MacDonald and Booth, "Heuristics for ray tracing using space
//! subdivision", 1990), of which two levels or so become one node of four boxes.

use fixel::scene::layout::RAY_STACK;
use fixel::scene::{Child, Leaf, Node};
use glam::{I64Vec3, IVec3};

/// Most triangles of a leaf.
const LEAF: usize = 4;
/// What a box test costs, in triangle tests.
const STEP: f64 = 0.7;
/// Beyond this depth of the binary tree, halves are equal in number. So it ends after
/// 20 more of them, and 48 boxes are enough for a ray to leave behind.
const EVEN_FROM: usize = 18;

/// A triangle on the grid.
#[derive(Clone, Copy, Debug)]
pub(super) struct Item {
    /// Its meshlet, counted in the mesh.
    pub meshlet: u32,
    /// Its number in the meshlet.
    pub triangle: u8,
    pub bounds: Box3,
}

/// A box on the grid.
#[derive(Clone, Copy, Debug)]
pub(super) struct Box3 {
    pub low: IVec3,
    pub high: IVec3,
}

impl Box3 {
    const EMPTY: Self = Self {
        low: IVec3::MAX,
        high: IVec3::MIN,
    };

    pub(super) fn of(points: impl IntoIterator<Item = IVec3>) -> Self {
        let add = |b: Self, p: IVec3| Self {
            low: b.low.min(p),
            high: b.high.max(p),
        };
        points.into_iter().fold(Self::EMPTY, add)
    }

    fn with(self, other: Self) -> Self {
        Self {
            low: self.low.min(other.low),
            high: self.high.max(other.high),
        }
    }

    fn area(&self) -> f64 {
        if self.low.x > self.high.x {
            return 0.0;
        }
        let size = (self.high - self.low).as_dvec3();
        size.x * size.y + size.y * size.z + size.z * size.x
    }

    /// Twice its middle.
    fn middle(&self) -> I64Vec3 {
        self.low.as_i64vec3() + self.high.as_i64vec3()
    }
}

enum Tree {
    Leaf(Vec<Item>),
    Split(Box3, Box<[Tree; 2]>),
}

impl Tree {
    fn bounds(&self) -> Box3 {
        match self {
            Self::Leaf(items) => bounds(items),
            Self::Split(bounds, _) => *bounds,
        }
    }
}

fn bounds(items: &[Item]) -> Box3 {
    let all = items.iter().map(|item| item.bounds);
    all.fold(Box3::EMPTY, Box3::with)
}

/// A hierarchy, and the triangles in the order in which its leaves have them: a leaf's
/// number of its first triangle is its place among its meshlet's triangles in there.
pub(super) struct Hierarchy {
    pub nodes: Vec<Node>,
    pub order: Vec<Item>,
}

/// Builds the hierarchy of a mesh with so many meshlets.
pub(super) fn build(items: Vec<Item>, meshlets: usize) -> Hierarchy {
    let mut out = Writer {
        nodes: Vec::new(),
        order: Vec::new(),
        placed: vec![0; meshlets],
    };
    if !items.is_empty() {
        let tree = split(items, 0);
        out.node(&tree);
    }
    Hierarchy {
        nodes: out.nodes,
        order: out.order,
    }
}

fn split(mut items: Vec<Item>, depth: usize) -> Tree {
    let count = items.len();
    let one_meshlet = items.iter().all(|i| i.meshlet == items[0].meshlet);
    let may_end = one_meshlet && count <= LEAF;
    if count == 1 {
        return Tree::Leaf(items);
    }
    let whole = bounds(&items);
    let best = if depth < EVEN_FROM {
        best_split(&mut items)
    } else {
        None
    };
    let (axis, at, cost) = best.unwrap_or_else(|| {
        let size = (whole.high - whole.low).to_array();
        let axis = (0..3).max_by_key(|axis| size[*axis]).unwrap_or(0);
        (axis, count / 2, f64::INFINITY)
    });
    let leaf_cost = count as f64 * whole.area();
    if may_end && leaf_cost <= cost + STEP * whole.area() {
        return Tree::Leaf(items);
    }
    sort(&mut items, axis);
    // What is all in one place goes by meshlets at last.
    let second = items.split_off(at.clamp(1, count - 1));
    let children = [split(items, depth + 1), split(second, depth + 1)];
    Tree::Split(whole, Box::new(children))
}

fn sort(items: &mut [Item], axis: usize) {
    items.sort_by_key(|i| (i.bounds.middle()[axis], i.meshlet, i.triangle));
}

/// Axis and place of the cheapest split, and its cost.
fn best_split(items: &mut [Item]) -> Option<(usize, usize, f64)> {
    let mut best: Option<(usize, usize, f64)> = None;
    for axis in 0..3 {
        sort(items, axis);
        let mut after = vec![0.0; items.len()];
        let mut grown = Box3::EMPTY;
        for i in (1..items.len()).rev() {
            grown = grown.with(items[i].bounds);
            after[i] = grown.area() * (items.len() - i) as f64;
        }
        let mut grown = Box3::EMPTY;
        for i in 1..items.len() {
            grown = grown.with(items[i - 1].bounds);
            let cost = grown.area() * i as f64 + after[i];
            if best.is_none_or(|(.., least)| cost < least) {
                best = Some((axis, i, cost));
            }
        }
    }
    best
}

struct Writer {
    nodes: Vec<Node>,
    order: Vec<Item>,
    /// Triangles in leaves so far, of each meshlet.
    placed: Vec<u8>,
}

impl Writer {
    /// Adds a node over a tree and all below it.
    fn node(&mut self, tree: &Tree) -> u32 {
        let children = children(tree);
        let boxes: Vec<Box3> = children.iter().map(|child| child.bounds()).collect();
        let number = self.nodes.len();
        self.nodes.push(quantised(&boxes));
        for (slot, child) in children.iter().enumerate() {
            let child = match child {
                Tree::Leaf(items) => self.leaf(items),
                Tree::Split(..) => Child::Node(self.node(child)),
            };
            self.nodes[number].children[slot] = child;
        }
        number as u32
    }

    fn leaf(&mut self, items: &[Item]) -> Child {
        let meshlet = items[0].meshlet;
        let placed = &mut self.placed[meshlet as usize];
        let first = *placed;
        *placed += items.len() as u8;
        self.order.extend(items);
        Child::Leaf(Leaf {
            meshlet,
            first,
            count: items.len() as u8,
        })
    }
}

/// What a node of four has: the largest boxes are opened.
fn children(tree: &Tree) -> Vec<&Tree> {
    let mut open = vec![tree];
    while open.len() < 4 {
        let inner = open.iter().enumerate().filter_map(|(i, tree)| match tree {
            Tree::Split(bounds, children) => Some((i, bounds.area(), children)),
            Tree::Leaf(_) => None,
        });
        let largest = inner.max_by(|a, b| a.1.total_cmp(&b.1).then(b.0.cmp(&a.0)));
        let Some((i, _, children)) = largest else {
            break;
        };
        open.splice(i..=i, children.iter());
    }
    open
}

/// A node around boxes, without children: as tight as bytes allow.
fn quantised(boxes: &[Box3]) -> Node {
    let whole = boxes.iter().copied().fold(Box3::EMPTY, Box3::with);
    let size = (whole.high - whole.low).max_element();
    let exponent = (0..15).find(|e| size <= 255 << e).unwrap_or(15);
    let unit = (1 << exponent) - 1;
    let mut node = Node {
        origin: whole.low.to_array(),
        exponent,
        sides: [[[255; 4], [0; 4]]; 3],
        children: [Child::None; 4],
    };
    for (slot, bounds) in boxes.iter().enumerate() {
        for axis in 0..3 {
            let [low, high] = [bounds.low, bounds.high].map(|c| c[axis] - whole.low[axis]);
            node.sides[axis][0][slot] = (low >> exponent) as u8;
            node.sides[axis][1][slot] = ((high + unit) >> exponent) as u8;
        }
    }
    node
}

/// The most boxes that a ray leaves behind in a hierarchy.
pub(super) fn stack(nodes: &[Node]) -> usize {
    let mut behind = vec![0; nodes.len()];
    let mut most = 0;
    for (number, node) in nodes.iter().enumerate() {
        let children = node.children.iter().filter(|c| **c != Child::None);
        let here = behind[number] + children.clone().count();
        most = most.max(here);
        for child in children {
            if let Child::Node(child) = child {
                behind[*child as usize] = here;
            }
        }
    }
    most
}

/// Whether a ray can keep what it leaves behind.
pub(super) fn fits(nodes: &[Node]) -> bool {
    stack(nodes) <= RAY_STACK
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A strip of thin triangles, each twice as far as the one before: the most
    /// uneven tree.
    #[test]
    fn an_uneven_tree_stays_within_a_rays_memory() {
        let item = |i: u32| {
            let at = IVec3::new(1 << (i % 21), (i / 21) as i32, 0);
            Item {
                meshlet: i / 100,
                triangle: (i % 100) as u8,
                bounds: Box3::of([at, at + IVec3::new(1, 1, 1)]),
            }
        };
        let items: Vec<Item> = (0..4000).map(item).collect();
        let built = build(items, 40);
        assert!(fits(&built.nodes), "{}", stack(&built.nodes));
        assert_eq!(built.order.len(), 4000);
    }

    #[test]
    fn boxes_hold_what_they_are_around() {
        let corner = |i: i32| IVec3::new(i * 7919 % 1_000_003, i * 104_729 % 999_983, -i);
        let item = |i: i32| Item {
            meshlet: 0,
            triangle: i as u8,
            bounds: Box3::of([corner(i), corner(i + 1)]),
        };
        let built = build((0..100).map(item).collect(), 1);
        for node in &built.nodes {
            for (slot, child) in node.children.iter().enumerate() {
                let Child::Leaf(leaf) = child else { continue };
                let own = &built.order[usize::from(leaf.first)..][..usize::from(leaf.count)];
                for axis in 0..3 {
                    let side = |which: usize| {
                        let steps = i32::from(node.sides[axis][which][slot]);
                        node.origin[axis] + (steps << node.exponent)
                    };
                    let b = bounds(own);
                    assert!(side(0) <= b.low[axis] && side(1) >= b.high[axis]);
                }
            }
        }
    }
}
