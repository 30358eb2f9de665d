//! The records of a blob: what each word means, in both directions. The baker
//! writes what is read here, so a format stands in one place.

/// A record of fixed size, made of little-endian 32-bit words.
pub trait Record: Sized {
    /// The words.
    type Words;
    /// From the words of a blob that has been checked; a value outside its
    /// range is taken to the nearest sensible one.
    fn from_words(words: &Self::Words) -> Self;
    /// As written by the baker.
    fn to_words(&self) -> Self::Words;
}

pub(super) fn i(word: u32) -> i32 {
    i32::from_le_bytes(word.to_ne_bytes())
}

pub(super) fn u(word: u32) -> u32 {
    u32::from_le(word)
}

pub(super) fn w(value: i32) -> u32 {
    (value as u32).to_le()
}

/// The sum of the blob's words after the first four: FNV-1a over 32-bit words.
/// Any change within one word changes it.
pub fn checksum(words: &[u32]) -> u32 {
    words.iter().fold(0x811c_9dc5, |hash: u32, word| {
        (hash ^ u32::from_le(*word)).wrapping_mul(0x0100_0193)
    })
}

/// What the panel can show.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[expect(missing_docs, reason = "the names say it")]
pub enum ColourFormat {
    Rgb888,
    Rgb565,
    Rgb444,
    Gray8,
    Gray4,
    Gray2,
    Mono,
}

impl ColourFormat {
    /// All, in the order of their codes.
    pub const ALL: [Self; 7] = [
        Self::Rgb888,
        Self::Rgb565,
        Self::Rgb444,
        Self::Gray8,
        Self::Gray4,
        Self::Gray2,
        Self::Mono,
    ];
}

/// How the levels of a panel with few of them are mixed: see
/// [`display`](crate::display).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PanelDithering {
    /// The nearest level.
    None,
    /// A pattern of 4 by 4 pixels.
    Bayer4,
    /// A pattern of 8 by 8 pixels.
    Bayer8,
    /// 32 by 32 pixels without a visible pattern.
    BlueNoise,
    /// Error diffusion.
    FloydSteinberg,
}

impl PanelDithering {
    /// All, in the order of their codes.
    pub const ALL: [Self; 5] = [
        Self::None,
        Self::Bayer4,
        Self::Bayer8,
        Self::BlueNoise,
        Self::FloydSteinberg,
    ];
}

/// A mesh placed in its parent's space, or in the world. A grid point `q` of the
/// mesh goes to `position + R (offset + q * step)`, with `R` from `orientation`;
/// then, if there is a parent, to `parent's position + parent's R that`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Actor {
    /// Which mesh.
    pub mesh: u16,
    /// Which material.
    pub material: u16,
    /// Where its pivot is, raw world bits.
    pub position: [i32; 3],
    /// Turned about x, y, z, in 2^-32 turns; applied in VTK's order y, x, z.
    pub orientation: [u32; 3],
    /// From the pivot to the centre of the mesh's grid, before turning, raw
    /// world bits.
    pub offset: [i32; 3],
    /// World units a grid step: `step_mantissa * 2^(step_exponent - 31)`,
    /// mantissa in 2^31..2^32.
    pub step_mantissa: u32,
    /// See `step_mantissa`; within [`STEP_EXPONENTS`](super::layout::STEP_EXPONENTS).
    pub step_exponent: i32,
    /// The actor that it moves with. No chain of parents is longer than
    /// [`PARENTS`](super::layout::PARENTS).
    pub parent: Option<u16>,
    /// A turntable leaves it where it is.
    pub still: bool,
    /// A further part of its parent, in another material: where it shows, the parent
    /// does.
    pub part: bool,
}

impl Record for Actor {
    type Words = [u32; 13];

    fn from_words(words: &Self::Words) -> Self {
        let [
            ids,
            p0,
            p1,
            p2,
            a0,
            a1,
            a2,
            o0,
            o1,
            o2,
            mantissa,
            exponent,
            parent,
        ] = *words;
        Self {
            mesh: u(ids) as u16,
            material: (u(ids) >> 16) as u16,
            position: [i(p0), i(p1), i(p2)],
            orientation: [u(a0), u(a1), u(a2)],
            offset: [i(o0), i(o1), i(o2)],
            step_mantissa: u(mantissa),
            step_exponent: i(exponent),
            // 1 more than its index, so that 0 is none.
            parent: (u(parent) as u16).checked_sub(1),
            still: u(parent) >> 16 & 1 != 0,
            part: u(parent) >> 17 & 1 != 0,
        }
    }

