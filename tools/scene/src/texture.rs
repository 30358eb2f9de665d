//! Textures, and how they lie on surfaces.
//!
//! A point of a surface with texture coordinates `(u, v)` (see
//! [`crate::Mesh::texture_coordinates`]) is at `x = u * width` and
//! `y = (1 - v) * height` of the picture, in texels from its top left corner. Texel
//! `(i, j)` covers `i..i + 1` and `j..j + 1`.

/// A picture to be laid on surfaces.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Texture {
    /// Where it came from, for messages.
    pub name: String,
    /// Width in texels, at least 1.
    pub width: u32,
    /// Height in texels, at least 1.
    pub height: u32,
    /// `width * height` texels by rows from the top left: display-encoded red, green
    /// and blue, and alpha, 255 where nothing shows through.
    pub texels: Vec<[u8; 4]>,
}

/// How a texture lies on the surfaces of a material. Its colour multiplies the
/// material's ambient and diffuse colour (so emission too, but no highlight), as a
/// vertex colour does. Of flat and Gouraud shading, what is multiplied and what is
/// not are each clamped to 0..=1 and interpolated by themselves, of Phong shading
/// clamped at the pixel; their sum is clamped again.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Texturing {
    /// Index into [`crate::Scene::textures`].
    pub texture: usize,
    /// How texels become a colour. Default nearest, which costs a fraction of
    /// bilinear.
    pub filter: Filter,
    /// What is beyond the picture's edges. Default repeat.
    pub wrap: Wrap,
    /// Whether coordinates are interpolated over the surface, as they should be
    /// (the default). If not, they are interpolated over the screen, which is faster
    /// and bends straight lines in perspective; of a triangle that the near or the
    /// far plane cuts they are interpolated over the surface all the same.
    pub perspective: bool,
    /// Whether smaller copies stand in where texels are smaller than pixels. Default
    /// true.
    ///
    /// Copy 0 is the picture; each further one has half the width and height of the
    /// one before, rounded down, but at least 1, down to 1 by 1. Its texels are the
    /// means of 2 by 2 (of what is 1 wide or high, of 2) texels of the one before
    /// with the same place, of display-encoded values; colours are weighted by alpha.
    ///
    /// A pixel takes copy number `floor(log2(r) + 1/2)`, at least 0 and at most the
    /// last, with `r` the greatest of `|dx/dX|`, `|dy/dX|`, `|dx/dY|` and `|dy/dY|`:
    /// texels of the picture a pixel, at the pixel's centre, on the triangle's plane.
    pub mipmaps: bool,
    /// A pixel is not drawn, as if there were no surface, if the alpha of the
    /// texel (of the copy taken) in which it lies is less than this; 0..=1. Default
    /// 0: all are drawn.
    pub alpha_test: f64,
}

/// How texels become a colour.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Filter {
    /// The colour of the texel in which the point lies.
    Nearest,
    /// Between the centres of the four texels around the point, linear in both
    /// directions, on display-encoded values. Texels that do not pass the alpha test
    /// are left out.
    Bilinear,
}

/// What is beyond a picture's edges. Of the column (the same of the row) `i`:
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Wrap {
    /// the first or the last column.
    Clamp,
    /// column `i mod width`.
    Repeat,
    /// column `m = i mod 2 width`, or `2 width - 1 - m` if `m` is not less than the
    /// width: every other one is a mirror image.
    Mirror,
}

impl Texturing {
    /// All by default.
    pub fn new(texture: usize) -> Self {
        Self {
            texture,
            filter: Filter::Nearest,
            wrap: Wrap::Repeat,
            perspective: true,
            mipmaps: true,
            alpha_test: 0.0,
        }
    }
}
