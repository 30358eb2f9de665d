//! A scene within a budget of triangles.

use std::collections::HashSet;

use fixel_scene::{Mesh, Representation, Scene, Shading};
use glam::DVec3;

use super::apart;
use super::collapse::Collapser;
use super::distance::Surroundings;
use super::surface::Surface;
use crate::error::{BakeError, Problem};
use crate::snap::{PlaceKey, place_key};

/// What became of a mesh.
#[derive(Clone, Debug, PartialEq)]
pub struct Reduced {
    /// Its name.
    pub mesh: String,
    /// Triangles before.
    pub before: usize,
    /// Triangles now.
    pub after: usize,
    /// How far it is off what it was, at most, in the mesh's units.
    pub error: f64,
    /// The longest side of its box, in the same.
    pub size: f64,
}

/// Simplifies a scene's meshes to at most `most` triangles in total, each mesh counted once:
/// the largest ones, down to one size, so that small ones stay as they are. Gives those
/// that have changed.
///
/// # Errors
/// If a mesh cannot be simplified as far, because it has too many pieces, borders or seams.
pub fn reduce(scene: &mut Scene, most: usize) -> Result<Vec<Reduced>, BakeError> {
    let sizes: Vec<usize> = scene.meshes.iter().map(|m| m.triangles.len()).collect();
    let each = level(&sizes, most);
    let mut all = Vec::new();
    for (number, before) in sizes.into_iter().enumerate().filter(|(_, n)| *n > each) {
        let lit = |actor: &fixel_scene::Actor| {
            actor.look.representation != Representation::Surface
                || scene.materials[actor.material].shading != Shading::Flat
        };
        let mut actors = scene.actors.iter().filter(|actor| actor.mesh == number);
        let normals = actors.any(lit);
        let mesh = &mut scene.meshes[number];
        let mut collapser = Collapser::new(Surface::new(mesh, normals));
        collapser.down_to(each);
        let mut simpler = collapser.surface.mesh(mesh);
        if simpler.triangles.len() > each {
            let problem = Problem::Simplify {
                mesh: mesh.name.clone(),
                least: simpler.triangles.len(),
                most: each,
            };
            return Err(problem.into());
        }
        if !mesh.edges.is_empty() {
            simpler.edges = edges(&simpler);
        }
        all.push(Reduced {
            mesh: mesh.name.clone(),
            before,
            after: simpler.triangles.len(),
            error: apart(mesh, &Surroundings::new(mesh), &simpler),
            size: collapser.surface.length(1.0),
        });
        *mesh = simpler;
    }
    Ok(all)
}

/// The most that each may have so that all of them together have at most `most`.
fn level(sizes: &[usize], most: usize) -> usize {
    let mut sizes = sizes.to_vec();
    sizes.sort_unstable();
    let mut left = most;
    for (number, size) in sizes.iter().enumerate() {
        let share = left / (sizes.len() - number);
        if *size > share {
            return share;
        }
        left -= size;
    }
    usize::MAX
}

/// The sides of all triangles, each once.
fn edges(mesh: &Mesh) -> Vec<[u32; 2]> {
    let at = |v: u32| place_key(&DVec3::from(mesh.positions[v as usize]));
    let mut seen: HashSet<[PlaceKey; 2]> = HashSet::new();
    let sides = mesh
        .triangles
        .iter()
        .flat_map(|[a, b, c]| [[*a, *b], [*b, *c], [*c, *a]]);
    let is_new = |side: &[u32; 2]| {
        let [from, to] = side.map(at);
        seen.insert(if from < to { [from, to] } else { [to, from] })
    };
    sides.filter(is_new).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_budget_is_shared_so_that_small_ones_stay() {
        assert_eq!(level(&[100, 12, 5000], 1000), 888);
        assert_eq!(level(&[3000, 12, 5000], 1012), 500);
        assert_eq!(level(&[3000, 12], 4000), usize::MAX);
        assert_eq!(level(&[12, 12], 10), 5);
    }
}
