//! The scene's triangles in view space, placed and lit.

use crate::light::{Lights, Lit, SurfacePoint, mix};
use crate::model::actor_matrix;
use crate::ray::{self, Meeting, Ray};
use crate::texture::{Texel, Texture};
use crate::through::Through;
use crate::view::View;
use fixel_scene::{Actor, Cull, Material, Mesh, Representation, Scene, Shading, Texturing};
use glam::{DMat3, DVec2, DVec3};

/// How a face is lit.
#[derive(Clone, Debug)]
pub(crate) enum Shade {
    /// Light at the corners, to be interpolated; three times the same for flat
    /// shading.
    Corners(Box<[Lit; 3]>),
    /// The corners' surface, to be interpolated and lit at each pixel.
    Pixels(Box<[SurfacePoint; 3]>),
}

/// One triangle that may be seen.
#[derive(Clone, Debug)]
pub(crate) struct Face {
    /// Corners in view space, counter-clockwise seen from outside: a
    /// reflection's swap of the winding is already undone.
    pub corners: [DVec3; 3],
    /// How it is lit.
    pub shade: Shade,
    /// Index of the actor in the scene.
    pub actor: usize,
    /// Index of the triangle in the actor's mesh.
    pub triangle: usize,
    /// Which sides are left out.
    pub cull: Cull,
    /// The texture on it.
    pub texture: Option<Box<Laid>>,
    /// Of a hidden-line actor, which shows the background: how much deeper than it
    /// is it lies, in units of the 16-bit depth buffer.
    pub sunk_lsb: Option<f64>,
    /// How what is behind it shows through.
    pub through: Through,
}

/// How a texture lies on a face.
#[derive(Clone, Debug)]
pub(crate) struct Laid {
    how: Texturing,
    /// Places of the corners in the texture, in texels.
    corners: [DVec2; 3],
    /// Whether places are interpolated over the surface.
    over_surface: bool,
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

    /// Weights of the corners at a place on the screen, for the texture.
    fn weights(&self, [x, y]: [f64; 2], laid: &Laid, view: &View) -> [f64; 3] {
        if laid.over_surface {
            view.ray_through([x, y]).weights(self.corners)
        } else {
            let corners = self.corners.map(|corner| view.to_screen_px(corner));
            ray::weights(corners.map(|[cx, cy]| [cx - x, cy - y]))
        }
    }
}

/// All triangles of a scene, in the order of actors, then of triangles.
#[derive(Clone, Debug)]
pub(crate) struct Geometry {
    /// The faces.
    pub faces: Vec<Face>,
    /// What lights them.
    lights: Lights,
    textures: Vec<Texture>,
    /// Index in `faces` of each actor's first triangle, and one past the last.
    first: Vec<usize>,
}

impl Geometry {
    /// Places and lights everything at an animation frame.
    pub fn new(scene: &Scene, view: &View, frame: u32) -> Self {
        let lights = Lights::new(scene);
        let textures: Vec<Texture> = scene.textures.iter().map(Texture::new).collect();
        let through = Through::all(scene);
        let mut faces = Vec::new();
        let mut first = vec![0];
        for (index, actor) in scene.actors.iter().enumerate() {
            let look = &actor.look;
            let shown = [Representation::Surface, Representation::HiddenLine];
            if shown.contains(&look.representation) {
                let given = (view, &lights, &textures[..]);
                let own = faces.len();
                place(scene, given, (index, actor), frame, &mut faces);
                for face in &mut faces[own..] {
                    face.through = through[actor.material];
                }
            }
            first.push(faces.len());
        }
        Self {
            faces,
            lights,
            textures,
            first,
        }
    }

    /// Light on a face of `material` where its corners have the given weights.
    pub fn lit(&self, face: &Face, weights: [f64; 3], material: &Material, view: &View) -> Lit {
        match &face.shade {
            Shade::Corners(lit) => Lit::weighted(**lit, weights),
            Shade::Pixels(corners) => {
                let place = mix(corners.map(|c| c.place), weights);
                let at = SurfacePoint {
                    place,
                    normal: mix(corners.map(|c| c.normal), weights).normalize_or_zero(),
                    eye: view.towards_eye(place),
                    tint: mix(corners.map(|c| c.tint), weights),
                };
                self.lights.shine(material, &at)
            }
        }
    }

