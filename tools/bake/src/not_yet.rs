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
    match other {
        Some(actor) => Err(BakeError::NotYet {
            what: format!("actor `{}`: a look other than a surface", actor.name),
        }),
        None => Ok(()),
    }
}