    fn to_words(&self) -> Self::Words {
        let [p0, p1, p2] = self.position.map(w);
        let [a0, a1, a2] = self.orientation.map(u32::to_le);
        let [o0, o1, o2] = self.offset.map(w);
        let ids = u32::from(self.mesh) | u32::from(self.material) << 16;
        let parent = self.parent.map_or(0, |p| u32::from(p) + 1);
        let flags = u32::from(self.still) | u32::from(self.part) << 1;
        let last = parent | flags << 16;
        [
            ids.to_le(),
            p0,
            p1,
            p2,
            a0,
            a1,
            a2,
            o0,
            o1,
            o2,
            self.step_mantissa.to_le(),
            w(self.step_exponent),
            last.to_le(),
        ]
    }
}

/// A mesh: a run of meshlets.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Mesh {
    /// Its first meshlet.
    pub first_meshlet: u32,
    /// How many.
    pub meshlets: u32,
    /// A sphere about the grid's centre holds all vertices; grid steps.
    pub radius: u32,
    /// Whether its triangles have face normals. Meshes that do come first, so
    /// that a triangle and its face normal have the same number.
    pub face_normals: bool,
    /// A small mesh may give its vertices in whole grid steps, below the shifts of
    /// its meshlets: the place of a vertex's low bits in the scene's list of them,
    /// less the vertex's own place in the list of vertices (modulo 2^32).
    pub fine: Option<u32>,
    /// A mesh may have vertex colours: the place of a vertex's colour in the scene's
    /// list of them, less the vertex's own place in the list of vertices (modulo
    /// 2^32).
    pub colours: Option<u32>,
    /// A mesh may have texture coordinates.
    pub coordinates: Option<Coordinates>,
    /// Meshes of fewer triangles that may stand in for this one from afar, finer ones first:
    /// the number of the first in the scene's list, and how many. They are in the same grid,
    /// and have all that this one has.
    pub levels: (u16, u8),
    /// As such a level: how far its surface is off the mesh's, at most; grid steps.
    pub error: u32,
}

/// The texture coordinates of a mesh: a vertex's, as it is stored, plus `origin`, in
/// units of `2^-exponent` of the picture's width and height, from its top left corner.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Coordinates {
    /// The place of a vertex's coordinates in the scene's list of them, less the
    /// vertex's own place in the list of vertices (modulo 2^32).
    pub offset: u32,
    /// What is added to u and v.
    pub origin: [i32; 2],
    /// See above; 0..=24.
    pub exponent: u8,
}

impl Record for Mesh {
    type Words = [u32; 10];

    fn from_words(words: &Self::Words) -> Self {
        let [
            first_meshlet,
            meshlets,
            radius,
            flags,
            fine,
            colours,
            uv,
            u0,
            v0,
            level,
        ] = words.map(u);
        Self {
            first_meshlet,
            meshlets,
            radius,
            face_normals: flags & 1 != 0,
            fine: (flags & 2 != 0).then_some(fine),
            colours: (flags & 4 != 0).then_some(colours),
            coordinates: (flags & 8 != 0).then_some(Coordinates {
                offset: uv,
                origin: [u0 as i32, v0 as i32],
                exponent: (flags >> 8) as u8,
            }),
            levels: ((flags >> 16) as u16, (level >> 24) as u8),
            error: level & 0xff_ffff,
        }
    }

