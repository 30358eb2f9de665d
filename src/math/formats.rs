//! Every quantity's format has one name, here.

use fixed::types::extra::{U4, U6, U10};
use fixed::{FixedI32, FixedU16, FixedU32};

/// Lengths and places in world space, range -32768..32768, step 2^-16. The
/// baker scales a scene by a power of two so that it uses this range well;
/// see [`Scene::world_exponent`](crate::scene::Scene::world_exponent).
pub type World = fixed::types::I16F16;

/// Fractional bits of a screen position. Ten, not eight: with 8 the depth of a
/// steep face is off by more than a unit (a vertex that snaps by 1/512 pixel
/// on a face that falls 500 depth units a pixel), and with more than 10 the
/// products of a triangle of up to 32 pixels no longer fit 32 bits.
pub const SUBPX_BITS: u32 = 10;

/// A place on the screen in pixels: pixel (0, 0) spans 0..1 and has its centre
/// at 0.5; y points down. Step 1/1024 pixel.
pub type SubPx = FixedI32<U10>;

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
