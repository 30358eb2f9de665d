//! How materials let what is behind them show through, in the blob's records.

use fixel::scene as core_scene;
use fixel_scene::{Element, Material, Representation, Scene, Transparency};

use crate::error::{BakeError, Problem};

/// Thresholds of the screen-door pattern.
const THRESHOLDS: usize = 64;
/// From one screen-door material's thresholds to the next one's: a quarter of them, so
/// that of two halves a quarter is both.
const NEXT: usize = 16;

/// Refuses what the renderer cannot do with transparent materials.
pub(crate) fn possible(scene: &Scene) -> Result<(), BakeError> {
    let not_yet = |actor, what| Err(Problem::NotYet { what }.at(Element::Actor(actor)));
    let hazy = scene.fog.is_some() && scene.materials.iter().any(blended);
    let mut actors = scene.actors.iter().enumerate();
    let over = actors.find(|(_, actor)| !actor.look.depth_test);
    if let (true, Some((number, actor))) = (hazy, over) {
        return not_yet(
            number,
            format!(
                "actor `{}`: depth_test = false in fog with blended materials (expected \
             depth_test = true)",
                actor.name
            ),
        );
    }
    for (number, actor) in scene.actors.iter().enumerate() {
        let material = &scene.materials[actor.material];
        if material.opacity < 1.0 && actor.look.representation != Representation::Surface {
            return not_yet(
                number,
                format!(
                    "actor `{}`: lines or points of a material of opacity {} (expected opacity = 1)",
                    actor.name, material.opacity
                ),
            );
        }
    }
    Ok(())
}

/// Of each material.
pub(crate) fn transparencies(scene: &Scene) -> Vec<core_scene::Transparency> {
    let mut doors = 0;
    let mut of = |material: &Material| {
        if material.opacity >= 1.0 {
            return core_scene::Transparency::Opaque;
        }
        match material.transparency {
            Transparency::Blend => core_scene::Transparency::Blend {
                opacity: (material.opacity * 256.0).round() as u16,
            },
            Transparency::ScreenDoor => {
                let first = doors * NEXT % THRESHOLDS;
                doors += 1;
                core_scene::Transparency::ScreenDoor {
                    first: first as u8,
                    pixels: (material.opacity * THRESHOLDS as f64).round() as u8,
                }
            }
        }
    };
    scene.materials.iter().map(&mut of).collect()
}

/// The way back: a material's opacity, and how it shows what is behind it.
pub(crate) fn unbake(how: core_scene::Transparency) -> (f64, Transparency) {
    match how {
        core_scene::Transparency::Opaque => (1.0, Transparency::Blend),
        core_scene::Transparency::Blend { opacity } => {
            (f64::from(opacity) / 256.0, Transparency::Blend)
        }
        core_scene::Transparency::ScreenDoor { pixels, .. } => (
            f64::from(pixels) / THRESHOLDS as f64,
            Transparency::ScreenDoor,
        ),
    }
}

/// Whether a material's colours are mixed with what is behind it.
pub(crate) fn blended(material: &Material) -> bool {
    material.opacity < 1.0 && material.transparency == Transparency::Blend
}
