//! Rows of the picture in RAM. In: buffers of the application. Out: [`Band`],
//! which `raster` draws into and `display` reads. Plain data; imports only
//! number formats.
#![expect(
    clippy::arithmetic_side_effects,
    reason = "columns, rows and strides of 16 bits, in wider integers; tests stop at overflow"
)]

mod band;
mod fill;
mod stored;

pub use band::{Band, BandError, BandRows, Target};
pub(crate) use fill::fill;
pub use stored::Stored;
