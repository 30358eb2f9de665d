//! Everything that rays can meet, in world space.

use super::shape::{Meeting, Placed, Shape};
use crate::bvh::{Bvh, Line};
use crate::light::mix;
use crate::model::actor_matrix;
use crate::texture::{Texel, Texture};
use fixel_scene::{Cull, Material, Representation, Scene};
use glam::{DAffine3, DMat3, DVec2, DVec3};

/// Distances that differ relatively by no more than this are the same surface twice;
/// the one earlier in the scene is met.
const COPLANAR: f64 = 1e-12;

/// A part of the world's size: what is nearer to a ray's begin than this is where it
/// begins.
const BEGIN: f64 = 1e-9;

/// The surfaces of a scene in one frame of its animation.
#[derive(Debug)]
pub(crate) struct World {
    surfaces: Vec<Surface>,
    /// Index in `surfaces` of each actor's first, and one past the last.
    first: Vec<usize>,
    bvh: Bvh,
    textures: Vec<Texture>,
    materials: Vec<Material>,
    begin: f64,
}

/// One of them.
#[derive(Clone, Debug)]
pub(crate) struct Surface {
    shape: Shape,
    /// Index of the actor in the scene.
    pub actor: usize,
    /// Index of the triangle in the actor's mesh; 0 of a primitive.
    pub triangle: usize,
    /// Index of the material in the scene.
    pub material: usize,
    /// Of a triangle's corners, if it is one.
    corners: Option<Box<Corners>>,
}

/// What is interpolated over a triangle.
#[derive(Clone, Debug)]
struct Corners {
    normals: [DVec3; 3],
    tints: [DVec3; 3],
    coordinates: Option<[DVec2; 3]>,
}

/// A surface met by a line.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Met<'a> {
    /// Which.
    pub surface: &'a Surface,
    /// Its number.
    pub number: usize,
    /// In units of the line's direction.
    pub t: f64,
    /// As [`Meeting::at`].
    pub at: [f64; 3],
    /// The outer side is seen.
    pub front: bool,
}

/// The surface where it is met.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Spot {
    /// Where, in the world.
    pub place: DVec3,
    /// Of the face, outward, unit length.
    pub face_normal: DVec3,
    /// Interpolated, unit length.
    pub normal: DVec3,
    /// The vertex colours' mean.
    pub tint: DVec3,
    /// The texture, and the place in it in texels.
    pub texel: Option<(DVec2, Texel)>,
}

impl World {
    /// Places everything.
    pub fn new(scene: &Scene, frame: u32) -> Self {
        let (mut surfaces, mut first) = (Vec::new(), vec![0]);
        let textures: Vec<Texture> = scene.textures.iter().map(Texture::new).collect();
        for (index, actor) in scene.actors.iter().enumerate() {
            if actor.look.representation == Representation::Surface {
                place(scene, &textures, index, frame, &mut surfaces);
            }
            first.push(surfaces.len());
        }
        let boxes: Vec<[DVec3; 2]> = surfaces.iter().map(|s| s.shape.bounds()).collect();
        let [low, high] = crate::bvh::bounds(boxes.iter().flatten().copied());
        let size = (high - low).max_element().max(0.0);
        Self {
            bvh: Bvh::new(&boxes),
            surfaces,
            first,
            textures,
            materials: scene.materials.clone(),
            begin: BEGIN * size,
        }
    }

    /// A surface's material.
    pub fn material(&self, surface: &Surface) -> &Material {
        &self.materials[surface.material]
    }

