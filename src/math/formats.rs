//! Every quantity's format has one name, here.

use fixed::types::extra::{U4, U6, U12};
use fixed::{FixedI32, FixedU16, FixedU32};

/// Lengths and places in world space, range -32768..32768, step 2^-16. The
/// baker scales a scene by a power of two so that it uses this range well;
/// see [`Scene::world_exponent`](crate::scene::Scene::world_exponent).
pub type World = fixed::types::I16F16;

/// Factors of sizes and distances: 0..256 in steps of 2^-24; 1 leaves what it is.
pub type Factor = fixed::types::U8F24;

/// Fractional bits of a screen position. Coverage would be content with 8; depth
/// is not: a vertex that snaps by 1/512 pixel on a face that falls 500 depth
/// units a pixel is a unit off. Pixels within one unit of the exact depth, with
/// 8, 10 and 12 bits: teapot 98.5, 99.93, 99.95 %; bunny at 128x64 97.6, 99.6,
/// 99.95 %. Products of a triangle of up to 8 pixels still fit 32 bits.
pub const SUBPX_BITS: u32 = 12;

/// A place on the screen in pixels: pixel (0, 0) spans 0..1 and has its centre
/// at 0.5; y points down. Step 1/4096 pixel.
pub type SubPx = FixedI32<U12>;

/// Half a pixel in raw [`SubPx`] units.
pub const HALF_PX: i32 = 1 << (SUBPX_BITS - 1);

/// Screen positions stay within this distance of the screen's centre (raw
/// [`SubPx`] units: 2048 pixels). What reaches beyond is clipped there.
pub const MAX_SCREEN: i32 = 1 << (SUBPX_BITS + 11);

/// A depth as stored: 0 where nothing is, otherwise 1..=65535, larger is
/// nearer, linear in screen space.
pub type Depth = u16;

/// A vertex's depth, before interpolation: 0..65536 in steps of 1/16.
pub type FineDepth = FixedU32<U4>;

/// A light level as used in a table: 0 is black, 255 the full colour.
pub type Level = u8;

/// A vertex's light level, before interpolation: 0..=255 in steps of 1/64.
pub type FineLevel = FixedU16<U6>;
