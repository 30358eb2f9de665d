//! Bytes become a scene: everything is checked here, once, so that drawing
//! never has to.

// Bytes from anywhere come in: whatever they say, nothing overflows.
#![deny(clippy::arithmetic_side_effects)]

use bytemuck::{AnyBitPattern, try_cast_slice};

use super::layout;
use super::{
    Actor, ColourFormat, DitherPattern, Field, Fog, Header, Key, Light, LightArea, Look, Material,
    Mesh, Meshlet, Node, Optics, Output, PanelDithering, RaySettings, Record, SceneError, Section,
    Shape, Texture, Track, Viewport, checksum,
};

/// A checked scene, read in place from flash.
#[derive(Clone, Copy, Debug)]
pub struct Scene<'a> {
    pub(crate) header: Header,
    pub(crate) palette: &'a [[u8; 3]],
    pub(crate) shades: &'a [[u8; 256]],
    pub(crate) background: &'a [u8],
    pub(crate) lights: &'a [<Light as Record>::Words],
    pub(crate) materials: &'a [<Material as Record>::Words],
    pub(crate) actors: &'a [<Actor as Record>::Words],
    pub(crate) meshes: &'a [<Mesh as Record>::Words],
    pub(crate) meshlets: &'a [<Meshlet as Record>::Words],
    pub(crate) vertices: &'a [[i16; 4]],
    pub(crate) triangles: &'a [[u8; 3]],
    pub(crate) face_normals: &'a [u32],
    pub(crate) fine: &'a [[u8; 4]],
    pub(crate) viewports: &'a [<Viewport as Record>::Words],
    pub(crate) viewport_backgrounds: &'a [u8],
    pub(crate) tracks: &'a [<Track as Record>::Words],
    pub(crate) keys: &'a [<Key as Record>::Words],
    pub(crate) fog: &'a [<Fog as Record>::Words],
    pub(crate) fog_table: &'a [[u8; 256]],
    pub(crate) vertex_colours: &'a [[u8; 4]],
    pub(crate) colours: &'a [[u8; layout::COLOURS]],
    pub(crate) output: &'a [<Output as Record>::Words],
    pub(crate) looks: &'a [<Look as Record>::Words],
    pub(crate) marks: &'a [u8],
    pub(crate) edges: &'a [[u8; 2]],
    pub(crate) meshlet_edges: &'a [u32],
    pub(crate) coordinates: &'a [[i16; 2]],
    pub(crate) textures: &'a [<Texture as Record>::Words],
    pub(crate) texels: &'a [u8],
    pub(crate) bases: &'a [[u8; 3]],
    pub(crate) texture_shades: &'a [[u8; layout::TEXTURE_SHADES]],
    pub(crate) ray_settings: &'a [<RaySettings as Record>::Words],
    pub(crate) shapes: &'a [<Shape as Record>::Words],
    pub(crate) nodes: &'a [<Node as Record>::Words],
    pub(crate) optics: &'a [<Optics as Record>::Words],
    pub(crate) light_areas: &'a [<LightArea as Record>::Words],
    pub(crate) face_cones: &'a [[u8; 3]],
}

impl<'a> Scene<'a> {
    /// Checks a baked scene from wherever it comes: every number of it. The bytes must start
    /// at a multiple of 4. For what the program's own build has baked, [`Scene::embedded`].
    ///
    /// # Errors
    /// Says what is wrong and where; see [`SceneError`].
    #[inline(never)]
    pub fn parse(bytes: &'a [u8]) -> Result<Self, SceneError> {
        let scene = Self::intact(bytes)?;
        check_header(&scene.header)?;
        scene.check_colours()?;
        scene.check_lights()?;
        scene.check_textures()?;
        scene.check_materials()?;
        scene.check_actors()?;
        scene.check_looks()?;
        scene.check_meshes()?;
        scene.check_viewports()?;
        scene.check_tracks()?;
        scene.check_fog()?;
        scene.check_output()?;
        scene.check_rays()?;
        Ok(scene)
    }

