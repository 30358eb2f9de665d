//! Meshes as actors need them: what an actor does to its mesh beyond turning,
//! moving and scaling evenly is done here, so that the core deals with
//! similarities only (and a normal stays a normal).

use fixel_scene::{Actor, Mesh, Scene, Shading};
use glam::DVec3;

/// A mesh with an uneven scale or a reflection worked in.
#[derive(Clone, Debug)]
pub(crate) struct Instance {
    /// Index into the description's meshes.
    pub mesh: usize,
    /// Worked into the positions.
    pub scale: DVec3,
    /// Whether some actor is shaded flat.
    pub flat: bool,
    /// Whether some actor is shaded from vertex normals.
    pub smooth: bool,
}

impl Instance {
    /// Positions with the scale worked in.
    pub(crate) fn positions(&self, mesh: &Mesh) -> Vec<DVec3> {
        mesh.positions
            .iter()
            .map(|p| DVec3::from(*p) * self.scale)
            .collect()
    }

    /// Normals under the inverse transpose of the scale, length 1.
    pub(crate) fn normals(&self, mesh: &Mesh) -> Vec<DVec3> {
        let turn = |n: &[f64; 3]| (DVec3::from(*n) / self.scale).normalize_or_zero();
        // A reflection keeps normals outward: the inverse transpose does so.
        mesh.normals.iter().map(turn).collect()
    }

    /// Corners of a triangle, outward also after a reflection.
    pub(crate) fn corners(&self, [a, b, c]: [u32; 3]) -> [u32; 3] {
        if self.scale.x * self.scale.y * self.scale.z < 0.0 {
            [a, c, b]
        } else {
            [a, b, c]
        }
    }
}

/// The part of an actor's scale that its mesh must have worked in, and the even
/// factor that is left.
fn split_scale(actor: &Actor) -> (DVec3, f64) {
    let scale = DVec3::from(actor.scale);
    if scale.x == scale.y && scale.y == scale.z && scale.x > 0.0 {
        (DVec3::ONE, scale.x)
    } else {
        (scale, 1.0)
    }
}

/// The instances that a scene needs, those with face normals first, and for
/// each actor its instance and even factor.
pub(crate) fn instances(scene: &Scene) -> (Vec<Instance>, Vec<(usize, f64)>) {
    let mut instances: Vec<Instance> = Vec::new();
    let mut uses = Vec::new();
    for actor in &scene.actors {
        let (scale, factor) = split_scale(actor);
        let found = instances
            .iter()
            .position(|i| i.mesh == actor.mesh && i.scale == scale);
        let which = found.unwrap_or_else(|| {
            instances.push(Instance {
                mesh: actor.mesh,
                scale,
                flat: false,
                smooth: false,
            });
            instances.len() - 1
        });
        match scene.materials[actor.material].shading {
            Shading::Flat => instances[which].flat = true,
            Shading::Gouraud | Shading::Phong => instances[which].smooth = true,
        }
        uses.push((which, factor));
    }
    let mut order: Vec<usize> = (0..instances.len()).collect();
    order.sort_by_key(|i| !instances[*i].flat);
    let place = |which: usize| order.iter().position(|i| *i == which).unwrap_or(which);
    let uses = uses
        .into_iter()
        .map(|(which, factor)| (place(which), factor))
        .collect();
    (order.iter().map(|i| instances[*i].clone()).collect(), uses)
}
