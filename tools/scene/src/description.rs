//! The scene as plain data: what the baker, the f64 reference and the
//! commands read. It holds no arithmetic: how a matrix is composed, how a
//! light level comes about, is for each reader to work out by itself, or the
//! reference would prove nothing.
//!
//! Units: lengths in scene units, angles in degrees, colours display-encoded
//! red, green, blue in 0..=1. Meanings of camera and actor fields are VTK's.

use crate::look::Look;
use crate::texture::{Texture, Texturing};

/// A colour: display-encoded red, green and blue, each in 0..=1.
pub type Rgb = [f64; 3];

/// A whole scene with every default filled in.
#[derive(Clone, Debug, PartialEq)]
pub struct Scene {
    /// The screen that the scene is drawn for.
    pub display: Display,
    /// The eye.
    pub camera: Camera,
    /// Parts of the picture, later ones over earlier ones; none: the whole
    /// picture shows what `camera` sees.
    pub viewports: Vec<Viewport>,
    /// The ambient light `A`: the sum over all ambient lights of colour times
    /// intensity; white if the file names none.
    pub ambient: Rgb,
    /// Lights other than ambient. A file without any `[[light]]` gets one
    /// white headlight along the camera's line of sight.
    pub lights: Vec<Light>,
    /// Textures, each file once.
    pub textures: Vec<Texture>,
    /// Materials, in the file's order.
    pub materials: Vec<Material>,
    /// Meshes, each file once.
    pub meshes: Vec<Mesh>,
    /// Actors, in the file's order.
    pub actors: Vec<Actor>,
    /// What veils the distance.
    pub fog: Option<Fog>,
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
    /// Samples of a pixel, across and down, whose display-encoded colours are
    /// averaged: 1 or 2 each (the reference takes any number).
    pub samples: [u32; 2],
    /// Pictures for two eyes.
    pub stereo: Stereo,
}

/// Pictures for two eyes. Each eye is moved aside and looks parallel to the camera's
/// line of sight; its picture is sheared so that what is as far away as the focal
/// point is in the same place for both (as VTK does it).
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Stereo {
    /// One eye (the default).
    None,
    /// The left eye's picture in red, the right one's in green and blue.
    Anaglyph {
        /// Degrees between the two lines from the eyes to the focal point.
        eye_angle: f64,
    },
    /// The left eye's picture in the left half of the display, the right one's in
    /// the right half.
    SideBySide {
        /// As for an anaglyph.
        eye_angle: f64,
    },
}

impl Stereo {
    /// The angle between the eyes in degrees, 0 for one eye.
    pub fn eye_angle(&self) -> f64 {
        match *self {
            Self::None => 0.0,
            Self::Anaglyph { eye_angle } | Self::SideBySide { eye_angle } => eye_angle,
        }
    }

    /// How many eyes.
    pub fn eyes(&self) -> u32 {
        if *self == Self::None { 1 } else { 2 }
    }

    /// How many pictures stand beside each other in the frame and become one.
    pub fn joined(&self) -> u32 {
        if matches!(self, Self::Anaglyph { .. }) {
            2
        } else {
            1
        }
    }
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

/// A part of the picture.
#[derive(Clone, Debug, PartialEq)]
pub struct Viewport {
    /// `[x, y, width, height]` as parts of the picture's width and height, all
    /// within 0..=1; (x, y) is the lower left corner and y points up, as VTK has
    /// it. In pixels, each side is at the line between pixels that is nearest.
    pub rectangle: [f64; 4],
    /// Its own eye; `None`: [`Scene::camera`].
    pub camera: Option<Camera>,
    /// Its own background; `None`: [`Display::background`], a gradient of which
    /// runs from the viewport's top edge to its bottom edge.
    pub background: Option<Background>,
    /// How the camera's picture is brought into it.
    pub aspect: Aspect,
}

/// How a camera's picture is brought into a viewport. Its height always shows the
/// camera's angle of view or parallel scale.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Aspect {
    /// Pixels are square; the viewport's shape decides how much is seen to the
    /// sides (the default).
    Keep,
    /// As much is seen as in the whole picture, squeezed or stretched.
    Stretch,
}

/// A light that has a direction or a place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Light {
    /// What kind.
    pub kind: LightKind,
    /// Its colour. Default white.
    pub colour: Rgb,
    /// Multiplies the colour; 0 or more, may exceed 1. Default 1.
    pub intensity: f64,
}

