//! The scene as plain data: what the baker, the f64 reference and the
//! commands read. It holds no arithmetic: how a matrix is composed, how a
//! light level comes about, is for each reader to work out by itself, or the
//! reference would prove nothing.
//!
//! Units: lengths in scene units, angles in degrees, colours display-encoded
//! red, green, blue in 0..=1. Meanings of camera and actor fields are VTK's.

/// A colour: display-encoded red, green and blue, each in 0..=1.
pub type Rgb = [f64; 3];

/// A whole scene with every default filled in.
#[derive(Clone, Debug, PartialEq)]
pub struct Scene {
    /// The screen that the scene is drawn for.
    pub display: Display,
    /// The eye.
    pub camera: Camera,
    /// The ambient light `A`: the sum over all ambient lights of colour times
    /// intensity; white if the file names none.
    pub ambient: Rgb,
    /// Lights other than ambient. A file without any `[[light]]` gets one
    /// white headlight along the camera's line of sight.
    pub lights: Vec<Light>,
    /// Materials, in the file's order.
    pub materials: Vec<Material>,
    /// Meshes, each file once.
    pub meshes: Vec<Mesh>,
    /// Actors, in the file's order.
    pub actors: Vec<Actor>,
    /// What moves.
    pub animation: Animation,
    /// How the palette is made.
    pub palette: Palette,
}

/// The screen.
#[derive(Clone, Debug, PartialEq)]
pub struct Display {
    /// Width in pixels, 1..=2048.
    pub width: u32,
    /// Height in pixels, 1..=2048.
    pub height: u32,
    /// What the panel can show.
    pub colour: ColourFormat,
    /// What is seen where nothing is drawn.
    pub background: Background,
}

/// The panel's colour depth.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ColourFormat {
    /// 8 bits a channel.
    Rgb888,
    /// 5, 6, 5 bits.
    Rgb565,
    /// 4 bits a channel.
    Rgb444,
    /// 256 greys.
    Gray8,
    /// 16 greys.
    Gray4,
    /// 4 greys.
    Gray2,
    /// Black and white.
    Mono,
}

/// The background.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Background {
    /// One colour.
    Solid(Rgb),
    /// From the top edge of the picture to its bottom edge. A pixel row `y`
    /// of `height` has the colour at `(y + 0.5) / height` of the way.
    Gradient {
        /// At the top edge.
        top: Rgb,
        /// At the bottom edge.
        bottom: Rgb,
    },
}

/// The eye. Right-handed; looks from `position` to `focal_point`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera {
    /// The eye's place.
    pub position: [f64; 3],
    /// What is in the middle of the picture.
    pub focal_point: [f64; 3],
    /// A direction that points up in the picture; need not be perpendicular
    /// to the line of sight, must not be parallel to it.
    pub view_up: [f64; 3],
    /// How depth shrinks things.
    pub projection: Projection,
    /// Distances of the near and the far plane along the line of sight;
    /// 0 < near < far for perspective.
    pub clipping_range: [f64; 2],
}

/// Perspective or parallel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Projection {
    /// Perspective.
    Perspective {
        /// Full vertical angle of view, in degrees.
        view_angle: f64,
    },
    /// Parallel.
    Parallel {
        /// Half of the picture's height, in scene units.
        parallel_scale: f64,
    },
}

/// A light that has a direction or a place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Light {
    /// What kind.
    pub kind: LightKind,
    /// Its colour.
    pub colour: Rgb,
    /// Multiplies the colour; may exceed 1.
    pub intensity: f64,
}

/// Kinds of light. More come with later capabilities.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum LightKind {
    /// From infinitely far.
    Directional {
        /// The way the light travels, in world space; any length but 0.
        direction: [f64; 3],
    },
}

/// A surface.
#[derive(Clone, Debug, PartialEq)]
pub struct Material {
    /// Its name in the file.
    pub name: String,
    /// Colour under ambient light, `Ca`.
    pub ambient_colour: Rgb,
    /// Colour under diffuse light, `Cd`.
    pub diffuse_colour: Rgb,
    /// Coefficient `ka`, 0..=1. Default 0.
    pub ambient: f64,
    /// Coefficient `kd`, 0..=1. Default 1.
    pub diffuse: f64,
    /// Light of its own, 0..=1: `emission * diffuse_colour` is added.
    pub emission: f64,
    /// Where the light model is worked out.
    pub shading: Shading,
    /// Which faces are left out.
    pub cull: Cull,
}

/// Where the light model is worked out.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shading {
    /// Once a face, from the normal of the face's winding.
    Flat,
    /// At the vertices, interpolated over the face.
    Gouraud,
}

/// Which faces are left out. A face is seen from its front when its vertices
/// appear counter-clockwise on the screen.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Cull {
    /// Faces seen from behind are left out (the default).
    Back,
    /// Faces seen from the front are left out.
    Front,
    /// All are drawn. The light model uses the normal as it stands, not
    /// turned to the viewer.
    None,
}

/// A triangle mesh. Positions and normals share one index.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mesh {
    /// Where it came from, for messages.
    pub name: String,
    /// Vertex positions, finite.
    pub positions: Vec<[f64; 3]>,
    /// Vertex normals, unit length, as many as positions. Where the file had
    /// none they were made by crease angle.
    pub normals: Vec<[f64; 3]>,
    /// Vertex indices, counter-clockwise seen from outside. May hold
    /// triangles without area; indices are all within `positions`.
    pub triangles: Vec<[u32; 3]>,
}

/// A mesh placed in the world: a point goes to `origin`, is scaled, turned
/// about y, then x, then z, taken back and moved to `position`:
/// `T(position) T(origin) Rz Rx Ry S T(-origin)`.
#[derive(Clone, Debug, PartialEq)]
pub struct Actor {
    /// Its name in the file, or made from its index.
    pub name: String,
    /// Index into [`Scene::meshes`].
    pub mesh: usize,
    /// Index into [`Scene::materials`].
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
}

/// What moves from frame to frame.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Animation {
    /// Frames in one turn of every actor about its own y axis, if it turns:
    /// frame `n` adds `360 * n / turntable` degrees to `orientation[1]`.
    pub turntable: Option<u32>,
}

/// How the palette is made.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Palette {
    /// Entries, 2..=256.
    pub colours: u32,
}
