//! Actors whose mesh file has several surfaces: one actor a surface.

use crate::description::{Actor, Material, Mesh};
use crate::mesh;

/// What a file's surface is called as a material.
pub(crate) fn material_name(file: &str, number: usize) -> String {
    match number {
        0 => file.to_owned(),
        _ => format!("{file}, surface {}", number + 1),
    }
}

/// An actor's parts but for the first, which is the actor itself: the meshes and
/// materials given, where the actor is.
pub(crate) fn further(
    whole: usize,
    actor: &Actor,
    pieces: impl Iterator<Item = [usize; 2]>,
) -> impl Iterator<Item = Actor> {
    (2..)
        .zip(pieces)
        .map(move |(number, [mesh, material])| Actor {
            name: format!("{}, surface {number}", actor.name),
            mesh,
            material,
            look: actor.look.clone(),
            parent: Some(whole),
            part: true,
            ..Actor::default()
        })
}

/// Takes texture coordinates away from meshes that no textured material is on.
pub(crate) fn forget_unused<'a>(
    meshes: &mut [Mesh],
    actors: impl Iterator<Item = &'a Actor> + Clone,
    materials: &[Material],
) {
    for (index, mesh) in meshes.iter_mut().enumerate() {
        let textured = |actor: &Actor| materials[actor.material].texture.is_some();
        if !actors.clone().any(|a| a.mesh == index && textured(a)) {
            mesh::forget_texture_coordinates(mesh);
        }
    }
}