/// Kinds of light. At a surface point, `l` is the unit vector towards the
/// light and `d` the distance to it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum LightKind {
    /// From infinitely far: the same everywhere.
    Directional {
        /// The way the light travels, in world space; any length but 0.
        direction: [f64; 3],
    },
    /// From a place to all sides.
    Point {
        /// Where, in world space. A surface point just there gets no light.
        position: [f64; 3],
        /// Weaker with distance.
        attenuation: Attenuation,
    },
    /// From a place, within a cone with a sharp edge (VTK's, OpenGL's):
    /// multiplied by `max(0, -l . direction)^exponent` inside, 0 outside.
    Spot {
        /// Where, in world space. A surface point just there gets no light.
        position: [f64; 3],
        /// The cone's axis, the way the light travels, in world space; any
        /// length but 0.
        direction: [f64; 3],
        /// Weaker with distance.
        attenuation: Attenuation,
        /// From the axis to the cone's edge, in degrees, 1..=89; the edge
        /// itself is lit. Default 30.
        cone_angle: f64,
        /// How much the light is gathered around the axis, 0..=128; 0 is even
        /// light. Default 1.
        exponent: f64,
    },
}

/// `[c, l, q]`: light at distance `d`, in scene units, is multiplied by
/// `1 / (c + l*d + q*d^2)`. Each 0 or more, not all 0; default `[1, 0, 0]`,
/// no attenuation. With `c` below 1 the factor exceeds 1 near the light.
pub type Attenuation = [f64; 3];

/// A surface. Its colour under light is, on display-encoded values and clamped
/// to 0..=1 in each channel,
///
/// ```text
/// emission*Cd + Ca*ka*A + sum over lights of
///     attenuation * spot * L * (Cd*kd*max(0, N.l) + Cs*ks*max(0, R.v)^power)
/// ```
///
/// with `A` the ambient light, `L` a light's colour times intensity, `N` the
/// normal, `l` towards the light, `v` towards the eye (of a parallel camera:
/// against the line of sight) and `R` the mirror image of `l` about `N`. The
/// specular part is there only where `N.l > 0`.
#[derive(Clone, Debug, PartialEq)]
pub struct Material {
    /// Its name in the file.
    pub name: String,
    /// Colour under ambient light, `Ca`. Default white.
    pub ambient_colour: Rgb,
    /// Colour under diffuse light, `Cd`. Default white.
    pub diffuse_colour: Rgb,
    /// Colour of highlights, `Cs`. Default white. A file's `colour` sets all
    /// three, as VTK's `SetColor` does.
    pub specular_colour: Rgb,
    /// Coefficient `ka`, 0..=1. Default 0.
    pub ambient: f64,
    /// Coefficient `kd`, 0..=1. Default 1.
    pub diffuse: f64,
    /// Coefficient `ks`, 0..=1. Default 0.
    pub specular: f64,
    /// How sharp highlights are, 1..=128. Default 1.
    pub specular_power: f64,
    /// Light of its own, 0..=1: `emission * diffuse_colour` is added. Default 0.
    pub emission: f64,
    /// Where the light model is worked out. Default Gouraud.
    pub shading: Shading,
    /// Which faces are left out. Default back faces.
    pub cull: Cull,
    /// What multiplies its ambient and diffuse colour from place to place. Every
    /// mesh that it is on, as a surface, has texture coordinates.
    pub texture: Option<Texturing>,
}

impl Default for Material {
    /// VTK's, without a name.
    fn default() -> Self {
        Self {
            name: String::new(),
            ambient_colour: [1.0; 3],
            diffuse_colour: [1.0; 3],
            specular_colour: [1.0; 3],
            ambient: 0.0,
            diffuse: 1.0,
            specular: 0.0,
            specular_power: 1.0,
            emission: 0.0,
            shading: Shading::Gouraud,
            cull: Cull::Back,
            texture: None,
        }
    }
}

/// Where the light model is worked out.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shading {
    /// Once a face: at its centre (the mean of its corners), with the normal of
    /// its winding and the mean of its vertex colours.
    Flat,
    /// At the vertices; the clamped colours are interpolated over the face.
    Gouraud,
    /// At each pixel, at the surface point there, with the normal (and the
    /// vertex colour) interpolated over the face and the normal brought back
    /// to length 1.
    Phong,
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
    /// The radius, if the triangles stand for a sphere about the origin.
    pub sphere: Option<f64>,
}

/// A mesh placed in its parent's space, or in the world: a point goes to `origin`,
/// is scaled, sheared, turned about y, then x, then z, taken back, moved to
/// `position` and goes through `matrix`; then the same through the parent's:
/// `M T(position) T(origin) Rz Rx Ry H S T(-origin)`.
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
        }
    }
}

/// What moves from frame to frame.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Animation {
    /// Frames in one turn of every actor without a parent about its own y axis, if
    /// they turn: frame `n` adds `360 * n / turntable` degrees to `orientation[1]`.
    pub turntable: Option<u32>,
    /// Frames after which the tracks start again: frame `n` is theirs `n % frames`.
    pub frames: Option<u32>,
    /// Key frames. Those of the camera are applied in the order of their
    /// quantities.
    pub tracks: Vec<Track>,
    /// Palette entries that go round.
    pub palette_cycle: Option<PaletteCycle>,
}

