//! A mesh's hierarchy of boxes.

use crate::scene::layout::RAY_STACK;
use crate::scene::{Mesh, Meshlet, Node, Record, Scene};

/// A mesh's hierarchy.
#[derive(Clone, Copy, Debug)]
pub(super) struct Hierarchy<'a> {
    pub scene: &'a Scene<'a>,
    pub mesh: &'a Mesh,
    pub nodes: &'a [<Node as Record>::Words],
    pub meshlets: &'a [<Meshlet as Record>::Words],
    /// The texture that triangles are cut out by, if they are.
    pub holes: Option<u8>,
}

/// What is left for later: a node's word for a child, and how far ahead its box is, where that
/// is asked for.
#[derive(Clone, Copy, Debug)]
pub(super) struct Left {
    pub word: u32,
    pub ahead: i32,
}

/// Memory for what a way leaves for later.
pub(super) type Stack = [Left; RAY_STACK];

/// Nothing is left.
pub(super) const NOTHING_LEFT: Stack = [Left { word: 0, ahead: 0 }; RAY_STACK];

impl<'a> Hierarchy<'a> {
    pub(super) fn new(
        scene: &'a Scene<'a>,
        mesh: &'a Mesh,
        first_node: u32,
        holes: Option<u8>,
    ) -> Self {
        Self {
            scene,
            mesh,
            nodes: scene.nodes_from(first_node),
            meshlets: scene.meshlets_of(mesh),
            holes,
        }
    }

    /// A node as the blob has it.
    #[inline(always)]
    pub(super) fn node_words(&self, number: u32) -> Option<&'a <Node as Record>::Words> {
        self.nodes.get(number as usize)
    }
}