    fn to_words(&self) -> Self::Words {
        let flags = u32::from(self.face_normals)
            | u32::from(self.fine.is_some()) << 1
            | u32::from(self.colours.is_some()) << 2
            | self
                .coordinates
                .map_or(0, |c| 8 | u32::from(c.exponent) << 8);
        let (uv, [u0, v0]) = self
            .coordinates
            .map_or((0, [0; 2]), |c| (c.offset, c.origin));
        let (first_level, levels) = self.levels;
        let flags = flags | u32::from(first_level) << 16;
        let words = [self.first_meshlet, self.meshlets, self.radius, flags];
        let [first, meshlets, radius, flags] = words.map(u32::to_le);
        let level = self.error | u32::from(levels) << 24;
        [
            first,
            meshlets,
            radius,
            flags,
            self.fine.unwrap_or(0).to_le(),
            self.colours.unwrap_or(0).to_le(),
            uv.to_le(),
            w(u0),
            w(v0),
            level.to_le(),
        ]
    }
}

impl Meshlet {
    /// Radius of its bounding sphere in grid steps.
    pub fn radius_steps(&self) -> i32 {
        let largest = self.shifts.iter().fold(0, |m, s| m.max(*s));
        i32::from(self.radius) << largest.min(14)
    }

    /// Grid steps from its base to a vertex, with the low bits that one of a fine mesh has.
    pub(crate) fn steps(&self, vertex: [i16; 4], fine: [u8; 4]) -> [i32; 3] {
        let [x, y, z, _] = vertex.map(|c| i32::from(i16::from_le(c)));
        let ([sx, sy, sz], [fx, fy, fz, _]) = (self.shifts, fine.map(i32::from));
        let step = |c: i32, shift: u8, low| c.wrapping_shl(shift.into()).wrapping_add(low);
        [step(x, sx, fx), step(y, sy, fy), step(z, sz, fz)]
    }
}

/// A small cluster of triangles: the unit that is culled, transformed and lit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Meshlet {
    /// Centre of its box, grid steps from the grid's centre. Vertices are
    /// 16-bit distances from here, in units of `2^shifts` steps.
    pub base: [i32; 3],
    /// For each axis, the power of two that its vertices are multiples of:
    /// 0..=31. So the grid can be finer than 16 bits hold across the mesh.
    pub shifts: [u8; 3],
    /// A sphere about the base holds its vertices; in units of 2 to the largest
    /// shift.
    pub radius: u16,
    /// Vertices, 1..=64.
    pub vertices: u8,
    /// Triangles, 0..=128: of lines and points there are none.
    pub triangles: u8,
    /// Mean direction of its faces, 127 is 1.
    pub cone_axis: [i8; 3],
    /// The meshlet shows only back faces to an eye from which
    /// `dot(base - eye, axis) >= cutoff * |base - eye| + radius`; 127 is 1
    /// and means never.
    pub cone_cutoff: i8,
    /// Its first vertex in the scene's list.
    pub first_vertex: u32,
    /// Its first triangle in the scene's list.
    pub first_triangle: u32,
}

impl Record for Meshlet {
    type Words = [u32; 7];

    fn from_words(&[b0, b1, b2, size, cone, first_vertex, first_triangle]: &Self::Words) -> Self {
        let [low, high, vertices, triangles] = size.to_ne_bytes();
        let [ax, ay, az, cutoff] = cone.to_ne_bytes().map(|b| b as i8);
        let places = [i(b0), i(b1), i(b2)];
        Self {
            base: places.map(|word| word >> 5),
            shifts: places.map(|word| (word & 31) as u8),
            radius: u16::from_le_bytes([low, high]),
            vertices,
            triangles,
            cone_axis: [ax, ay, az],
            cone_cutoff: cutoff,
            first_vertex: u(first_vertex),
            first_triangle: u(first_triangle),
        }
    }

    fn to_words(&self) -> Self::Words {
        let [low, high] = self.radius.to_le_bytes();
        let [ax, ay, az] = self.cone_axis.map(|c| c as u8);
        let ([b0, b1, b2], [s0, s1, s2]) = (self.base, self.shifts.map(i32::from));
        [
            w((b0 << 5) | s0),
            w((b1 << 5) | s1),
            w((b2 << 5) | s2),
            u32::from_ne_bytes([low, high, self.vertices, self.triangles]),
            u32::from_ne_bytes([ax, ay, az, self.cone_cutoff as u8]),
            self.first_vertex.to_le(),
            self.first_triangle.to_le(),
        ]
    }
}