    /// A scene that the program's own build has baked, such as
    /// [`include_scene!`](crate::include_scene) embeds. The bytes must start at a multiple of 4.
    ///
    /// The baker has checked every number by [`Scene::parse`], so firmware need not link those
    /// checks again, 5 KB on a Cortex-M0+. Here it is made sure that the bytes are those that it
    /// wrote (version, length, checksum), that the program has what they need, and that rays'
    /// hierarchies end. Bytes that pass although no baker wrote them are drawn as nonsense: no
    /// panic, no read beyond them, and every frame comes to an end.
    ///
    /// # Errors
    /// Says what is wrong; see [`SceneError`].
    #[inline(never)]
    pub fn embedded(bytes: &'a [u8]) -> Result<Self, SceneError> {
        let scene = Self::intact(bytes)?;
        scene.check_rays()?;
        Ok(scene)
    }

    /// As it was baked, for a program that has what it needs.
    fn intact(bytes: &'a [u8]) -> Result<Self, SceneError> {
        if bytes.len() < layout::PREFIX_BYTES {
            return Err(SceneError::TooShort { bytes: bytes.len() });
        }
        let whole_words = bytes.get(..bytes.len() & !3).unwrap_or_default();
        let words: &[u32] = try_cast_slice(whole_words).map_err(|_| SceneError::Misaligned)?;
        let (first, rest) = words
            .split_first_chunk::<{ layout::HEADER_WORDS }>()
            .ok_or(SceneError::TooShort { bytes: bytes.len() })?;
        let [magic, version, ..] = *first;
        if u32::from_le(magic) != layout::MAGIC {
            return Err(SceneError::NotAScene);
        }
        if u32::from_le(version) != layout::VERSION {
            return Err(SceneError::Version {
                found: u32::from_le(version),
            });
        }
        let header = Header::from_words(first);
        if header.length as usize != bytes.len() || !bytes.len().is_multiple_of(4) {
            return Err(SceneError::Length {
                stated: header.length,
                bytes: bytes.len(),
            });
        }
        let found = checksum(words.get(layout::CHECKED_FROM / 4..).unwrap_or_default());
        if found != header.checksum {
            return Err(SceneError::Checksum {
                stated: header.checksum,
                found,
            });
        }
        for (field, size) in [(Field::Width, header.width), (Field::Height, header.height)] {
            check_header_field(field, size.into(), 1, 2048)?;
        }

        let mut parts: [&[u8]; layout::SECTIONS] = [&[]; layout::SECTIONS];
        find_sections(bytes, rest, &mut parts)?;
        let scene = Self::of(header, &parts);
        scene.check_features(&parts)?;
        Ok(scene)
    }

    /// Whether the program was built with what the scene uses.
    fn check_features(&self, parts: &[&[u8]; layout::SECTIONS]) -> Result<(), SceneError> {
        let of = |name, there: bool, used: bool| {
            if used && !there {
                Err(SceneError::Feature { name })
            } else {
                Ok(())
            }
        };
        let some = |section: Section| parts.get(section as usize).is_some_and(|p| !p.is_empty());
        of("lod", cfg!(feature = "lod"), self.header.level_error != 0)?;
        of(
            "texture",
            cfg!(feature = "texture"),
            some(Section::Textures),
        )?;
        of("lines", cfg!(feature = "lines"), some(Section::Looks))?;
        let viewports = some(Section::Viewports) || some(Section::Output);
        of("viewports", cfg!(feature = "viewports"), viewports)?;
        of(
            "animation",
            cfg!(feature = "animation"),
            some(Section::Tracks),
        )?;
        of("fog", cfg!(feature = "fog"), some(Section::Fog))?;
        for material in self.materials.iter().map(Material::from_words) {
            let light = material.full || material.coloured;
            of("light", cfg!(feature = "light"), light)?;
            let smooth = material.shading != super::Shading::Flat;
            of("gouraud", cfg!(feature = "gouraud"), smooth)?;
            let shows_through = material.transparency != super::Transparency::Opaque;
            of(
                "transparency",
                cfg!(feature = "transparency"),
                shows_through,
            )?;
        }
        Ok(())
    }

