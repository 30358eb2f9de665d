//! What the pixels of a surface look like. In: a [`Run`](crate::raster::Run) of
//! pixels with their attributes. Out: light, level or colour, and the palette index
//! for it. Used by `render`.

mod lookup;
mod surface;

pub use lookup::{Lookup, dithered};
pub use surface::{Attributes, Lighting, Surface};
