//! What a frame tells about itself.

use crate::light::Lit;

/// What a frame took.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct RayStats {
    /// Bands shown.
    pub bands: u32,
    /// Rays from the camera that were cast.
    pub rays: u32,
}

/// What a pixel shows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Seen {
    /// The actor in front.
    pub actor: u16,
    /// Its triangle's place in the scene's list; `None` of a ball.
    pub triangle: Option<u32>,
    /// Its depth.
    pub depth: u16,
    /// Lights that reach it: a bit each.
    pub lights: u8,
    /// Its light: the level, or of a material that goes by colour, and wherever
    /// several surfaces are seen, red, green and blue. In 1/64 of a level.
    pub light: Lit,
    /// The palette index without dithering.
    pub index: u8,
}

/// Sees each pixel that shows something: for measuring and picking.
pub trait Watch {
    /// A pixel's column and row in the frame, and what the ray through its middle shows.
    fn pixel(&mut self, column: u16, row: u16, seen: &Seen);

    /// The light of several rays at a pixel, and the index for it without dithering.
    fn smoothed(&mut self, column: u16, row: u16, light: Lit, index: u8);
}

impl Watch for () {
    #[inline(always)]
    fn pixel(&mut self, _: u16, _: u16, _: &Seen) {}

    #[inline(always)]
    fn smoothed(&mut self, _: u16, _: u16, _: Lit, _: u8) {}
}