    /// Palette entries in use and the indices that point to them.
    fn check_colours(&self) -> Result<(), SceneError> {
        let colours = self.palette.len();
        count(Section::Palette, colours, 2, 256)?;
        let (first, cycled) = self.header.cycle;
        let end = usize::from(first).saturating_add(cycled.into());
        if end > colours || (cycled != 0 && self.header.cycle_frames == 0) {
            return Err(SceneError::Header {
                field: Field::PaletteCycle,
                value: end as i64,
            });
        }
        count(Section::Background, self.background.len(), 1, 65535)?;
        let index_ok = |section, i, value: &u8| {
            range(
                section,
                i,
                Field::PaletteIndex,
                i64::from(*value),
                0,
                last(colours, 1),
            )
        };
        for (i, index) in self.background.iter().enumerate() {
            index_ok(Section::Background, i, index)?;
        }
        for (i, index) in self.shades.as_flattened().iter().enumerate() {
            index_ok(Section::Shades, i / 256, index)?;
        }
        count(Section::Colours, self.colours.len(), 0, 1)?;
        for (i, index) in self.colours.as_flattened().iter().enumerate() {
            index_ok(Section::Colours, i, index)?;
        }
        Ok(())
    }

    fn check_actors(&self) -> Result<(), SceneError> {
        count(Section::Actors, self.actors.len(), 0, 65535)?;
        for (i, words) in self.actors.iter().enumerate() {
            let actor = Actor::from_words(words);
            let (meshes, materials) = (self.meshes.len(), self.materials.len());
            range(
                Section::Actors,
                i,
                Field::Mesh,
                actor.mesh.into(),
                0,
                last(meshes, 1),
            )?;
            range(
                Section::Actors,
                i,
                Field::Material,
                actor.material.into(),
                0,
                last(materials, 1),
            )?;
            let mantissa = actor.step_mantissa.into();
            range(
                Section::Actors,
                i,
                Field::Scale,
                mantissa,
                1 << 31,
                (1 << 32) - 1,
            )?;
            range(
                Section::Actors,
                i,
                Field::Scale,
                actor.step_exponent.into(),
                layout::STEP_EXPONENTS.0.into(),
                layout::STEP_EXPONENTS.1.into(),
            )?;
            self.check_parents(i, &actor)?;
            let (mesh, material) = (self.mesh(actor.mesh), self.material(actor.material));
            if material.texture.is_some() {
                let has = mesh.coordinates.is_some().into();
                range(Section::Actors, i, Field::Coordinates, has, 1, 1)?;
            }
            if material.shading == super::Shading::Flat {
                let has = i64::from(mesh.face_normals);
                range(Section::Actors, i, Field::FaceNormals, has, 1, 1)?;
            }
        }
        Ok(())
    }

    /// Every chain of parents ends.
    fn check_parents(&self, i: usize, actor: &Actor) -> Result<(), SceneError> {
        let s = Section::Actors;
        let last = last(self.actors.len(), 1);
        let mut above = actor.parent;
        for _ in 0..layout::PARENTS {
            let Some(parent) = above else { return Ok(()) };
            range(s, i, Field::Parent, parent.into(), 0, last)?;
            above = self.actor(parent).parent;
        }
        match above {
            Some(parent) => range(s, i, Field::Parent, parent.into(), -1, -1),
            None => Ok(()),
        }
    }
}

