//! What a description can say and the core cannot draw yet. Each capability's
//! line goes when the core has it.

use fixel_scene::{Look, Scene};

use crate::BakeError;

/// Refuses a scene that the core would draw otherwise than it says.
pub(crate) fn check(scene: &Scene) -> Result<(), BakeError> {
    let other = scene
        .actors
        .iter()
        .find(|actor| actor.look != Look::default());
    if let Some(actor) = other {
        return Err(BakeError::NotYet {
            what: format!("actor `{}`: a look other than a surface", actor.name),
        });
    }
    match scene.materials.iter().find(|m| m.texture.is_some()) {
        Some(material) => Err(BakeError::NotYet {
            what: format!("material `{}`: texture", material.name),
        }),
        None => Ok(()),
    }
}
