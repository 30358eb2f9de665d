//! Checks of what the ray caster reads.

use super::layout::{self, RAY_STACK};
use super::range::{count, last, range};
use super::{
    Child, Field, LightArea, Mesh, Meshlet, Node, Optics, RaySettings, Record, Scene, SceneError,
    Section, Shape,
};

impl Scene<'_> {
    pub(super) fn check_rays(&self) -> Result<(), SceneError> {
        if !cfg!(feature = "ray") {
            return Ok(());
        }
        let s = Section::RaySettings;
        count(s, self.ray_settings.len(), 0, 1)?;
        for (i, words) in self.ray_settings.iter().enumerate() {
            let settings = RaySettings::from_words(words);
            range(s, i, Field::Depth, settings.depth.into(), 1, 8)?;
            range(s, i, Field::Samples, settings.samples.into(), 1, 16)?;
            let samples = settings.light_samples.into();
            range(s, i, Field::Samples, samples, 1, 16)?;
            for c in settings.up {
                range(s, i, Field::Direction, c.into(), -(1 << 30), 1 << 30)?;
            }
        }
        for (section, found, owners) in [
            (Section::Shapes, self.shapes.len(), self.meshes.len()),
            (Section::Optics, self.optics.len(), self.materials.len()),
            (
                Section::LightAreas,
                self.light_areas.len(),
                self.lights.len(),
            ),
        ] {
            if found != 0 {
                count(section, found, owners, owners)?;
            }
        }
        let s = Section::Optics;
        for (i, words) in self.optics.iter().enumerate() {
            let optics = Optics::from_words(words);
            range(s, i, Field::Part, optics.reflectivity.into(), 0, 1 << 16)?;
            range(s, i, Field::Part, optics.opacity.into(), 0, 1 << 16)?;
            range(s, i, Field::Index, optics.index.into(), 1 << 16, 4 << 16)?;
        }
        let s = Section::LightAreas;
        for (i, words) in self.light_areas.iter().enumerate() {
            for c in LightArea::from_words(words).edges.as_flattened() {
                range(s, i, Field::Size, (*c).into(), -(1 << 30), 1 << 30)?;
            }
        }
        for (i, words) in self.shapes.iter().enumerate() {
            self.check_shape(i, &Shape::from_words(words))?;
        }
        Ok(())
    }

    fn check_shape(&self, i: usize, shape: &Shape) -> Result<(), SceneError> {
        let s = Section::Shapes;
        let half = i64::from(layout::GRID_HALF);
        let place = |centre: [i32; 3]| {
            let mut all = centre.into_iter();
            all.try_for_each(|c| range(s, i, Field::Base, c.into(), half.wrapping_neg(), half))
        };
        match *shape {
            Shape::Triangles { first_node, nodes } => {
                let (first, nodes) = (i64::from(first_node), i64::from(nodes));
                let last = last(self.nodes.len(), nodes);
                range(s, i, Field::FirstNode, first, 0, last)?;
                let mesh = self.mesh(i as u16);
                if nodes != 0 {
                    self.check_nodes(first as usize, nodes as usize, &mesh)?;
                }
                Ok(())
            }
            Shape::Ball { centre, radius } => {
                place(centre)?;
                range(s, i, Field::Radius, radius.into(), 1, half << 9)
            }
            Shape::Rectangle {
                centre, half: own, ..
            } => {
                place(centre)?;
                let mut sides = own.into_iter();
                sides.try_for_each(|side| range(s, i, Field::Size, side.into(), 1, half << 9))
            }
            Shape::Ellipsoid {
                centre,
                rows,
                exponent,
            } => {
                place(centre)?;
                range(s, i, Field::Scale, exponent.into(), 30, 60)?;
                let mut entries = rows.as_flattened().iter();
                entries
                    .try_for_each(|c| range(s, i, Field::Scale, (*c).into(), -(1 << 30), 1 << 30))
            }
        }
    }

    /// The nodes are a tree in the order in which it is gone through, and no way
    /// through it leaves more behind than a ray can keep.
    fn check_nodes(&self, first: usize, nodes: usize, mesh: &Mesh) -> Result<(), SceneError> {
        let s = Section::Nodes;
        // Nodes that are still to come: number, and what is left behind up to there.
        let mut open = [(0u32, 0i64); RAY_STACK];
        let mut count = 1usize;
        let all = self.nodes.iter().enumerate().skip(first).take(nodes);
        for (number, (i, words)) in all.enumerate() {
            let node = Node::from_words(words);
            count = count.wrapping_sub(1);
            let next = open.get(count).copied();
            let (expected, behind) = next.unwrap_or((u32::MAX, 0));
            range(
                s,
                i,
                Field::Count,
                expected.into(),
                number as i64,
                number as i64,
            )?;
            range(s, i, Field::Scale, node.exponent.into(), 0, 15)?;
            let half = i64::from(layout::GRID_HALF) << 1;
            for c in node.origin {
                range(s, i, Field::Base, c.into(), half.wrapping_neg(), half)?;
            }
            let is_some = |child: &&Child| **child != Child::None;
            let children = node.children.iter().take_while(is_some).count() as i64;
            range(s, i, Field::Count, children, 1, 4)?;
            let behind = behind.saturating_add(children);
            range(s, i, Field::Depth, behind, 0, RAY_STACK as i64)?;
            for child in node.children.iter().rev() {
                match child {
                    Child::None => {}
                    Child::Node(child) => {
                        // Below the limit: what is open is left behind.
                        if let Some(slot) = open.get_mut(count) {
                            *slot = (*child, behind);
                        }
                        count = count.saturating_add(1);
                    }
                    Child::Leaf(leaf) => {
                        let last = last(mesh.meshlets as usize, 1);
                        range(s, i, Field::Meshlet, leaf.meshlet.into(), 0, last)?;
                        let meshlet = mesh.first_meshlet.saturating_add(leaf.meshlet);
                        let words = self.meshlets.get(meshlet as usize);
                        let triangles = words.map_or(0, |w| Meshlet::from_words(w).triangles);
                        let end = i64::from(leaf.first).saturating_add(leaf.count.into());
                        range(s, i, Field::Count, end, 1, triangles.into())?;
                    }
                }
            }
            range(s, i, Field::Depth, count as i64, 0, RAY_STACK as i64)?;
        }
        range(s, first, Field::Count, count as i64, 0, 0)
    }
}
