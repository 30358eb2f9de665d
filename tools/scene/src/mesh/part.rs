//! Some of a mesh's triangles as a mesh of their own.

use std::collections::HashMap;

use super::{Loaded, polygon};
use crate::description::Mesh;

impl Loaded {
    /// One mesh a surface; the whole if there are not several.
    pub(crate) fn parts(&self) -> Vec<Mesh> {
        match self.surfaces.len() {
            0 | 1 => vec![self.mesh.clone()],
            several => (0..several).map(|surface| self.part(surface)).collect(),
        }
    }

    /// The triangles of one surface, with their own vertices and edges. An edge between
    /// two surfaces belongs to the first that has it.
    pub(crate) fn part(&self, surface: usize) -> Mesh {
        let whole = &self.mesh;
        let owners = || whole.triangles.iter().zip(&self.surface_of);
        let mut part = Mesh {
            name: whole.name.clone(),
            ..Mesh::default()
        };
        let mut new_of_old = HashMap::new();
        let mut vertex = |part: &mut Mesh, old: u32| {
            *new_of_old.entry(old).or_insert_with(|| {
                let at = old as usize;
                part.positions.push(whole.positions[at]);
                part.normals.push(whole.normals[at]);
                part.colours.extend(whole.colours.get(at));
                part.texture_coordinates
                    .extend(whole.texture_coordinates.get(at));
                part.positions.len() as u32 - 1
            })
        };
        for (triangle, _) in owners().filter(|(_, owner)| **owner as usize == surface) {
            let corners = triangle.map(|old| vertex(&mut part, old));
            part.triangles.push(corners);
        }
        let mut owner_of: HashMap<[u32; 2], u32> = HashMap::new();
        for (triangle, owner) in owners() {
            for side in polygon::sides(*triangle) {
                owner_of.entry(side).or_insert(*owner);
            }
        }
        for edge in &whole.edges {
            if owner_of.get(edge).is_some_and(|o| *o as usize == surface) {
                let edge = edge.map(|old| vertex(&mut part, old));
                part.edges.push(edge);
            }
        }
        // White changes nothing.
        if part.colours.iter().all(|colour| *colour == [1.0; 3]) {
            part.colours.clear();
        }
        part
    }
}
