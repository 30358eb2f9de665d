//! What can be wrong with a blob.

use core::fmt;

/// A part of the blob.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[expect(missing_docs, reason = "the names say it")]
pub enum Section {
    Palette,
    Shades,
    Background,
    Lights,
    Materials,
    Actors,
    Meshes,
    Meshlets,
    Vertices,
    Triangles,
    FaceNormals,
    Fine,
    Viewports,
    ViewportBackgrounds,
    Tracks,
    Keys,
    Fog,
    FogTable,
    VertexColours,
    Colours,
    Output,
    Looks,
    Marks,
    Edges,
    MeshletEdges,
    Coordinates,
    Textures,
    Texels,
    Bases,
    TextureShades,
    RaySettings,
    Shapes,
    Nodes,
    Optics,
    LightAreas,
    FaceCones,
}

impl Section {
    /// All, in the order of the section table.
    pub const ALL: [Self; super::layout::SECTIONS] = [
        Self::Palette,
        Self::Shades,
        Self::Background,
        Self::Lights,
        Self::Materials,
        Self::Actors,
        Self::Meshes,
        Self::Meshlets,
        Self::Vertices,
        Self::Triangles,
        Self::FaceNormals,
        Self::Fine,
        Self::Viewports,
        Self::ViewportBackgrounds,
        Self::Tracks,
        Self::Keys,
        Self::Fog,
        Self::FogTable,
        Self::VertexColours,
        Self::Colours,
        Self::Output,
        Self::Looks,
        Self::Marks,
        Self::Edges,
        Self::MeshletEdges,
        Self::Coordinates,
        Self::Textures,
        Self::Texels,
        Self::Bases,
        Self::TextureShades,
        Self::RaySettings,
        Self::Shapes,
        Self::Nodes,
        Self::Optics,
        Self::LightAreas,
        Self::FaceCones,
    ];
}

/// A field of a record.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[expect(missing_docs, reason = "the names say it")]
pub enum Field {
    Count,
    Offset,
    Features,
    Width,
    Height,
    ColourFormat,
    Turntable,
    Projection,
    ViewAngle,
    Camera,
    ClippingRange,
    Intensity,
    Direction,
    Material,
    Mesh,
    Shade,
    Shading,
    Cull,
    Scale,
    Radius,
    Base,
    Shift,
    FirstMeshlet,
    FirstVertex,
    FirstTriangle,
    VertexIndex,
    PaletteIndex,
    FaceNormals,
    FaceCones,
    Fine,
    Sides,
    Background,
    Parent,
    Target,
    Quantity,
    FirstKey,
    Frame,
    Distance,
    VertexColours,
    Kind,
    Attenuation,
    Cone,
    Power,
    Coloured,
    Dither,
    PanelDithering,
    Samples,
    Eyes,
    PaletteCycle,
    Actor,
    Representation,
    Bias,
    Mark,
    Coordinates,
    Texture,
    Size,
    Texel,
    Opacity,
    Depth,
    FirstNode,
    Meshlet,
    Level,
    Error,
    Part,
    Index,
}

/// Why a blob was refused. Nothing of a refused blob is used.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SceneError {
    /// Fewer bytes than a header.
    TooShort {
        /// Bytes given.
        bytes: usize,
    },
    /// The bytes do not start at a multiple of four; see
    /// [`include_scene!`](crate::include_scene).
    Misaligned,
    /// The bytes do not start with `FXL1`: not a baked scene.
    NotAScene,
    /// Another version of the layout: bake the scene again.
    Version {
        /// The version found.
        found: u32,
    },
    /// The stated length is not the number of bytes given.
    Length {
        /// Bytes stated in the header.
        stated: u32,
        /// Bytes given.
        bytes: usize,
    },
    /// The bytes were changed after baking.
    Checksum {
        /// The sum stated in the header.
        stated: u32,
        /// The sum of the bytes given.
        found: u32,
    },
    /// The scene needs a part of the renderer that this program was built
    /// without.
    Feature {
        /// The Cargo feature of the crate `fixel` that has it.
        name: &'static str,
    },
    /// A field of the header is out of its range.
    Header {
        /// Which.
        field: Field,
        /// What it holds.
        value: i64,
    },
    /// A field of a record is out of its range.
    Record {
        /// In which section.
        section: Section,
        /// Which record, from 0.
        index: usize,
        /// Which field.
        field: Field,
        /// What it holds.
        value: i64,
    },
}

impl fmt::Display for SceneError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::TooShort { bytes } => {
                write!(f, "not a baked scene: {bytes} bytes, shorter than a header")
            }
            Self::Misaligned => {
                write!(f, "the scene must start at a multiple of 4 bytes in memory")
            }
            Self::NotAScene => write!(f, "not a baked scene: it does not start with FXL1"),
            Self::Version { found } => write!(
                f,
                "baked for version {found} of the layout, this reader knows version {}: bake it again",
                super::layout::VERSION
            ),
            Self::Length { stated, bytes } => {
                write!(
                    f,
                    "damaged: the header states {stated} bytes, there are {bytes}"
                )
            }
            Self::Checksum { stated, found } => {
                write!(
                    f,
                    "damaged: checksum {found:#010x}, the header states {stated:#010x}"
                )
            }
            Self::Feature { name } => write!(
                f,
                "the scene needs the feature `{name}`, which this program was built without: \
                 in Cargo.toml, fixel = {{ features = [\"{name}\"] }}"
            ),
            Self::Header { field, value } => {
                write!(f, "damaged: header: {field:?} is {value}, out of range")
            }
            Self::Record {
                section,
                index,
                field,
                value,
            } => write!(
                f,
                "damaged: {section:?}, record {index}: {field:?} is {value}, out of range"
            ),
        }
    }
}

impl core::error::Error for SceneError {}
