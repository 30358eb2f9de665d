//! What a glTF file's materials say of its surfaces.

use gltf::material::AlphaMode;
use gltf::{Document, Material};

use super::accessor::Buffers;
use super::{Refusal, Soup, Surface, gltf_texture};
use crate::description::Rgb;
use crate::files::Origin;

/// What a primitive became: vertices and triangles up to the next part's.
#[derive(Debug)]
pub(super) struct Part {
    /// Index of the material.
    pub material: Option<usize>,
    /// Its base colour, display-encoded.
    pub colour: Rgb,
    /// Its first vertex.
    pub first_vertex: usize,
    /// Its first triangle.
    pub first_triangle: usize,
}

/// What sets surfaces apart: parts that differ in their base colour only are one surface,
/// whose vertices have the colours.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Kind {
    /// Index of the texture, and of its set of coordinates.
    texture: Option<(usize, u32)>,
    both_sides: bool,
    /// Where texels are cut out.
    alpha_test: Option<f32>,
}

impl Kind {
    fn of(material: Option<&Material<'_>>) -> Self {
        let texture = material.and_then(gltf_texture::index);
        let cut = |material: &Material<'_>| match material.alpha_mode() {
            AlphaMode::Opaque => None,
            AlphaMode::Mask | AlphaMode::Blend => Some(material.alpha_cutoff().unwrap_or(0.5)),
        };
        Self {
            texture,
            both_sides: material.is_some_and(Material::double_sided),
            alpha_test: material.filter(|_| texture.is_some()).and_then(cut),
        }
    }
}

/// Gives the soup its surfaces, in the order of their first parts: none if no part has a
/// material.
pub(super) fn give(
    origin: Origin<'_>,
    document: &Document,
    buffers: &Buffers,
    parts: &[Part],
    soup: &mut Soup,
) -> Result<(), Refusal> {
    let material = |part: &Part| document.materials().nth(part.material?);
    if parts.iter().all(|part| part.material.is_none()) {
        return Ok(());
    }
    let mut extensions = document.extensions_used();
    if extensions.any(|extension| extension == "KHR_texture_transform") {
        soup.note("texture transforms are left out");
    }
    let mut kinds: Vec<(Kind, Vec<usize>)> = Vec::new();
    for (number, part) in parts.iter().enumerate() {
        let mut kind = Kind::of(material(part).as_ref());
        if kind.texture.is_some() && soup.texture_coordinates.is_empty() {
            soup.note("a texture is left out, as there are no texture coordinates");
            (kind.texture, kind.alpha_test) = (None, None);
        }
        match kinds.iter_mut().find(|(other, _)| *other == kind) {
            Some((_, of)) => of.push(number),
            None => kinds.push((kind, vec![number])),
        }
    }
    soup.surface_of = vec![0; soup.triangles.len()];
    for (number, (kind, of)) in kinds.iter().enumerate() {
        for part in of {
            let end = parts.get(part + 1).map(|next| next.first_triangle);
            let triangles = parts[*part].first_triangle..end.unwrap_or(soup.triangles.len());
            soup.surface_of[triangles].fill(number as u32);
        }
        let first = &parts[of[0]];
        let mut surface = Surface {
            colour: first.colour,
            both_sides: kind.both_sides,
            ..Surface::default()
        };
        if of.iter().any(|part| parts[*part].colour != surface.colour) {
            surface.colour = [1.0; 3];
            for part in of {
                let end = parts.get(part + 1).map(|next| next.first_vertex);
                let vertices = parts[*part].first_vertex..end.unwrap_or(soup.positions.len());
                soup.paint(vertices, parts[*part].colour);
            }
        }
        if let (Some(_), Some(material)) = (kind.texture, material(first)) {
            let (texture, notes) = gltf_texture::read(origin, buffers, &material)?;
            surface.texture = texture;
            notes.iter().for_each(|note| soup.note(note));
        }
        soup.surfaces.push(surface);
    }
    Ok(())
}