    /// The texture on a face at a pixel: the place in the picture, in texels, and what
    /// is seen there.
    pub fn texel(&self, face: &Face, pixel: [u32; 2], view: &View) -> Option<(DVec2, Texel)> {
        let laid = face.texture.as_deref()?;
        let [x, y] = View::centre_px(pixel);
        let place = |x: f64, y: f64| mix(laid.corners, face.weights([x, y], laid, view));
        // Half a step to either side of the centre.
        const STEP_PX: f64 = 1e-3;
        let half = STEP_PX / 2.0;
        let steps = [
            place(x + half, y) - place(x - half, y),
            place(x, y + half) - place(x, y - half),
        ];
        let steps = steps.map(|step| step / STEP_PX);
        let at = place(x, y);
        let texel = self.textures[laid.how.texture].texel(at, steps, &laid.how);
        Some((at, texel))
    }

    /// Whether a face is seen through at a pixel.
    pub fn is_hole(&self, face: &Face, pixel: [u32; 2], view: &View) -> bool {
        if let Through::Door(door) = &face.through
            && !door.draws(pixel)
        {
            return true;
        }
        let tested = |laid: &Laid| laid.how.alpha_test > 0.0;
        face.texture.as_deref().is_some_and(tested)
            && self
                .texel(face, pixel, view)
                .is_some_and(|(_, texel)| !texel.passes)
    }

    /// An actor's vertices, to be lit one by one.
    pub fn placing<'a>(
        &'a self,
        scene: &'a Scene,
        view: &'a View,
        actor: usize,
        frame: u32,
    ) -> Placing<'a> {
        Placing::new(
            scene,
            (view, &self.lights, &self.textures[..]),
            actor,
            frame,
        )
    }

    /// One face by its actor and its triangle's index in the mesh.
    pub fn face(&self, actor: usize, triangle: usize) -> Option<&Face> {
        let range = *self.first.get(actor)?..*self.first.get(actor + 1)?;
        self.faces.get(range)?.get(triangle)
    }
}

/// Where an actor's faces come from.
pub(crate) struct Placing<'a> {
    material: &'a Material,
    pub mesh: &'a Mesh,
    view: &'a View,
    lights: &'a Lights,
    textures: &'a [Texture],
    /// World places and unit normals of the mesh's vertices.
    pub places: Vec<DVec3>,
    normals: Vec<DVec3>,
    /// The winding is turned round.
    mirrored: bool,
}

