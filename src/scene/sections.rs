//! A scene's sections: the bytes of each, as records.

use bytemuck::{AnyBitPattern, try_cast_slice};

use super::layout;
use super::{
    Actor, Field, Fog, Header, Key, Light, LightArea, Look, Material, Mesh, Meshlet, Node, Optics,
    Output, RaySettings, Record, SceneError, Section, Shape, Texture, Track, Viewport,
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

/// Lists the fields of [`Scene`] that are sections, in the order of the table: what is done
/// with each is there once, not once for each kind of record. What only a feature reads is
/// left empty without it.
macro_rules! section_fields {
    ($($field:ident $($feature:literal)?),*) => {
        /// Size and alignment of each section's records.
        const RECORDS: [[usize; 2]; layout::SECTIONS] =
            [$(size_and_alignment(|scene| scene.$field)),*];

        impl<'a> Scene<'a> {
            pub(super) fn of(header: Header, [$($field),*]: &[&'a [u8]; layout::SECTIONS]) -> Self {
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
pub(super) fn find_sections<'a>(
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
