//! A bench scene as other renderers take it: one mesh, one light, one material.

use std::path::Path;

use fixel_reference::actor_matrix;
use fixel_scene::{Background, LightKind, Projection, Scene, Shading};
use glam::{DMat4, DVec3, Mat4, Vec3, Vec4};

/// One mesh under one light, in floats.
#[derive(Debug)]
pub struct Model {
    /// Columns and rows of the picture.
    pub size: [usize; 2],
    /// Vertices; of a mesh that is flat or has a texture, each triangle has three of its own.
    pub positions: Vec<[f32; 3]>,
    /// Their normals.
    pub normals: Vec<[f32; 3]>,
    /// Where in the picture they are, across and down.
    pub coordinates: Vec<[f32; 2]>,
    /// The triangles.
    pub triangles: Vec<[usize; 3]>,
    /// A normal a triangle.
    pub face_normals: Vec<[f32; 3]>,
    /// In display-encoded light, 0 to 1.
    pub colour: [f32; 3],
    /// A picture of 8 bits a channel, its columns and rows, if it is on the mesh.
    pub texture: Option<(Vec<[u8; 3]>, [usize; 2])>,
    /// Of ambient and diffuse light.
    pub coefficients: [f32; 2],
    /// What the background is.
    pub background: [u8; 3],
    /// Towards the light, of length 1.
    pub towards: [f32; 3],
    /// The camera's place, focal point, and vertical angle of view in radians.
    pub camera: ([f32; 3], [f32; 3], f32),
    /// Near and far plane.
    pub range: [f32; 2],
    /// Whether faces are lit, not vertices.
    pub is_flat: bool,
    scene: Scene,
}

impl Model {
    /// From a scene with one actor and one directional light.
    ///
    /// # Errors
    /// If there is something else in it.
    pub fn load(path: &Path) -> Result<Self, String> {
        let scene = fixel_scene::load(path).map_err(|error| error.to_string())?;
        let fail = |what: &str| format!("{}: {what}", path.display());
        let [actor] = scene.actors.as_slice() else {
            return Err(fail("not one actor"));
        };
        let light = scene.lights.first().ok_or_else(|| fail("no light"))?;
        let LightKind::Directional { direction } = light.kind else {
            return Err(fail("not a directional light"));
        };
        let material = &scene.materials[actor.material];
        let mesh = &scene.meshes[actor.mesh];
        let Projection::Perspective { view_angle } = scene.camera.projection else {
            return Err(fail("not a perspective view"));
        };
        let texture = material.texture.as_ref().map(|texture| {
            let picture = &scene.textures[texture.texture];
            let texels = picture.texels.iter().map(|[r, g, b, _]| [*r, *g, *b]);
            (
                texels.collect(),
                [picture.width as usize, picture.height as usize],
            )
        });
        let Background::Solid(background) = scene.display.background else {
            return Err(fail("a background of two colours"));
        };
        let flat = material.shading == Shading::Flat;
        let f32s = |v: &[f64; 3]| v.map(|c| c as f32);
        let mut model = Self {
            size: [scene.display.width as usize, scene.display.height as usize],
            positions: mesh.positions.iter().map(f32s).collect(),
            normals: mesh.normals.iter().map(f32s).collect(),
            coordinates: mesh
                .texture_coordinates
                .iter()
                // Pictures go down, coordinates up.
                .map(|[u, v]| [*u as f32, 1.0 - *v as f32])
                .collect(),
            triangles: mesh
                .triangles
                .iter()
                .map(|t| t.map(|index| index as usize))
                .collect(),
            face_normals: Vec::new(),
            colour: material.diffuse_colour.map(|c| c as f32),
            texture,
            coefficients: [material.ambient as f32, material.diffuse as f32],
            background: background.map(|c| (c * 255.0).round() as u8),
            towards: (-DVec3::from(direction)).normalize().as_vec3().to_array(),
            camera: (
                f32s(&scene.camera.position),
                f32s(&scene.camera.focal_point),
                (view_angle as f32).to_radians(),
            ),
            range: scene.camera.clipping_range.map(|c| c as f32),
            is_flat: flat,
            scene,
        };
        model.face_normals = model.triangles.iter().map(|t| model.face(*t)).collect();
        if flat {
            model.unshare();
        }
        Ok(model)
    }

