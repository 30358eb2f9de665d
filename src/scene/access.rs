//! Accessors that cannot fail. Indices were checked when the scene was parsed or baked; what
//! the rest of the core takes to be in range is brought into it here all the same, for
//! [`Scene::embedded`].

use super::viewport::Gradient;
use super::{
    Actor, ColourFormat, Dither, DitherPattern, Header, Light, Material, Mesh, Meshlet,
    PanelDithering, Record, Scene, Texture, layout,
};

impl<'a> Scene<'a> {
    /// Width of the picture in pixels; a band needs [`Scene::frame_width`].
    pub fn width(&self) -> u16 {
        self.header.width
    }

    /// Height of the picture in pixels; a frame has [`Scene::frame_height`] rows.
    pub fn height(&self) -> u16 {
        self.header.height
    }

    /// The header's words.
    pub fn header(&self) -> &Header {
        &self.header
    }

    /// World units are scene units times 2 to this power.
    pub fn world_exponent(&self) -> i8 {
        self.header.world_exponent
    }

    /// What the panel can show.
    pub fn colour_format(&self) -> ColourFormat {
        let code = usize::from(self.header.colour_format);
        ColourFormat::ALL
            .get(code)
            .copied()
            .unwrap_or(ColourFormat::Rgb888)
    }

    /// How the panel's levels are mixed, if it is grey and has few of them.
    pub fn panel_dithering(&self) -> PanelDithering {
        let code = usize::from(self.header.panel_dithering);
        PanelDithering::ALL
            .get(code)
            .copied()
            .unwrap_or(PanelDithering::None)
    }

    /// How colours between palette entries are shown.
    pub fn dither(&self) -> Dither {
        let code = usize::from(self.header.dither_pattern);
        Dither {
            pattern: DitherPattern::ALL
                .get(code)
                .copied()
                .unwrap_or(DitherPattern::None),
            spread: self.header.dither_spread,
        }
    }

