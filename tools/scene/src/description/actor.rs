//! Meshes and actors.

use super::Rgb;
use crate::look::Look;

/// A triangle mesh. Positions, normals and colours share one index.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mesh {
    /// Where it came from, for messages.
    pub name: String,
    /// Vertex positions, finite.
    pub positions: Vec<[f64; 3]>,
    /// Vertex normals, unit length, as many as positions. Where the file had
    /// none they were made by crease angle.
    pub normals: Vec<[f64; 3]>,
    /// Vertex colours, as many as positions, or none. A surface's ambient and
    /// diffuse colour (which emission takes up too) are multiplied by them, as
    /// glTF does with its base colour, though here on display-encoded values.
    pub colours: Vec<Rgb>,
    /// Texture coordinates `(u, v)`, as many as positions, or none: `u` goes to the
    /// right, `v` up, (0, 0) is the picture's lower left corner, (1, 1) its upper
    /// right one. Meshes that no textured material is on have none.
    pub texture_coordinates: Vec<[f64; 2]>,
    /// Vertex indices, counter-clockwise seen from outside. May hold
    /// triangles without area; indices are all within `positions`.
    pub triangles: Vec<[u32; 3]>,
    /// What a wireframe draws, as vertex indices: each edge of the triangles
    /// once, even if its triangles have vertices of their own at the same
    /// places, without those that only divide a polygon into triangles; or
    /// lines by themselves.
    pub edges: Vec<[u32; 2]>,
    /// What the triangles stand for: the ray caster meets this instead of them.
    pub primitive: Option<Primitive>,
}

/// A shape that is known exactly.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Primitive {
    /// A sphere about the origin. Its normals point outward.
    Sphere {
        /// Above 0.
        radius: f64,
    },
    /// A rectangle about the origin in the plane y = 0, which faces +y. Its texture
    /// coordinates are (0, 0) at -x, +z, (1, 0) at +x, +z, (0, 1) at -x, -z.
    Rectangle {
        /// Along x, above 0.
        width: f64,
        /// Along z, above 0.
        depth: f64,
    },
}

/// A mesh placed in its parent's space, or in the world: a point goes to `origin`,
/// is scaled, sheared, turned about y, then x, then z, taken back, moved to
/// `position` and goes through `matrix`; then the same through the parent's:
/// `M T(position) T(origin) Rz Rx Ry H S T(-origin)`.
#[derive(Clone, Debug, PartialEq)]
pub struct Actor {
    /// Its name in the file, or made from its index.
    pub name: String,
    /// Index into [`Scene::meshes`](super::Scene::meshes).
    pub mesh: usize,
    /// Index into [`Scene::materials`](super::Scene::materials).
    pub material: usize,
    /// The point that scaling and turning leave in place.
    pub origin: [f64; 3],
    /// The move in world space.
    pub position: [f64; 3],
    /// Angles about x, y, z in degrees.
    pub orientation: [f64; 3],
    /// Factors along x, y, z; not 0, may be negative (a reflection keeps the
    /// faces' outer side outward).
    pub scale: [f64; 3],
    /// What is added: y and z times these to x, x and z to y, x and y to z. All
    /// at once, from the scaled point. The whole can be inverted.
    pub shear: [f64; 6],
    /// Rows of a matrix that can be inverted; the last is 0, 0, 0, 1.
    pub matrix: [[f64; 4]; 4],
    /// Index of the actor whose own way to the world comes after this one's; no
    /// actor is among its own ancestors.
    pub parent: Option<usize>,
    /// What of it is drawn, and how.
    pub look: Look,
    /// A turntable leaves it where it is.
    pub still: bool,
    /// A further part of its parent, in another material: what shows it shows the
    /// parent.
    pub part: bool,
}

/// The matrix that leaves everything in place.
pub const IDENTITY: [[f64; 4]; 4] = [
    [1.0, 0.0, 0.0, 0.0],
    [0.0, 1.0, 0.0, 0.0],
    [0.0, 0.0, 1.0, 0.0],
    [0.0, 0.0, 0.0, 1.0],
];

impl Default for Actor {
    /// The first mesh, in the first material, as it is.
    fn default() -> Self {
        Self {
            name: String::new(),
            mesh: 0,
            material: 0,
            origin: [0.0; 3],
            position: [0.0; 3],
            orientation: [0.0; 3],
            scale: [1.0; 3],
            shear: [0.0; 6],
            matrix: IDENTITY,
            parent: None,
            look: Look::default(),
            still: false,
            part: false,
        }
    }
}
