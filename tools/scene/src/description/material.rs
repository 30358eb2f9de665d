//! Materials.

use super::Rgb;
use crate::texture::Texturing;

/// A surface. Its colour under light is, on display-encoded values and clamped
/// to 0..=1 in each channel,
///
/// ```text
/// emission*Cd + Ca*ka*A + sum over lights of
///     attenuation * spot * L * (Cd*kd*max(0, N.l) + Cs*ks*max(0, R.v)^power)
/// ```
///
/// with `A` the ambient light, `L` a light's colour times intensity, `N` the
/// normal, `l` towards the light, `v` towards the eye (of a parallel camera:
/// against the line of sight) and `R` the mirror image of `l` about `N`. The
/// specular part is there only where `N.l > 0`.
#[derive(Clone, Debug, PartialEq)]
pub struct Material {
    /// Its name in the file.
    pub name: String,
    /// Colour under ambient light, `Ca`. Default white.
    pub ambient_colour: Rgb,
    /// Colour under diffuse light, `Cd`. Default white.
    pub diffuse_colour: Rgb,
    /// Colour of highlights, `Cs`. Default white. A file's `colour` sets all
    /// three, as VTK's `SetColor` does.
    pub specular_colour: Rgb,
    /// Coefficient `ka`, 0..=1. Default 0.
    pub ambient: f64,
    /// Coefficient `kd`, 0..=1. Default 1.
    pub diffuse: f64,
    /// Coefficient `ks`, 0..=1. Default 0.
    pub specular: f64,
    /// How sharp highlights are, 1..=128. Default 1.
    pub specular_power: f64,
    /// Light of its own, 0..=1: `emission * diffuse_colour` is added. Default 0.
    pub emission: f64,
    /// Where the light model is worked out. Default Gouraud.
    pub shading: Shading,
    /// Which faces are left out. Default back faces.
    pub cull: Cull,
    /// What multiplies its ambient and diffuse colour from place to place. Every
    /// mesh that it is on, as a surface, has texture coordinates.
    pub texture: Option<Texturing>,
    /// How much of what is behind it it hides, 0..=1. Default 1.
    pub opacity: f64,
    /// How the rest shows, where `opacity` is less than 1. Default blended.
    pub transparency: Transparency,
    /// The part of what is seen that the surface mirrors, 0..=1. Default 0. Only
    /// the ray caster shows it.
    pub reflectivity: f64,
    /// Refractive index of what the surface encloses, 1..=4. Default 1: what is
    /// seen through it is where it is. Only the ray caster shows it.
    pub refractive_index: f64,
}

impl Default for Material {
    /// VTK's, without a name.
    fn default() -> Self {
        Self {
            name: String::new(),
            ambient_colour: [1.0; 3],
            diffuse_colour: [1.0; 3],
            specular_colour: [1.0; 3],
            ambient: 0.0,
            diffuse: 1.0,
            specular: 0.0,
            specular_power: 1.0,
            emission: 0.0,
            shading: Shading::Gouraud,
            cull: Cull::Back,
            texture: None,
            opacity: 1.0,
            transparency: Transparency::Blend,
            reflectivity: 0.0,
            refractive_index: 1.0,
        }
    }
}

/// How a rasteriser shows a surface that hides only a part of what is behind it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Transparency {
    /// Each pixel is the mixture `opacity * own + (1 - opacity) * behind` of colours as
    /// they are encoded for the display: VTK's meaning of opacity, hence the default.
    /// Such a surface hides nothing: it is no part of a depth buffer.
    Blend,
    /// So large a part of the pixels is the surface's, in a regular pattern, the others
    /// show what is behind. It needs no mixed colours, so that it suits small palettes,
    /// and no order, so that it is right for shapes that go through one another.
    ///
    /// Pixel x, y of a viewport (from its top left corner, y down) is drawn if
    /// `(bayer(x, y) + 64 - 16 n) mod 64 < round(64 opacity)`. `n` is the number of
    /// materials before this one that are drawn so (`opacity` below 1), modulo 4, so that those of two materials
    /// are not the same pixels. `bayer` is Bayer's matrix of 8 by 8: the bits of `x ^ y`
    /// and `y` from the lowest to the highest, in turn, from the highest of 6 bits down.
    ScreenDoor,
}

/// Where the light model is worked out.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shading {
    /// Once a face: at its centre (the mean of its corners), with the normal of
    /// its winding and the mean of its vertex colours.
    Flat,
    /// At the vertices; the clamped colours are interpolated over the face.
    Gouraud,
    /// At each pixel, at the surface point there, with the normal (and the
    /// vertex colour) interpolated over the face and the normal brought back
    /// to length 1.
    Phong,
}

/// Which faces are left out. A face is seen from its front when its vertices
/// appear counter-clockwise on the screen.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Cull {
    /// Faces seen from behind are left out (the default).
    Back,
    /// Faces seen from the front are left out.
    Front,
    /// All are drawn. The light model uses the normal as it stands, not
    /// turned to the viewer.
    None,
}
