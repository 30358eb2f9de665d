//! What is seen at one pixel.

use fixel_scene::Rgb;
use glam::DVec3;

/// The surface seen at a pixel's centre: the nearest that is not blended. Of a screen
/// door's pixels those that are not its own show what is behind.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hit {
    /// Depth in units of the 16-bit buffer, unrounded, 0..=65535; larger is
    /// nearer.
    pub depth_lsb: f64,
    /// Index of the actor in the scene.
    pub actor: usize,
    /// Index of the triangle in the actor's mesh; of its edges, counted on from
    /// the triangles, or of its vertices, counted on from the edges.
    pub triangle: usize,
    /// Index of the material in the scene.
    pub material: usize,
    /// Weights of the triangle's corners in 3D, in the order of the mesh's
    /// triangle (of a reflected actor: with the last two swapped).
    pub weights: [f64; 3],
    /// Light on the surface, without texture, if its material's colours were white, it had no
    /// vertex colours, and each light (the ambient one too) were the grey of its
    /// channels' mean: 0..=255, clamped where the light model is worked out. For
    /// grey lights and a material whose highlights have its diffuse colour, this
    /// is what the surface's colour is made of; otherwise it is but a measure of
    /// brightness, and [`Hit::colour`] says what is seen.
    pub level: f64,
    /// The surface's colour, each channel in 0..=1.
    pub colour: Rgb,
    /// How much of what is seen is fog, 0..=1; `level` and `colour` are without.
    pub fog: f64,
    /// The texture's own colour there, before any light, if there is a texture.
    pub texel: Option<Rgb>,
    /// The texels that it is blended of, with weights whose sum is 1, or 0 where they are
    /// not known.
    pub texels: [(Rgb, f64); 4],
    /// Light in the surface's own colour, without texture, and highlights: each
    /// channel in 0..=1. The colour is `texel * own + gloss`, clamped.
    pub own_and_gloss: [Rgb; 2],
    /// The place in the texture, in texels from its top left corner, before wrapping.
    pub texture_place: Option<[f64; 2]>,
    /// How much farther the next surface at this pixel is, in depth units;
    /// infinite if there is none.
    pub margin_lsb: f64,
    /// It hides what is behind it and shows the background: a face of a
    /// hidden-line actor. Without light; [`Hit::level`] and [`Hit::colour`] are 0.
    pub hidden: bool,
}

/// A blended surface before what is seen at a pixel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Layer {
    /// Its own colour with the fog before it, each channel in 0..=1.
    pub colour: Rgb,
    /// How much of it is seen, 0..=1.
    pub opacity: f64,
    /// Its depth; see [`Hit::depth_lsb`].
    pub depth_lsb: f64,
}

impl Layer {
    /// The colour seen, given that of what is behind it.
    pub(crate) fn over(&self, behind: Rgb) -> Rgb {
        DVec3::from(behind)
            .lerp(self.colour.into(), self.opacity)
            .into()
    }
}
