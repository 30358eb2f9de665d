//! What a description can say and the core cannot draw yet. Each capability's
//! line goes when the core has it.

use fixel_scene::Scene;

use crate::BakeError;

/// Refuses a scene that the core would draw otherwise than it says.
pub(crate) fn check(scene: &Scene) -> Result<(), BakeError> {
    match scene.materials.iter().find(|m| m.texture.is_some()) {
        Some(material) => Err(BakeError::NotYet {
            what: format!("material `{}`: texture", material.name),
        }),
        None => Ok(()),
    }
}
