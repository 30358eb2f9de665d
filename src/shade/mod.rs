//! What the pixels of a surface look like. In: a [`Run`](crate::raster::Run) of
//! pixels with their attributes. Out: light, level or colour, and the palette index
//! for it. Used by `render`, `immediate` and `ray`.
#![expect(
    clippy::arithmetic_side_effects,
    reason = "levels, colours and places in textures, which raster holds in range; tests stop at overflow"
)]

mod cut;
mod lookup;
mod small_texture;
mod strip;
mod surface;
mod texels;
mod texture;
mod transparency;

pub use lookup::{Lookup, Pixel, dithered};
pub use small_texture::{SmallPicture, SmallTexture};
pub use surface::{Attributes, Lighting, Surface, channel, on_texel};
pub use texture::Sampler;
pub use transparency::{Blend, ScreenDoor, blended};
