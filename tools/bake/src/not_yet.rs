//! What a description can say and the core cannot draw yet. Each capability's
//! line goes when the core has it.

use fixel_scene::{Light, LightKind, Look, Material, Scene, Shading};

use crate::BakeError;

/// Refuses a scene that the core would draw otherwise than it says.
pub(crate) fn check(scene: &Scene) -> Result<(), BakeError> {
    let lights = scene
        .lights
        .iter()
        .enumerate()
        .filter_map(|(i, light)| Some(format!("light {}: {}", i + 1, of_light(light)?)));
    let materials = scene.materials.iter().filter_map(|material| {
        let what = of_material(material)?;
        Some(format!("material `{}`: {what}", material.name))
    });
    let actors = scene.actors.iter().filter_map(|actor| {
        if actor.look != Look::default() {
            return Some(format!(
                "actor `{}`: a look other than a surface",
                actor.name
            ));
        }
        let coloured = !scene.meshes[actor.mesh].colours.is_empty();
        coloured.then(|| format!("actor `{}`: a mesh with vertex colours", actor.name))
    });
    match lights.chain(materials).chain(actors).next() {
        Some(what) => Err(BakeError::NotYet { what }),
        None => Ok(()),
    }
}

fn of_light(light: &Light) -> Option<&'static str> {
    let [red, green, blue] = light.colour;
    match light.kind {
        LightKind::Point { .. } => Some("kind = \"point\""),
        LightKind::Spot { .. } => Some("kind = \"spot\""),
        LightKind::Directional { .. } if red != green || green != blue => {
            Some("colour other than a grey")
        }
        LightKind::Directional { .. } => None,
    }
}

fn of_material(material: &Material) -> Option<&'static str> {
    if material.shading == Shading::Phong {
        Some("shading = \"phong\"")
    } else if material.specular > 0.0 {
        Some("specular above 0")
    } else {
        None
    }
}

#[cfg(test)]
mod tests {
    use fixel_scene::Mesh;

    use super::*;

    /// One actor with nothing out of the ordinary.
    fn plain() -> Scene {
        let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../scenes/cube.toml");
        fixel_scene::load(path.as_ref()).unwrap()
    }

    fn refused(change: impl Fn(&mut Scene)) -> String {
        let mut scene = plain();
        assert_eq!(check(&scene), Ok(()));
        change(&mut scene);
        check(&scene).unwrap_err().to_string()
    }

    #[test]
    fn what_cannot_be_drawn_is_named() {
        let light = |scene: &mut Scene, kind| scene.lights[0].kind = kind;
        let (position, attenuation) = ([0.0; 3], [1.0, 0.0, 0.0]);
        let point = LightKind::Point {
            position,
            attenuation,
        };
        assert_eq!(
            refused(|scene| light(scene, point)),
            "light 1: kind = \"point\" is not supported yet"
        );
        assert_eq!(
            refused(|scene| scene.lights[0].colour = [1.0, 0.5, 1.0]),
            "light 1: colour other than a grey is not supported yet"
        );
        let name = plain().materials[0].name.clone();
        assert_eq!(
            refused(|scene| scene.materials[0].shading = Shading::Phong),
            format!("material `{name}`: shading = \"phong\" is not supported yet")
        );
        assert_eq!(
            refused(|scene| scene.materials[0].specular = 0.1),
            format!("material `{name}`: specular above 0 is not supported yet")
        );
        let paint = |mesh: &mut Mesh| mesh.colours = vec![[1.0, 0.0, 0.0]; mesh.positions.len()];
        let name = plain().actors[0].name.clone();
        assert_eq!(
            refused(|scene| paint(&mut scene.meshes[0])),
            format!("actor `{name}`: a mesh with vertex colours is not supported yet")
        );
    }
}