    fn face(&self, triangle: [usize; 3]) -> [f32; 3] {
        let [a, b, c] = triangle.map(|index| Vec3::from(self.positions[index]));
        (b - a).cross(c - a).normalize_or_zero().to_array()
    }

    /// Gives each triangle corners of its own, with its normal.
    fn unshare(&mut self) {
        let corners = || self.triangles.iter().flatten().copied();
        let positions = corners().map(|i| self.positions[i]).collect();
        let coordinates = corners()
            .filter_map(|i| self.coordinates.get(i).copied())
            .collect();
        let normals = self.face_normals.iter().flat_map(|n| [*n; 3]).collect();
        let triangles = (0..self.triangles.len()).map(|t| [3 * t, 3 * t + 1, 3 * t + 2]);
        let triangles = triangles.collect();
        (self.positions, self.normals) = (positions, normals);
        (self.coordinates, self.triangles) = (coordinates, triangles);
    }

    /// From the mesh to the world in a frame.
    pub fn to_world(&self, frame: u32) -> Mat4 {
        matrix(actor_matrix(&self.scene, 0, frame))
    }

    /// From the world to clip space, -1 to 1 in all directions (OpenGL's).
    pub fn to_clip(&self) -> Mat4 {
        let (eye, focal_point, angle) = self.camera;
        let forward = (Vec3::from(focal_point) - Vec3::from(eye)).normalize();
        let right = forward.cross(Vec3::Y).normalize();
        let rows = [right, right.cross(forward), -forward].map(|axis| {
            let moved = -axis.dot(eye.into());
            axis.extend(moved)
        });
        let view = Mat4::from_cols(rows[0], rows[1], rows[2], Vec4::W).transpose();
        let [width, height] = self.size.map(|side| side as f32);
        let [near, far] = self.range;
        let up = 1.0 / (angle / 2.0).tan();
        let depth = [(far + near) / (near - far), 2.0 * far * near / (near - far)];
        let projection = Mat4::from_cols(
            Vec4::X * (up * height / width),
            Vec4::Y * up,
            Vec4::new(0.0, 0.0, depth[0], -1.0),
            Vec4::Z * depth[1],
        );
        projection * view
    }

    /// Light of 0 to 1 on a normal in the mesh's space, towards the light as
    /// [`Model::light_in_mesh`] has it.
    #[inline(always)]
    pub fn light(&self, normal: [f32; 3], towards: [f32; 3]) -> f32 {
        let [ambient, diffuse] = self.coefficients;
        let cosine: f32 = normal.iter().zip(towards).map(|(n, l)| n * l).sum();
        (ambient + diffuse * cosine.max(0.0)).min(1.0)
    }

    /// Towards the light in the mesh's space.
    pub fn light_in_mesh(&self, to_world: &Mat4) -> [f32; 3] {
        let towards = to_world.inverse().transform_vector3(self.towards.into());
        towards.normalize().to_array()
    }

    /// The colour of a surface in light of 0 to 1.
    #[inline(always)]
    pub fn lit(&self, level: f32) -> [u8; 3] {
        self.colour.map(|c| (c * level * 255.0) as u8)
    }

    /// The background as the panel takes it.
    pub fn empty(&self) -> u16 {
        rgb565(self.background)
    }
}

fn matrix(matrix: DMat4) -> Mat4 {
    matrix.as_mat4()
}

/// RGB565, so that its bytes in memory are in the panel's order: high byte first.
#[inline(always)]
pub fn rgb565([r, g, b]: [u8; 3]) -> u16 {
    let (r, g, b) = (u16::from(r) >> 3, u16::from(g) >> 2, u16::from(b) >> 3);
    (r << 11 | g << 5 | b).to_be()
}
