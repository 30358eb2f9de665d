//! Meshes of fewer triangles. In: a [`Mesh`]. Out: [`Level`]s, each of about half the
//! triangles of the one before, and how far each is off the mesh. Used for levels of
//! detail, and by [`reduce`] for a budget of triangles.

mod collapse;
mod distance;
mod quadric;
mod reduce;
mod surface;

use fixel_scene::Mesh;

use collapse::Collapser;
pub(crate) use distance::Surroundings;
pub use reduce::{Reduced, reduce};
use surface::Surface;

#[cfg(test)]
mod tests;

/// No level has fewer triangles than about this.
const FEWEST: usize = 64;
/// Nor is one farther off the mesh than this part of its longest side.
const FARTHEST: f64 = 0.1;

/// How much farther off a place may be that is not looked at.
const BETWEEN: f64 = 1.08;

/// A mesh of fewer triangles.
pub(crate) struct Level {
    pub mesh: Mesh,
    /// How far the two surfaces are apart, at most, in the mesh's units.
    pub error: f64,
}

/// A mesh's levels, each of about half the triangles of the one before, from half on; none
/// for a small mesh, or one that cannot be simplified. `normals`: whether they show.
pub(crate) fn levels(mesh: &Mesh, normals: bool) -> Vec<Level> {
    let surface = Surface::new(mesh, normals);
    let farthest = surface.length(1.0) * FARTHEST;
    let mut before = surface.living;
    let mut collapser = Collapser::new(surface);
    let original = Surroundings::new(mesh);
    let mut levels: Vec<Level> = Vec::new();
    let mut error: f64 = 0.0;
    while before / 2 >= FEWEST {
        collapser.down_to(before / 2);
        let triangles = collapser.surface.living;
        // Less than a quarter gained is not worth its flash.
        if triangles * 4 > before * 3 {
            break;
        }
        let simpler = collapser.surface.mesh(mesh);
        // Never below that of a finer level, so that levels are taken in turn.
        error = error.max(apart(mesh, &original, &simpler));
        if error > farthest {
            break;
        }
        levels.push(Level {
            mesh: simpler,
            error,
        });
        before = triangles;
    }
    levels
}

/// How far two surfaces are apart, at most, either way.
fn apart(mesh: &Mesh, original: &Surroundings, simpler: &Mesh) -> f64 {
    let places = mesh.triangles.len() * 4;
    let there = original.farthest(simpler, places);
    let back = Surroundings::new(simpler).farthest(mesh, places);
    there.max(back) * BETWEEN
}
