//! The scene in flash. In: the bytes of a `.fxl` blob. Out: [`Scene`], checked
//! once and then read in place, and the [`Pose`] it takes in a frame. Used by
//! every later stage; imports only number formats.

mod access;
mod camera_record;
mod cone;
mod error;
mod features;
mod fog;
mod header;
mod light;
mod look;
mod material;
mod moves;
mod output;
mod parse;
mod parse_actor;
mod parse_light;
mod parse_mesh;
mod parse_ray;
mod pose;
mod range;
mod ray;
mod records;
mod sections;
mod texture;
mod track;
mod units;
mod viewport;

pub use camera_record::CameraRecord;
pub use cone::FaceCone;
pub use error::{Field, SceneError, Section};
pub use fog::{Fog, FogMode};
pub use header::Header;
pub use light::{Light, LightKind};
pub use look::{Look, Representation};
pub use material::{Channels, Cull, Dither, DitherPattern, Material, Shading, Transparency};
pub use output::{Output, Stereo};
pub use pose::{Camera, Place, Placement, Pose, Projection};
pub use ray::{Child, Leaf, LightArea, Node, Optics, RaySettings, Shape};
pub use records::{
    Actor, ColourFormat, Coordinates, Mesh, Meshlet, PanelDithering, Record, checksum,
};
pub use sections::Scene;
pub use texture::{NO_TEXEL, Texture, Wrap};
pub use track::{Key, Quantity, Track};
pub use viewport::{FULL_SIDE, Gradient, PlacedViewport, Viewport};

/// Sizes and limits of the blob.
pub mod layout {
    /// `FXL1`.
    pub const MAGIC: u32 = u32::from_le_bytes(*b"FXL1");
    /// Version of the layout. A reader refuses any other.
    pub const VERSION: u32 = 8;
    /// Words of the header, before the section table.
    pub const HEADER_WORDS: usize = 28;
    /// Sections; each has two words in the table: byte offset and count.
    pub const SECTIONS: usize = 36;
    /// Cargo features that a scene may need: bits of the header.
    pub const FEATURES: usize = 9;
    /// Bytes before the first section.
    pub const PREFIX_BYTES: usize = 4 * (HEADER_WORDS + 2 * SECTIONS);
    /// Where the checksum starts: after magic, version, length, checksum.
    pub const CHECKED_FROM: usize = 16;
    /// Colours that the look-up tells apart: 4 bits each of red, green and blue.
    pub const COLOURS: usize = 1 << 12;
    /// Most meshlets of a scene.
    pub const MESHLETS: usize = 1 << 25;
    /// `log2` of the most texels that a texture is wide or high.
    pub const TEXTURE_SIZE: u8 = 10;
    /// Base colours of all textures.
    pub const BASES: usize = 64;
    /// Entries of a table from light level (64 of them) and base colour to index.
    pub const TEXTURE_SHADES: usize = 64 * BASES;
    /// Vertices in a meshlet.
    pub const MESHLET_VERTICES: usize = 64;
    /// Triangles in a meshlet.
    pub const MESHLET_TRIANGLES: usize = 128;
    /// Triangles that share a [`FaceCone`](super::FaceCone), in a meshlet's order.
    pub const CONE_TRIANGLES: usize = 8;
    /// Set in an edge's second end whose pixel another edge draws.
    pub const CHAINED: u8 = 0x80;
    /// Most columns or rows of a mark.
    pub const MARK: i64 = 4096;
    /// Lights with a direction or a place.
    pub const LIGHTS: usize = 8;
    /// Rows of a fog table: from no fog to nothing but fog, in even steps.
    pub const FOG_ROWS: usize = 32;
    /// Viewports.
    pub const VIEWPORTS: usize = 8;
    /// Half of a mesh's grid: vertices are within this many steps of its
    /// centre along each axis.
    pub const GRID_HALF: i32 = 1 << 21;
    /// A mesh's stated radius is at least this, however small the mesh: what is
    /// smaller would need more bits in a matrix than there are.
    pub const LEAST_RADIUS: u32 = 1 << 20;
    /// Range of an actor's step exponent: a mesh's reach, at most 2^22 steps of
    /// less than twice that, stays within 2^23 world units, far beyond what a
    /// world holds.
    pub const STEP_EXPONENTS: (i32, i32) = (-64, 0);
    /// Most actors above an actor: its parent, its parent's parent and so on.
    pub const PARENTS: usize = 16;
    /// The target of a track that moves the camera.
    pub const CAMERA: u16 = u16::MAX;
    /// Boxes that a ray on its way through a hierarchy leaves for later, at most.
    pub const RAY_STACK: usize = 48;
    /// Largest shift of a meshlet's vertices: 16 bits and this span the grid.
    pub const MOST_SHIFT: u8 = 7;
}