    /// The nearest surface that is seen along a line, at a t in a range; `from`: the
    /// number of the surface on which the line begins.
    pub fn nearest(
        &self,
        line: &Line,
        [near, far]: [f64; 2],
        from: Option<usize>,
    ) -> Option<Met<'_>> {
        let near = self.after_begin(line, near, from);
        let mut best: Option<Met<'_>> = None;
        self.bvh.walk(line, near, far, |number| {
            for met in self.meet(line, number, from) {
                let seen = (near..=far).contains(&met.t) && self.is_seen(&met);
                if seen && best.is_none_or(|old| in_front(&met, &old)) && !self.is_hole(&met) {
                    best = Some(met);
                }
            }
            // A little farther, so that the earlier of two at one place is found.
            best.map_or(far, |met| far.min(met.t + 2.0 * COPLANAR * met.t.abs()))
        });
        best
    }

    /// Calls `visit` with each surface on a line between two t, whichever side it
    /// shows, until that says no.
    pub fn between(
        &self,
        line: &Line,
        [near, far]: [f64; 2],
        from: Option<usize>,
        mut visit: impl FnMut(&Met<'_>) -> bool,
    ) {
        let near = self.after_begin(line, near, from);
        let mut limit = far;
        self.bvh.walk(line, near, far, |number| {
            for met in self.meet(line, number, from) {
                let there = (near..=limit).contains(&met.t) && !self.is_hole(&met);
                if there && !visit(&met) {
                    limit = f64::NEG_INFINITY;
                }
            }
            limit
        });
    }

    /// Where a line first shows a surface of an actor, whatever is before it.
    pub fn meet_one(&self, actor: usize, triangle: usize, line: &Line) -> Option<f64> {
        let range = *self.first.get(actor)?..*self.first.get(actor + 1)?;
        let triangle = if self.is_primitive(actor) {
            0
        } else {
            triangle
        };
        let number = Some(range.start + triangle).filter(|number| range.contains(number))?;
        let mut met = self.meet(line, number, None);
        met.find(|met| met.t > 0.0 && self.is_seen(met))
            .map(|met| met.t)
    }

    /// Whether an actor is a sphere or a rectangle, met as a whole.
    pub fn is_primitive(&self, actor: usize) -> bool {
        let first = self
            .first
            .get(actor)
            .and_then(|first| self.surfaces.get(*first));
        let own = first.filter(|surface| surface.actor == actor);
        own.is_some_and(|surface| matches!(surface.shape, Shape::Primitive(_)))
    }

    /// All there is to know about a surface where it is met.
    pub fn spot(&self, line: &Line, met: &Met<'_>) -> Spot {
        let Surface { shape, corners, .. } = met.surface;
        let face_normal = shape.normal(met.at);
        let (normal, tint) = match corners {
            None => (face_normal, DVec3::ONE),
            Some(corners) => {
                let normal = mix(corners.normals, met.at).try_normalize();
                (normal.unwrap_or(face_normal), mix(corners.tints, met.at))
            }
        };
        Spot {
            place: line.at(met.t),
            face_normal,
            normal,
            tint,
            texel: self.texel(met),
        }
    }

    fn texel(&self, met: &Met<'_>) -> Option<(DVec2, Texel)> {
        let how = self.material(met.surface).texture?;
        let texture = &self.textures[how.texture];
        let place = match &met.surface.corners {
            None => texture.place(met.surface.shape.coordinates(met.at)?),
            Some(corners) => mix(corners.coordinates?, met.at),
        };
        // A step of one texel: the picture itself, none of its smaller copies.
        let texel = texture.texel(place, [DVec2::X, DVec2::Y], &how);
        Some((place, texel))
    }

    fn is_hole(&self, met: &Met<'_>) -> bool {
        let how = self.material(met.surface).texture;
        how.is_some_and(|how| how.alpha_test > 0.0)
            && self.texel(met).is_some_and(|(_, texel)| !texel.passes)
    }

    /// Whether the side that it shows is one that its material has.
    fn is_seen(&self, met: &Met<'_>) -> bool {
        let material = self.material(met.surface);
        match material.cull {
            _ if material.opacity < 1.0 => true,
            Cull::Back => met.front,
            Cull::Front => !met.front,
            Cull::None => true,
        }
    }

    fn meet(
        &self,
        line: &Line,
        number: usize,
        from: Option<usize>,
    ) -> impl Iterator<Item = Met<'_>> {
        let surface = &self.surfaces[number];
        let found = surface.shape.meet(line, from == Some(number));
        let direction = line.direction;
        found
            .into_iter()
            .flatten()
            .map(move |Meeting { t, at }| Met {
                surface,
                number,
                t,
                at,
                front: surface.shape.normal(at).dot(direction) < 0.0,
            })
    }

    /// The least t of what is not where the line begins.
    fn after_begin(&self, line: &Line, near: f64, from: Option<usize>) -> f64 {
        match from {
            Some(_) => near.max(self.begin / line.direction.length()),
            None => near,
        }
    }
}

fn in_front(a: &Met<'_>, b: &Met<'_>) -> bool {
    if (a.t - b.t).abs() <= COPLANAR * b.t.abs() {
        a.number < b.number
    } else {
        a.t < b.t
    }
}

/// Appends an actor's surfaces.
fn place(
    scene: &Scene,
    textures: &[Texture],
    index: usize,
    frame: u32,
    surfaces: &mut Vec<Surface>,
) {
    let actor = &scene.actors[index];
    let mesh = &scene.meshes[actor.mesh];
    let matrix = actor_matrix(scene, index, frame);
    let to_world = DAffine3::from_mat4(matrix);
    let surface = |shape, triangle, corners| Surface {
        shape,
        actor: index,
        triangle,
        material: actor.material,
        corners,
    };
    if let Some(primitive) = mesh.primitive {
        let placed = Box::new(Placed::new(primitive, to_world));
        surfaces.push(surface(Shape::Primitive(placed), 0, None));
        return;
    }
    let places: Vec<DVec3> = mesh
        .positions
        .iter()
        .map(|p| to_world.transform_point3((*p).into()))
        .collect();
    let inverse_transpose = DMat3::from_mat4(matrix).inverse().transpose();
    let normals: Vec<DVec3> = mesh
        .normals
        .iter()
        .map(|n| (inverse_transpose * DVec3::from(*n)).normalize_or_zero())
        .collect();
    let tint = |i: usize| mesh.colours.get(i).map_or(DVec3::ONE, |c| (*c).into());
    let texture = scene.materials[actor.material].texture;
    let texture = texture.filter(|_| !mesh.texture_coordinates.is_empty());
    let mirrored = matrix.determinant() < 0.0;
    for (triangle, corners) in mesh.triangles.iter().enumerate() {
        let [a, mut b, mut c] = corners.map(|i| i as usize);
        if mirrored {
            std::mem::swap(&mut b, &mut c);
        }
        let corners = [a, b, c];
        let place = |i: usize| {
            let how = texture?;
            Some(textures[how.texture].place(mesh.texture_coordinates[i]))
        };
        let coordinates = corners.map(place);
        let shown = Corners {
            normals: corners.map(|i| normals[i]),
            tints: corners.map(tint),
            coordinates: match coordinates {
                [Some(a), Some(b), Some(c)] => Some([a, b, c]),
                _ => None,
            },
        };
        let shape = Shape::Triangle(corners.map(|i| places[i]));
        surfaces.push(surface(shape, triangle, Some(Box::new(shown))));
    }
}
