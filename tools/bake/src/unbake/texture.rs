//! Textures and their coordinates, back from a blob.

use fixel::Scene as Blob;
use fixel::scene::{self as core_scene, NO_TEXEL};
use fixel_scene::{Filter, Texture, Texturing, Wrap};

/// The pictures, in base colours.
pub(super) fn textures(blob: &Blob<'_>) -> Vec<Texture> {
    let all = (0..blob.texture_count()).filter_map(|i| blob.texture(i as u8));
    let picture = |(number, texture): (usize, core_scene::Texture)| {
        let [width, height] = texture.size.map(|bits| 1u32 << bits);
        let first = texture.first as usize;
        let texels = blob.texels()[first..].iter();
        let colour = |texel: &u8| match blob.bases().get(usize::from(*texel)) {
            Some([r, g, b]) if *texel != NO_TEXEL => [*r, *g, *b, 255],
            _ => [0; 4],
        };
        Texture {
            name: format!("texture {}", number + 1),
            width,
            height,
            texels: texels.take((width * height) as usize).map(colour).collect(),
        }
    };
    all.enumerate().map(picture).collect()
}

/// How texture `index` lies on a surface.
pub(super) fn texturing(blob: &Blob<'_>, index: u8) -> Option<Texturing> {
    let texture = blob.texture(index)?;
    Some(Texturing {
        texture: index.into(),
        filter: if texture.bilinear {
            Filter::Bilinear
        } else {
            Filter::Nearest
        },
        wrap: match texture.wrap {
            core_scene::Wrap::Clamp => Wrap::Clamp,
            core_scene::Wrap::Repeat => Wrap::Repeat,
            core_scene::Wrap::Mirror => Wrap::Mirror,
        },
        perspective: texture.perspective,
        mipmaps: texture.copies > 1,
        alpha_test: 0.5,
    })
}

/// Texture coordinates of a meshlet's vertices.
pub(super) fn coordinates(
    blob: &Blob<'_>,
    meshlet: &core_scene::Meshlet,
    mesh: &core_scene::Mesh,
) -> Vec<[f64; 2]> {
    let Some(grid) = mesh.coordinates else {
        return Vec::new();
    };
    let step = f64::exp2(-f64::from(grid.exponent));
    let place = |stored: &[i16; 2]| {
        let [u, v] = [0, 1].map(|axis| {
            let steps = f64::from(i16::from_le(stored[axis])) + f64::from(grid.origin[axis]);
            steps * step
        });
        [u, 1.0 - v]
    };
    let stored = blob.meshlet_coordinates(meshlet, mesh);
    stored.iter().map(place).collect()
}