/// Palette entries that take each other's place: in frame `n` the entry
/// `first + i` of `count` has the colour of entry
/// `first + (i + floor(n * count / frames)) mod count`. No renderer but those that
/// have a palette shows it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PaletteCycle {
    /// The first entry.
    pub first: u32,
    /// The last entry, after `first`.
    pub last: u32,
    /// Frames in which they go round once, at least 1.
    pub frames: u32,
}

/// One quantity of one thing over time: linear between the keys, the first one's
/// value before them, the last one's after them.
#[derive(Clone, Debug, PartialEq)]
pub struct Track {
    /// What moves.
    pub target: Target,
    /// What of it.
    pub quantity: Quantity,
    /// At least one, by frame; no two at one.
    pub keys: Vec<Key>,
}

/// What a track moves.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Target {
    /// An actor, by its index.
    Actor(usize),
    /// The camera.
    Camera,
}

/// What of it a track moves. The camera's are turns and factors beside what
/// `[camera]` says; VTK's words.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Quantity {
    /// An actor's or the camera's position.
    Position,
    /// The camera's focal point.
    FocalPoint,
    /// An actor's angles, in degrees.
    Orientation,
    /// A factor of an actor's scale, of its children's with it.
    Scale,
    /// The eye turns about the focal point, round the view-up vector; degrees.
    Azimuth,
    /// The eye turns about the focal point, round the picture's horizontal, up;
    /// degrees.
    Elevation,
    /// The view-up vector turns round the line of sight; degrees.
    Roll,
    /// The distance from the eye to the focal point is divided by this.
    Dolly,
    /// The view angle, or the parallel scale, is divided by this.
    Zoom,
    /// Eye and focal point move so far to the right and up, in the picture's plane.
    Pan,
}

/// A track's value in one frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Key {
    /// The frame.
    pub frame: u32,
    /// The value; of a single number, the first.
    pub value: [f64; 3],
}

impl Animation {
    /// Frames after which everything starts again: of the tracks, or of the
    /// turntable, or of the palette.
    pub fn length(&self) -> Option<u32> {
        let cycle = self.palette_cycle.map(|cycle| cycle.frames);
        self.frames.or(self.turntable).or(cycle)
    }
}

/// Fog: the farther away something is along the line of sight (not along the ray),
/// the more its colour is mixed with the fog's. Where nothing is seen, the background
/// stays as it is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fog {
    /// Its colour.
    pub colour: Rgb,
    /// How it thickens.
    pub mode: FogMode,
}

/// How fog thickens with the distance `w`: its part of a colour, held to 0..=1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum FogMode {
    /// `(w - start) / (end - start)`.
    Linear {
        /// Where it begins, in scene units.
        start: f64,
        /// Where nothing else is seen.
        end: f64,
    },
    /// `1 - e^-(density * w)`.
    Exponential {
        /// Above 0; a scene unit is the unit of distance.
        density: f64,
    },
    /// `1 - e^-(density * w)^2`.
    ExponentialSquared {
        /// Above 0.
        density: f64,
    },
}

/// How the palette is made, and how colours find their entry.
#[derive(Clone, Debug, PartialEq)]
pub struct Palette {
    /// Most entries, 2..=256. Default 256.
    pub colours: u32,
    /// The entries if they come from a file, 8 bits a channel, 2..=256 of them: used
    /// as they are and in that order. If empty, they are chosen from the colours
    /// that the scene can show.
    pub fixed: Vec<[u8; 3]>,
    /// Entries 0, 1, 2, ..: the steps of these ramps one after the other, before
    /// those that are chosen, so that a program knows where they are (to cycle them,
    /// say). All steps together are at most `colours`.
    pub ramps: Vec<Ramp>,
    /// Of what goes by colour; what goes by light level is never dithered.
    pub dithering: Dithering,
}

impl Default for Palette {
    fn default() -> Self {
        Self {
            colours: 256,
            fixed: Vec::new(),
            ramps: Vec::new(),
            dithering: Dithering::default(),
        }
    }
}

/// Palette entries from one colour to another, evenly spaced in Oklab.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ramp {
    /// The first entry.
    pub from: Rgb,
    /// The last entry.
    pub to: Rgb,
    /// Entries, 2..=256.
    pub steps: u32,
}

/// What is added to a colour before its 4 bits a channel are looked up in the
/// palette: a pattern of thresholds that repeats over the screen (Bayer, 1973).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Dithering {
    /// Nothing.
    None,
    /// 4 by 4 pixels (the default).
    #[default]
    Bayer4,
    /// 8 by 8 pixels.
    Bayer8,
}
