//! Texels that are cut out: rays go through them.

use crate::scene::{Mesh, Scene, Texture};
use crate::shade::Sampler;

/// Whether nothing is seen at texture coordinates of a mesh, 8 fractional bits, in a texture
/// of the scene.
#[inline(never)]
pub(super) fn is_hole(scene: &Scene<'_>, mesh: &Mesh, texture: u8, place: [i32; 2]) -> bool {
    let (Some(texture), Some(own)) = (scene.texture(texture), mesh.coordinates) else {
        return false;
    };
    // Rays see the largest copy.
    let largest = Texture {
        copies: 1,
        ..texture
    };
    let sampler = Sampler::new(scene, largest, own);
    let (picture, place) = sampler.point(place);
    sampler.nearest(&picture, place).is_none()
}
