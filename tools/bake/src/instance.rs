//! Meshes as actors need them: what an actor does to its mesh beyond turning,
//! moving and scaling evenly is done here, so that the core deals with
//! similarities only (and a normal stays a normal).

use fixel_scene::{Actor, Cull, Light, LightKind, Mesh, Representation, Scene, Shading};
use glam::{DMat3, DVec3};

use crate::placement::Placed;

/// A mesh with an uneven scale, a shear or a reflection worked in.
#[derive(Clone, Debug)]
pub(crate) struct Instance {
    /// Index into the description's meshes.
    pub mesh: usize,
    /// Worked into the positions.
    pub linear: DMat3,
    /// Whether some actor is shaded flat.
    pub flat: bool,
    /// Whether some actor is shaded from vertex normals.
    pub smooth: bool,
    /// Whether some actor shows errors of its normals several times as large.
    pub glossy: bool,
    /// The most diffuse light that lights give some actor; 1 is full.
    pub brightness: f64,
    /// Whether some actor shows its faces, but not from behind, and no rays meet them.
    pub culled: bool,
    /// Whether some actor shows its edges.
    pub edges: bool,
    /// Whether some actor shows its vertices.
    pub points: bool,
}

impl Instance {
    /// Positions with the linear part worked in.
    pub(crate) fn positions(&self, mesh: &Mesh) -> Vec<DVec3> {
        mesh.positions
            .iter()
            .map(|p| self.linear * DVec3::from(*p))
            .collect()
    }

    /// Normals under the inverse transpose of the linear part, length 1.
    pub(crate) fn normals(&self, mesh: &Mesh) -> Vec<DVec3> {
        let inverse = self.linear.inverse().transpose();
        let turn = |n: &[f64; 3]| (inverse * DVec3::from(*n)).normalize_or_zero();
        // A reflection keeps normals outward: the inverse transpose does so.
        mesh.normals.iter().map(turn).collect()
    }

    /// The whole mesh as the instance has it.
    pub(crate) fn shaped(&self, mesh: &Mesh) -> Mesh {
        let rows = |vectors: Vec<DVec3>| vectors.iter().map(DVec3::to_array).collect();
        Mesh {
            positions: rows(self.positions(mesh)),
            normals: rows(self.normals(mesh)),
            triangles: mesh.triangles.iter().map(|t| self.corners(*t)).collect(),
            primitive: None,
            ..mesh.clone()
        }
    }

    /// Corners of a triangle, outward also after a reflection.
    pub(crate) fn corners(&self, [a, b, c]: [u32; 3]) -> [u32; 3] {
        if self.linear.determinant() < 0.0 {
            [a, c, b]
        } else {
            [a, b, c]
        }
    }
}

/// Whether an actor shows an error of its vertex normals several times as large: its
/// highlights do, with their power, and so does what rays meet by way of it.
fn is_glossy(scene: &Scene, actor: &Actor, for_rays: bool) -> bool {
    let material = &scene.materials[actor.material];
    let surface = actor.look.representation == Representation::Surface;
    let vertex_normals = !surface || material.shading != Shading::Flat;
    let bends = material.opacity < 1.0 && material.refractive_index != 1.0;
    let rays = for_rays && surface && (material.reflectivity > 0.0 || bends);
    vertex_normals && (material.specular > 0.0 || rays)
}

/// The most that a light gives, to surfaces that it does not touch.
fn brightness(light: &Light) -> f64 {
    let full = light.intensity * light.colour.into_iter().fold(0.0, f64::max);
    match light.kind {
        LightKind::Directional { .. } => full,
        LightKind::Point { attenuation, .. } | LightKind::Spot { attenuation, .. } => {
            full / attenuation[0].max(1.0)
        }
    }
}

/// The part of an actor's own map that its mesh must have worked in, and the even
/// factor that is left.
fn split_scale(linear: DMat3) -> (DMat3, f64) {
    let factor = linear.x_axis.x;
    if factor > 0.0 && linear == DMat3::from_diagonal(DVec3::splat(factor)) {
        (DMat3::IDENTITY, factor)
    } else {
        (linear, 1.0)
    }
}

/// The instances that a scene needs, those with face normals first, and for
/// each actor its instance and even factor.
pub(crate) fn instances(
    scene: &Scene,
    placed: &[Placed],
    for_rays: bool,
) -> (Vec<Instance>, Vec<(usize, f64)>) {
    let mut instances: Vec<Instance> = Vec::new();
    let mut uses = Vec::new();
    let light = scene.lights.iter().map(brightness).sum::<f64>();
    for (actor, placed) in scene.actors.iter().zip(placed) {
        let (linear, factor) = split_scale(placed.linear);
        let found = instances
            .iter()
            .position(|i| i.mesh == actor.mesh && i.linear == linear);
        let which = found.unwrap_or_else(|| {
            instances.push(Instance {
                mesh: actor.mesh,
                linear,
                flat: false,
                smooth: false,
                glossy: false,
                brightness: 0.0,
                culled: false,
                edges: false,
                points: false,
            });
            instances.len() - 1
        });
        let instance = &mut instances[which];
        match (
            actor.look.representation,
            scene.materials[actor.material].shading,
        ) {
            (Representation::Surface, Shading::Flat) => instance.flat = true,
            // Lines and points are lit at vertices.
            _ => instance.smooth = true,
        }
        let diffuse = scene.materials[actor.material].diffuse;
        instance.brightness = instance.brightness.max(diffuse * light);
        instance.glossy |= is_glossy(scene, actor, for_rays);
        match actor.look.representation {
            // Rays want triangles in an order of their own.
            Representation::Surface => {
                let culled = scene.materials[actor.material].cull == Cull::Back;
                instance.culled |= culled && !for_rays;
            }
            Representation::Wireframe | Representation::HiddenLine => instance.edges = true,
            Representation::Points => instance.points = true,
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
