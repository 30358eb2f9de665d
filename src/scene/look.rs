//! What of an actor is drawn, if it is not its surface; a mesh's edges; marks.

use super::range::{count, last, range};
use super::records::{i, u};
use super::{Field, Meshlet, Record, Scene, SceneError, Section, layout};

/// What of an actor is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Representation {
    /// Its mesh's edges.
    Wireframe,
    /// Its mesh's edges, hidden by its triangles, which show the background.
    HiddenLine,
    /// Its vertices, each as a mark.
    Points,
}

impl Representation {
    /// All, in the order of their codes.
    pub const ALL: [Self; 3] = [Self::Wireframe, Self::HiddenLine, Self::Points];
}

/// How an actor that is not drawn as a surface is drawn. Its material is lit at
/// vertices and seen from both sides.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Look {
    /// The actor. Looks are in the order of actors.
    pub actor: u16,
    /// What of it is drawn.
    pub representation: Representation,
    /// Whether what is nearer hides it; if not, it is drawn over everything.
    pub depth_test: bool,
    /// Whether its grid is on the screen: one world unit is a pixel from the top
    /// left corner, x to the right and y down.
    pub on_screen: bool,
    /// Width of lines in pixels, 1..=16.
    pub line_width: u8,
    /// Added to depths, in their units.
    pub bias: u16,
    /// Columns and rows of the mark.
    pub mark_size: [u16; 2],
    /// From the point to the mark's first column and row, in half pixels.
    pub mark_offset: [i16; 2],
    /// The first byte of its rows in the scene's list.
    pub first_mark: u32,
}

impl Record for Look {
    type Words = [u32; 5];

    fn from_words(&[head, style, size, offset, first]: &Self::Words) -> Self {
        let (head, style, size, offset) = (u(head), u(style), u(size), i(offset));
        let flags = head >> 16;
        let code = (flags & 3) as usize;
        Self {
            actor: head as u16,
            representation: Representation::ALL
                .get(code)
                .copied()
                .unwrap_or(Representation::Points),
            depth_test: flags & 4 != 0,
            on_screen: flags & 8 != 0,
            line_width: (style >> 16) as u8,
            bias: style as u16,
            mark_size: [size as u16, (size >> 16) as u16],
            mark_offset: [offset as i16, (offset >> 16) as i16],
            first_mark: u(first),
        }
    }

    fn to_words(&self) -> Self::Words {
        let flags = self.representation as u32
            | u32::from(self.depth_test) << 2
            | u32::from(self.on_screen) << 3;
        let pair = |[low, high]: [u16; 2]| u32::from(low) | u32::from(high) << 16;
        [
            u32::from(self.actor) | flags << 16,
            u32::from(self.bias) | u32::from(self.line_width) << 16,
            pair(self.mark_size),
            pair(self.mark_offset.map(|c| c as u16)),
            self.first_mark,
        ]
        .map(u32::to_le)
    }
}

impl Look {
    /// Bytes of the mark's rows.
    fn mark_bytes(&self) -> usize {
        let [width, height] = self.mark_size.map(usize::from);
        width.div_ceil(8).saturating_mul(height)
    }

    /// How far its pixels may be from its mesh's, in pixels.
    pub fn reach(&self) -> u16 {
        if self.representation != Representation::Points {
            return u16::from(self.line_width);
        }
        let [width, height] = self.mark_size;
        let [x, y] = self
            .mark_offset
            .map(|c| (c.unsigned_abs() / 2).saturating_add(1));
        width.saturating_add(x).max(height.saturating_add(y))
    }
}

impl<'a> Scene<'a> {
    /// Number of actors that are not drawn as surfaces.
    pub fn look_count(&self) -> usize {
        self.looks.len()
    }

    /// How an actor is drawn; `None`: as a surface.
    pub fn look(&self, actor: u16) -> Option<Look> {
        let of = |words: &<Look as Record>::Words| Look::from_words(words).actor;
        let at = self.looks.binary_search_by_key(&actor, of).ok()?;
        self.looks.get(at).map(Look::from_words)
    }

    /// A look's mark: rows from the top, each starting with a byte's highest bit.
    pub fn mark(&self, look: &Look) -> &'a [u8] {
        let first = look.first_mark as usize;
        let end = first.saturating_add(look.mark_bytes());
        self.marks.get(first..end).unwrap_or_default()
    }

    /// The edges of a meshlet, by its place in the scene's list: the vertices at
    /// their ends. An end with [`CHAINED`](layout::CHAINED) leaves its pixel to
    /// another edge. And the first one's place in the scene's list.
    pub fn meshlet_edges(&self, meshlet: u32) -> (&'a [[u8; 2]], u32) {
        let at = meshlet as usize;
        let place = |at: usize| self.meshlet_edges.get(at).map(|first| u(*first));
        let (Some(first), Some(end)) = (place(at), place(at.saturating_add(1))) else {
            return (&[], 0);
        };
        let edges = self.edges.get(first as usize..end as usize);
        (edges.unwrap_or_default(), first)
    }

    /// Number of edges of all meshes.
    pub fn edge_count(&self) -> usize {
        self.edges.len()
    }

    pub(super) fn check_looks(&self) -> Result<(), SceneError> {
        let s = Section::Looks;
        let actors = self.actors.len();
        let mut least = 0;
        for (at, words) in self.looks.iter().enumerate() {
            let look = Look::from_words(words);
            let actor = i64::from(look.actor);
            range(s, at, Field::Actor, actor, least, last(actors, 1))?;
            least = actor.saturating_add(1);
            let code = words.first().map_or(0, |head| u(*head) >> 16 & 3);
            let known = last(Representation::ALL.len(), 1);
            range(s, at, Field::Representation, code.into(), 0, known)?;
            range(s, at, Field::Width, look.line_width.into(), 1, 16)?;
            range(s, at, Field::Bias, look.bias.into(), 0, 1000)?;
            for c in look.mark_size {
                range(s, at, Field::Mark, c.into(), 0, layout::MARK)?;
            }
            for c in look.mark_offset {
                range(
                    s,
                    at,
                    Field::Mark,
                    c.into(),
                    -2 * layout::MARK,
                    layout::MARK,
                )?;
            }
            let bytes = look.mark_bytes() as i64;
            let last = last(self.marks.len(), bytes);
            range(s, at, Field::Mark, look.first_mark.into(), 0, last)?;
        }
        let (meshlets, places) = (self.meshlets.len(), self.meshlet_edges.len());
        if places != 0 {
            let all = meshlets.saturating_add(1);
            count(Section::MeshletEdges, places, all, all)?;
        }
        let mut least = 0;
        for (at, first) in self.meshlet_edges.iter().enumerate() {
            let (s, first) = (Section::MeshletEdges, i64::from(u(*first)));
            range(s, at, Field::Offset, first, least, self.edges.len() as i64)?;
            least = first;
        }
        Ok(())
    }

    /// The edges of a meshlet, by its place in the scene's list.
    pub(super) fn check_edges(&self, at: usize, meshlet: &Meshlet) -> Result<(), SceneError> {
        let (edges, first) = self.meshlet_edges(at as u32);
        let most = i64::from(meshlet.vertices).wrapping_sub(1);
        for (edge, [from, to]) in (first as usize..).zip(edges) {
            for end in [*from, *to & !layout::CHAINED] {
                let s = Section::Edges;
                range(s, edge, Field::VertexIndex, end.into(), 0, most)?;
            }
        }
        Ok(())
    }
}
