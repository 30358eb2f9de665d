//! A mesh's hierarchy of boxes.

use crate::scene::layout::RAY_STACK;
use crate::scene::{Child, Leaf, Mesh, Meshlet, Node, Record, Scene};

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

/// What is left for later on a way in no order: the last comes first.
pub(super) struct Later<'s> {
    left: &'s mut Stack,
    count: usize,
}

impl Later<'_> {
    #[inline(always)]
    pub(super) fn leave(&mut self, word: u32) {
        // The parser made sure that there is room.
        if let Some(slot) = self.left.get_mut(self.count) {
            slot.word = word;
            self.count += 1;
        }
    }

    #[inline(always)]
    fn take(&mut self) -> Option<u32> {
        let last = self.count.checked_sub(1)?;
        let word = self.left.get(last)?.word;
        self.count = last;
        Some(word)
    }
}

/// Goes down from the first node: `node` leaves those of its children that are wanted, `leaf`
/// says whether to go on; `false` if it ended there.
#[inline(always)]
pub(super) fn depth_first(
    left: &mut Stack,
    mut node: impl FnMut(u32, &mut Later<'_>),
    mut leaf: impl FnMut(Leaf) -> bool,
) -> bool {
    let mut later = Later { left, count: 0 };
    let mut word = 0;
    loop {
        if word >> 31 == 0 {
            node(word, &mut later);
        } else if let Child::Leaf(found) = Child::from_word(word.to_le())
            && !leaf(found)
        {
            return false;
        }
        match later.take() {
            Some(next) => word = next,
            None => return true,
        }
    }
}
