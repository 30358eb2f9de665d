//! The scene's triangles in view space, placed and lit.

use crate::light::{Lights, Lit};
use crate::model::actor_matrix;
use crate::ray::{Meeting, Ray};
use crate::view::View;
use fixel_scene::{Actor, Cull, Mesh, Scene, Shading};
use glam::{DMat3, DVec3};

/// One triangle that may be seen.
#[derive(Clone, Debug)]
pub(crate) struct Face {
    /// Corners in view space, counter-clockwise seen from outside: a
    /// reflection's swap of the winding is already undone.
    pub corners: [DVec3; 3],
    /// Light at the corners; three times the same for flat shading.
    pub lit: [Lit; 3],
    /// Index of the actor in the scene.
    pub actor: usize,
    /// Index of the triangle in the actor's mesh.
    pub triangle: usize,
    /// Which sides are left out.
    pub cull: Cull,
}

impl Face {
    /// Where the ray meets this face, if it is seen there: not culled, and
    /// between the near and the far plane.
    pub fn seen(&self, ray: &Ray, view: &View) -> Option<Meeting> {
        let meeting = ray.meet(self.corners)?;
        let culled = match self.cull {
            Cull::Back => !meeting.counter_clockwise,
            Cull::Front => meeting.counter_clockwise,
            Cull::None => false,
        };
        (!culled && view.in_range(meeting.w)).then_some(meeting)
    }
}

/// All triangles of a scene, in the order of actors, then of triangles.
#[derive(Clone, Debug)]
pub(crate) struct Geometry {
    /// The faces.
    pub faces: Vec<Face>,
    /// Index in `faces` of each actor's first triangle, and one past the last.
    first: Vec<usize>,
}

impl Geometry {
    /// Places and lights everything at an animation frame.
    pub fn new(scene: &Scene, view: &View, frame: u32) -> Self {
        let lights = Lights::new(scene);
        let mut faces = Vec::new();
        let mut first = vec![0];
        for (index, actor) in scene.actors.iter().enumerate() {
            place(scene, view, &lights, (index, actor), frame, &mut faces);
            first.push(faces.len());
        }
        Self { faces, first }
    }

    /// One face by its actor and its triangle's index in the mesh.
    pub fn face(&self, actor: usize, triangle: usize) -> Option<&Face> {
        let range = *self.first.get(actor)?..*self.first.get(actor + 1)?;
        self.faces.get(range)?.get(triangle)
    }
}

/// Appends one actor's faces.
fn place(
    scene: &Scene,
    view: &View,
    lights: &Lights,
    (index, actor): (usize, &Actor),
    frame: u32,
    faces: &mut Vec<Face>,
) {
    let mesh: &Mesh = &scene.meshes[actor.mesh];
    let material = &scene.materials[actor.material];
    let matrix = actor_matrix(actor, &scene.animation, frame);
    let mirrored = matrix.determinant() < 0.0;
    let to_world = |p: &[f64; 3]| matrix.transform_point3(DVec3::from(*p));
    let world: Vec<DVec3> = mesh.positions.iter().map(to_world).collect();
    let seen: Vec<DVec3> = world.iter().map(|p| view.to_view(*p)).collect();
    let at_vertices: Vec<Lit> = match material.shading {
        Shading::Flat => Vec::new(),
        Shading::Gouraud => {
            let normals = DMat3::from_mat4(matrix).inverse().transpose();
            let shine = |n: &[f64; 3]| {
                lights.shine(material, (normals * DVec3::from(*n)).normalize_or_zero())
            };
            mesh.normals.iter().map(shine).collect()
        }
    };
    for (triangle, corners) in mesh.triangles.iter().enumerate() {
        let [a, mut b, mut c] = corners.map(|i| i as usize);
        if mirrored {
            std::mem::swap(&mut b, &mut c);
        }
        let lit = match material.shading {
            Shading::Flat => {
                let normal = (world[b] - world[a]).cross(world[c] - world[a]);
                [lights.shine(material, normal.normalize_or_zero()); 3]
            }
            Shading::Gouraud => [a, b, c].map(|i| at_vertices[i]),
        };
        let corners = [a, b, c].map(|i| seen[i]);
        faces.push(Face {
            corners,
            lit,
            actor: index,
            triangle,
            cull: material.cull,
        });
    }
}
