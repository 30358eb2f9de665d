//! The base-colour texture of a glTF material.

use gltf::Material;
use gltf::image::Source;
use gltf::material::AlphaMode;
use gltf::texture::{MagFilter, MinFilter, WrappingMode};

use super::Refusal;
use super::accessor::{self, Buffers};
use super::gltf::uri_data;
use crate::files::Origin;
use crate::picture;
use crate::texture::{Filter, Texture, Texturing, Wrap};

/// The index of the texture, and of its set of coordinates.
pub(super) fn index(material: &Material<'_>) -> Option<(usize, u32)> {
    let info = material.pbr_metallic_roughness().base_color_texture()?;
    Some((info.texture().index(), info.tex_coord()))
}

/// A texture and how it lies on a surface.
type Laid = (Texture, Texturing);

/// A material's texture, and what was left out of it.
pub(super) fn read(
    origin: Origin<'_>,
    buffers: &Buffers,
    material: &Material<'_>,
) -> Result<(Option<Laid>, Vec<&'static str>), Refusal> {
    let mut notes = Vec::new();
    let base = material.pbr_metallic_roughness();
    let Some(info) = base.base_color_texture() else {
        return Ok((None, notes));
    };
    let (texture, image) = (info.texture(), info.texture().source());
    let wrong = |what: String| Refusal::new(format!("images[{}]: {what}", image.index()));
    let picture = match image.source() {
        Source::View { view, .. } => {
            let bytes = accessor::view(buffers, &view)
                .ok_or_else(|| wrong("reaches beyond its buffer".to_owned()))?;
            picture::decode(bytes).map_err(wrong)?
        }
        Source::Uri { uri, .. } => {
            let bytes = uri_data(origin, uri).map_err(wrong)?;
            picture::decode(&bytes).map_err(wrong)?
        }
    };
    let sampler = texture.sampler();
    let mut how = Texturing::new(0);
    if sampler.mag_filter() == Some(MagFilter::Nearest) {
        how.filter = Filter::Nearest;
    }
    let without = [Some(MinFilter::Nearest), Some(MinFilter::Linear)];
    how.mipmaps = !without.contains(&sampler.min_filter());
    how.wrap = match sampler.wrap_s() {
        WrappingMode::ClampToEdge => Wrap::Clamp,
        WrappingMode::MirroredRepeat => Wrap::Mirror,
        WrappingMode::Repeat => Wrap::Repeat,
    };
    if sampler.wrap_t() != sampler.wrap_s() {
        notes.push("a texture that wraps in two ways wraps down as it does across");
    }
    match material.alpha_mode() {
        AlphaMode::Opaque => {}
        AlphaMode::Mask => how.alpha_test = material.alpha_cutoff().unwrap_or(0.5).into(),
        AlphaMode::Blend => {
            how.alpha_test = 0.5;
            notes.push("what shows through is drawn in full, or from half on not at all");
        }
    }
    let file = origin
        .path
        .file_name()
        .unwrap_or_default()
        .to_string_lossy();
    let name = format!("{file}, images[{}]", image.index());
    Ok((Some((picture.texture(&name), how)), notes))
}