/// Lists the fields of [`Scene`] that are sections, in the order of the table: what is done
/// with each is there once, not once for each kind of record. What only a feature reads is
/// left empty without it.
macro_rules! section_fields {
    ($($field:ident $($feature:literal)?),*) => {
        /// Size and alignment of each section's records.
        const RECORDS: [[usize; 2]; layout::SECTIONS] =
            [$(size_and_alignment(|scene| scene.$field)),*];

        impl<'a> Scene<'a> {
            fn of(header: Header, [$($field),*]: &[&'a [u8]; layout::SECTIONS]) -> Self {
                Self {
                    header,
                    $($field: if true $(&& cfg!(feature = $feature))? {
                        records($field)
                    } else {
                        &[]
                    }),*
                }
            }
        }
    };
}

section_fields!(
    palette,
    shades,
    background,
    lights,
    materials,
    actors,
    meshes,
    meshlets,
    vertices,
    triangles,
    face_normals,
    fine,
    viewports "viewports",
    viewport_backgrounds "viewports",
    tracks "animation",
    keys "animation",
    fog "fog",
    fog_table "fog",
    vertex_colours,
    colours,
    output "viewports",
    looks "lines",
    marks "lines",
    edges "lines",
    meshlet_edges "lines",
    coordinates "texture",
    textures "texture",
    texels "texture",
    bases "texture",
    texture_shades "texture",
    ray_settings "ray",
    shapes "ray",
    nodes "ray",
    optics "ray",
    light_areas "ray",
    face_cones
);

const fn size_and_alignment<T>(_: fn(&Scene<'static>) -> &'static [T]) -> [usize; 2] {
    [size_of::<T>(), align_of::<T>()]
}

/// A section's bytes as records, whose size and alignment it has.
#[inline(never)]
fn records<T: AnyBitPattern>(bytes: &[u8]) -> &[T] {
    try_cast_slice(bytes).unwrap_or_default()
}

/// Finds the bytes of each section.
#[inline(never)]
fn find_sections<'a>(
    bytes: &'a [u8],
    table: &[u32],
    sections: &mut [&'a [u8]; layout::SECTIONS],
) -> Result<(), SceneError> {
    let (entries, _) = table.as_chunks::<2>();
    if entries.len() < sections.len() {
        return Err(SceneError::TooShort { bytes: bytes.len() });
    }
    let whose = Section::ALL.iter().zip(RECORDS);
    for ((slot, entry), (section, [size, align])) in sections.iter_mut().zip(entries).zip(whose) {
        let [offset, count] = entry.map(|word| u32::from_le(word) as usize);
        let outside = |field, value: usize| SceneError::Record {
            section: *section,
            index: 0,
            field,
            value: value as i64,
        };
        let size = count
            .checked_mul(size)
            .ok_or(outside(Field::Count, count))?;
        if offset < layout::PREFIX_BYTES {
            return Err(outside(Field::Offset, offset));
        }
        let part = bytes.get(offset..).ok_or(outside(Field::Offset, offset))?;
        let part = part.get(..size).ok_or(outside(Field::Count, count))?;
        // A power of two.
        if part.as_ptr().addr() & align.wrapping_sub(1) != 0 {
            return Err(outside(Field::Offset, offset));
        }
        *slot = part;
    }
    Ok(())
}

fn check_header_field(field: Field, value: i64, least: i64, most: i64) -> Result<(), SceneError> {
    if (least..=most).contains(&value) {
        Ok(())
    } else {
        Err(SceneError::Header { field, value })
    }
}

fn check_header(header: &Header) -> Result<(), SceneError> {
    let check = check_header_field;
    let formats = ColourFormat::ALL.len();
    check(
        Field::ColourFormat,
        header.colour_format.into(),
        0,
        last(formats, 1),
    )?;
    let ways = PanelDithering::ALL.len();
    let way = header.panel_dithering.into();
    check(Field::PanelDithering, way, 0, last(ways, 1))?;
    let patterns = DitherPattern::ALL.len();
    let (pattern, spread) = (header.dither_pattern.into(), header.dither_spread.into());
    check(Field::Dither, pattern, 0, last(patterns, 1))?;
    check(Field::Dither, spread, 0, 128 << 6)?;
    match header.camera.out_of_range() {
        Some((field, value)) => Err(SceneError::Header { field, value }),
        None => Ok(()),
    }
}

/// The greatest place where `count` things can begin among `all`; below 0 if there are not as
/// many. Neither is near the ends of its type: one is in memory, the other in a record.
pub(super) fn last(all: usize, count: i64) -> i64 {
    (all as i64).wrapping_sub(count)
}

pub(super) fn count(
    section: Section,
    count: usize,
    least: usize,
    most: usize,
) -> Result<(), SceneError> {
    range(
        section,
        0,
        Field::Count,
        count as i64,
        least as i64,
        most as i64,
    )
}

/// Inlined, because most comparisons are with constants, and the rest is a call elsewhere.
#[inline(always)]
pub(super) fn range(
    section: Section,
    index: usize,
    field: Field,
    value: i64,
    least: i64,
    most: i64,
) -> Result<(), SceneError> {
    if (least..=most).contains(&value) {
        Ok(())
    } else {
        Err(out_of_range(section, index, field, value))
    }
}

#[cold]
#[inline(never)]
fn out_of_range(section: Section, index: usize, field: Field, value: i64) -> SceneError {
    SceneError::Record {
        section,
        index,
        field,
        value,
    }
}
