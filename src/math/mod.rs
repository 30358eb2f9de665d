//! Number formats and the arithmetic that every stage shares.
//! In: raw integers. Out: typed fixed-point quantities, exact products and
//! quotients, tables with a stated error. Used by all stages; imports none.
#![expect(
    clippy::arithmetic_side_effects,
    reason = "each function holds its numbers in range, and wraps where arguments may be anything; tests stop at overflow"
)]

mod angle;
mod bayer;
mod blue_noise;
mod formats;
mod length;
mod octahedral;
mod power;
mod quotient;
mod recip;
mod rect;
mod rolled;
mod root;
mod rotation;
mod scaled;
mod transform;
mod vector;
mod wide;

pub use angle::Angle;
pub use bayer::{bayer4, bayer8};
pub use blue_noise::blue_noise;
pub use formats::{
    Depth, Factor, FineDepth, FineLevel, HALF_PX, Level, MAX_SCREEN, SUBPX_BITS, SubPx, World,
};
pub use length::{
    ShortUnit, direction, reciprocal_root, root, scaled_reciprocal, short_dot, unit, unit_vector,
};
pub(crate) use octahedral::decode_octahedral;
#[cfg(test)]
use octahedral::normal_length_recip;
pub use power::power;
pub use quotient::Divider;
#[cfg(feature = "ray")]
pub(crate) use recip::leading_zeros;
pub use recip::{Reciprocal, reciprocal};
pub use rect::Rect;
pub(crate) use rolled::{keep_rolled, rolled};
pub(crate) use root::{short_square_root, square_root};
pub use rotation::Rotation;
pub use scaled::Scaled;
pub(crate) use transform::view_rotation;
pub use transform::{Clip, Model, Space, Transform, View, World as WorldSpace};
pub use vector::{Unit3, Vec3, cross, dot, normalise};
#[cfg(feature = "ray")]
pub(crate) use wide::mul_high_u;
pub use wide::{mul_high, mul_q30, product, square};

#[cfg(test)]
mod tests;