    /// Red, green, blue of each palette entry, 2..=256 of them.
    pub fn palette(&self) -> &'a [[u8; 3]] {
        self.palette
    }

    /// Whether it is baked for bands without a palette: all materials go by colour, and
    /// the palette has the backgrounds' colours alone.
    pub fn is_direct(&self) -> bool {
        self.header.direct
    }

    /// Palette index of the background in screen row `y` of `height`.
    pub fn background(&self, y: u16, height: u16) -> u8 {
        Gradient(self.background).at(y, height)
    }

    /// Palette index by light level, for one material.
    #[inline(never)]
    pub fn shade(&self, material: &Material) -> &'a [u8; 256] {
        const BLACK: &[u8; 256] = &[0; 256];
        self.shades
            .get(usize::from(material.shade))
            .unwrap_or(BLACK)
    }

    /// Palette index by colour: 4 bits each of red (highest), green and blue.
    pub fn colours(&self) -> &'a [u8; layout::COLOURS] {
        const BLACK: &[u8; layout::COLOURS] = &[0; layout::COLOURS];
        self.colours.first().unwrap_or(BLACK)
    }

    /// Lights that have a direction or a place.
    pub fn lights(&self) -> impl ExactSizeIterator<Item = Light> + use<'a> {
        self.lights.iter().map(Light::from_words)
    }

    /// Number of actors.
    pub fn actor_count(&self) -> u16 {
        self.actors.len() as u16
    }

    /// An actor; an index out of range gives an actor without meshlets.
    #[inline(never)]
    pub fn actor(&self, index: u16) -> Actor {
        let mut actor = read(self.actors, usize::from(index)).unwrap_or(Actor {
            mesh: u16::MAX,
            material: 0,
            position: [0; 3],
            orientation: [0; 3],
            offset: [0; 3],
            step_mantissa: 1 << 31,
            step_exponent: 0,
            parent: None,
            still: false,
            part: false,
        });
        let (least, most) = layout::STEP_EXPONENTS;
        actor.step_mantissa = actor.step_mantissa.max(1 << 31);
        actor.step_exponent = actor.step_exponent.clamp(least, most);
        actor
    }

    /// What an actor is a part of: its parent if it is a further part of that, else
    /// itself.
    pub fn whole(&self, index: u16) -> u16 {
        let actor = self.actor(index);
        let parent = actor.parent.filter(|_| actor.part);
        parent.unwrap_or(index)
    }

    /// Number of materials.
    pub fn material_count(&self) -> u16 {
        self.materials.len() as u16
    }

    /// A material; an index out of range gives a plain one.
    #[inline(never)]
    pub fn material(&self, index: u16) -> Material {
        read(self.materials, usize::from(index)).unwrap_or(Material::PLAIN)
    }

    /// Number of meshes.
    pub fn mesh_count(&self) -> u16 {
        self.meshes.len() as u16
    }

    /// A mesh; an index out of range gives an empty one. None has more meshlets than there are.
    #[inline(never)]
    pub fn mesh(&self, index: u16) -> Mesh {
        let mut mesh = read(self.meshes, usize::from(index)).unwrap_or(Mesh {
            first_meshlet: 0,
            meshlets: 0,
            radius: layout::LEAST_RADIUS,
            face_normals: false,
            fine: None,
            colours: None,
            coordinates: None,
            levels: (0, 0),
            error: 0,
        });
        mesh.meshlets = mesh.meshlets.min(self.meshlets.len() as u32);
        mesh
    }

    /// Whether some material goes by colour where it may be lit at vertices.
    pub(crate) fn has_colours_at_vertices(&self) -> bool {
        let mut materials = self.materials.iter().map(Material::from_words);
        materials.any(|material| material.coloured)
    }

    /// Number of meshlets of all meshes.
    pub fn meshlet_count(&self) -> usize {
        self.meshlets.len()
    }

    /// Number of triangles of all meshes.
    pub fn triangle_count(&self) -> usize {
        self.triangles.len()
    }

    /// Number of vertices of all meshes.
    pub fn vertex_count(&self) -> usize {
        self.vertices.len()
    }

    /// Bytes that the meshes take: meshlets, vertices, triangles, face normals.
    pub fn mesh_bytes(&self) -> usize {
        [
            size_of_val(self.meshlets),
            size_of_val(self.vertices),
            size_of_val(self.triangles),
            size_of_val(self.face_normals),
            size_of_val(self.fine),
            size_of_val(self.vertex_colours),
            size_of_val(self.edges),
            size_of_val(self.meshlet_edges),
            size_of_val(self.coordinates),
            size_of_val(self.face_cones),
        ]
        .iter()
        .sum()
    }

    /// A meshlet by its place in the scene's list.
    #[inline(never)]
    pub fn meshlet(&self, index: u32) -> Option<Meshlet> {
        read(self.meshlets, index as usize)
    }

    /// A meshlet's vertices: distance from its base in grid steps, and the
    /// octahedral normal's two bytes.
    pub fn meshlet_vertices(&self, meshlet: &Meshlet) -> &'a [[i16; 4]] {
        run(
            self.vertices,
            meshlet.first_vertex as usize,
            meshlet.vertices,
        )
    }

    /// The low bits of a meshlet's vertices, below its shifts, for x, y and z, and
    /// the low bits of its normals (see
    /// `view::ModelLights::fine_level`); empty if its mesh is not fine.
    pub fn meshlet_fine(&self, meshlet: &Meshlet, mesh: &Mesh) -> &'a [[u8; 4]] {
        let Some(offset) = mesh.fine else {
            return &[];
        };
        run(
            self.fine,
            meshlet.first_vertex.wrapping_add(offset) as usize,
            meshlet.vertices,
        )
    }

    /// A texture; an index out of range gives none.
    pub fn texture(&self, index: u8) -> Option<Texture> {
        let mut texture: Texture = read(self.textures, usize::from(index))?;
        texture.size = texture.size.map(|size| size.min(layout::TEXTURE_SIZE));
        Some(texture)
    }

    /// Number of textures.
    pub fn texture_count(&self) -> usize {
        self.textures.len()
    }

    /// The texels of all textures: each the number of a base colour, or
    /// [`NO_TEXEL`](super::NO_TEXEL).
    pub fn texels(&self) -> &'a [u8] {
        self.texels
    }

    /// Red, green, blue of the base colours of all textures.
    pub fn bases(&self) -> &'a [[u8; 3]] {
        self.bases
    }

    /// Palette index by level (64 of them, the level's highest 6 bits) and base colour,
    /// for one material that has a texture and goes by level.
    pub fn texture_shades(&self, material: &Material) -> &'a [u8; layout::TEXTURE_SHADES] {
        const BLACK: &[u8; layout::TEXTURE_SHADES] = &[0; layout::TEXTURE_SHADES];
        let shade = usize::from(material.shade);
        self.texture_shades.get(shade).unwrap_or(BLACK)
    }

    /// Texture coordinates of a meshlet's vertices, little-endian; see
    /// [`Coordinates`](super::Coordinates); empty if its mesh has none.
    pub fn meshlet_coordinates(&self, meshlet: &Meshlet, mesh: &Mesh) -> &'a [[i16; 2]] {
        let Some(coordinates) = mesh.coordinates else {
            return &[];
        };
        let first = meshlet.first_vertex.wrapping_add(coordinates.offset);
        run(self.coordinates, first as usize, meshlet.vertices)
    }

    /// Red, green and blue of a meshlet's vertices, and a byte of 0; empty if its
    /// mesh has none.
    pub fn meshlet_colours(&self, meshlet: &Meshlet, mesh: &Mesh) -> &'a [[u8; 4]] {
        let Some(offset) = mesh.colours else {
            return &[];
        };
        run(
            self.vertex_colours,
            meshlet.first_vertex.wrapping_add(offset) as usize,
            meshlet.vertices,
        )
    }

    /// A meshlet's triangles: indices into its vertices.
    pub fn meshlet_triangles(&self, meshlet: &Meshlet) -> &'a [[u8; 3]] {
        run(
            self.triangles,
            meshlet.first_triangle as usize,
            meshlet.triangles,
        )
    }

    /// The cones of a meshlet's triangles, one for each
    /// [`CONE_TRIANGLES`](layout::CONE_TRIANGLES) of them; empty if the scene has none. See
    /// [`FaceCone::from_bytes`](super::FaceCone::from_bytes).
    pub fn meshlet_cones(&self, number: u32, meshlet: &Meshlet) -> &'a [[u8; 3]] {
        let (first, count) = cones(number, meshlet);
        run(self.face_cones, first, count)
    }

    /// A meshlet's face normals, as
    /// `view::ModelLights::face_level` takes them,
    /// little-endian; empty if its mesh has none.
    pub fn meshlet_face_normals(&self, meshlet: &Meshlet, mesh: &Mesh) -> &'a [u32] {
        if !mesh.face_normals {
            return &[];
        }
        run(
            self.face_normals,
            meshlet.first_triangle as usize,
            meshlet.triangles,
        )
    }
}

/// The place of a meshlet's first cone in the scene's list, and how many it has. Each meshlet
/// begins where none before it can end, so that no record has to say where.
pub(super) fn cones(number: u32, meshlet: &Meshlet) -> (usize, u8) {
    let first = meshlet.first_triangle as usize / layout::CONE_TRIANGLES;
    let count = meshlet.triangles.div_ceil(layout::CONE_TRIANGLES as u8);
    (first.saturating_add(number as usize), count)
}

fn read<R: Record>(records: &[R::Words], index: usize) -> Option<R> {
    records.get(index).map(R::from_words)
}

fn run<T>(all: &[T], first: usize, count: u8) -> &[T] {
    all.get(first..first.saturating_add(usize::from(count)))
        .unwrap_or_default()
}