impl<'a> Placing<'a> {
    fn new(
        scene: &'a Scene,
        (view, lights, textures): (&'a View, &'a Lights, &'a [Texture]),
        index: usize,
        frame: u32,
    ) -> Self {
        let actor = &scene.actors[index];
        let mesh: &Mesh = &scene.meshes[actor.mesh];
        let matrix = actor_matrix(scene, index, frame);
        let to_world = |p: &[f64; 3]| matrix.transform_point3(DVec3::from(*p));
        let inverse_transpose = DMat3::from_mat4(matrix).inverse().transpose();
        let normal = |n: &[f64; 3]| (inverse_transpose * DVec3::from(*n)).normalize_or_zero();
        Self {
            material: &scene.materials[actor.material],
            mesh,
            view,
            lights,
            textures,
            places: mesh.positions.iter().map(to_world).collect(),
            normals: mesh.normals.iter().map(normal).collect(),
            mirrored: matrix.determinant() < 0.0,
        }
    }

    /// Light at a vertex.
    pub fn lit_vertex(&self, index: usize) -> Lit {
        self.lights.shine(self.material, &self.vertex(index))
    }

    /// The surface at a vertex.
    fn vertex(&self, index: usize) -> SurfacePoint {
        let place = self.places[index];
        SurfacePoint {
            place,
            normal: self.normals[index],
            eye: self.view.towards_eye(place),
            tint: self
                .mesh
                .colours
                .get(index)
                .map_or(DVec3::ONE, |c| (*c).into()),
        }
    }

    /// The middle of a flat face.
    fn centre(&self, vertices: [usize; 3]) -> SurfacePoint {
        let corners = vertices.map(|i| self.vertex(i));
        let [a, b, c] = corners.map(|corner| corner.place);
        let third = [1.0 / 3.0; 3];
        let place = mix([a, b, c], third);
        SurfacePoint {
            place,
            normal: (b - a).cross(c - a).normalize_or_zero(),
            eye: self.view.towards_eye(place),
            tint: mix(corners.map(|corner| corner.tint), third),
        }
    }

    /// The texture on a face whose corners are there in view space.
    fn texture(&self, vertices: [usize; 3], corners: [DVec3; 3]) -> Option<Box<Laid>> {
        let how = self.material.texture?;
        let coordinates = &self.mesh.texture_coordinates;
        let texture = &self.textures[how.texture];
        let whole = corners.iter().all(|corner| self.view.in_range(corner.z));
        (!coordinates.is_empty()).then(|| {
            Box::new(Laid {
                how,
                corners: vertices.map(|i| texture.place(coordinates[i])),
                over_surface: how.perspective || !whole,
            })
        })
    }

    fn shade(&self, vertices: [usize; 3], at_vertices: &[Lit]) -> Shade {
        match self.material.shading {
            Shading::Flat => {
                let lit = self.lights.shine(self.material, &self.centre(vertices));
                Shade::Corners(Box::new([lit; 3]))
            }
            Shading::Gouraud => Shade::Corners(Box::new(vertices.map(|i| at_vertices[i]))),
            Shading::Phong => Shade::Pixels(Box::new(vertices.map(|i| self.vertex(i)))),
        }
    }
}

/// Appends one actor's faces.
fn place(
    scene: &Scene,
    (view, lights, textures): (&View, &Lights, &[Texture]),
    (index, actor): (usize, &Actor),
    frame: u32,
    faces: &mut Vec<Face>,
) {
    let placing = Placing::new(scene, (view, lights, textures), index, frame);
    let Placing { mesh, material, .. } = placing;
    let hidden = actor.look.representation == Representation::HiddenLine;
    let seen: Vec<DVec3> = placing.places.iter().map(|p| view.to_view(*p)).collect();
    let at_vertices: Vec<Lit> = match material.shading {
        Shading::Flat | Shading::Phong => Vec::new(),
        Shading::Gouraud => (0..mesh.positions.len())
            .map(|i| placing.lit_vertex(i))
            .collect(),
    };
    for (triangle, corners) in mesh.triangles.iter().enumerate() {
        let [a, mut b, mut c] = corners.map(|i| i as usize);
        if placing.mirrored {
            std::mem::swap(&mut b, &mut c);
        }
        let corners = [a, b, c].map(|i| seen[i]);
        let sunk = || sunk_lsb(view, corners, f64::from(actor.look.line_width));
        faces.push(Face {
            corners,
            shade: placing.shade([a, b, c], &at_vertices),
            actor: index,
            triangle,
            // Hidden lines are seen from all sides.
            cull: if hidden { Cull::None } else { material.cull },
            texture: if hidden {
                None
            } else {
                placing.texture([a, b, c], corners)
            },
            sunk_lsb: hidden.then(sunk),
            through: Through::Opaque,
        });
    }
}

/// How much deeper a face of a hidden-line actor lies; see
/// [`Representation::HiddenLine`].
fn sunk_lsb(view: &View, corners: [DVec3; 3], line_width: f64) -> f64 {
    let [near, far] = view.range();
    let depths = corners.map(|p| view.depth_lsb(p.z.clamp(near, far)));
    let [low, high] = [f64::min, f64::max].map(|pick| depths.into_iter().reduce(pick));
    let range = high.unwrap_or(0.0) - low.unwrap_or(0.0);
    (view.slope_lsb(corners) * line_width / 2.0).min(range) + 1.0
}
