//! Where distance bends what is interpolated, as the core decides it.

use fixel::math::SUBPX_BITS;
use fixel::vertex::ScreenVertex;

use crate::span;

/// Whether levels are divided by distance.
pub(crate) fn levels_bend(corners: [&ScreenVertex; 3]) -> bool {
    let (left, right) = span::ends(corners.map(|v| f64::from(v.x().to_bits())));
    right - left >= f64::from(8 << SUBPX_BITS) && bend(corners, levels_differ(corners))
}

/// Whether depths differ by too much for a texture to be had pixel by pixel.
pub(crate) fn textures_bend(corners: [&ScreenVertex; 3]) -> bool {
    let (far, near) = span::ends(corners.map(|v| f64::from(v.z().to_bits())));
    (near - far) * 8.0 > near
}

/// By how much corners' levels differ.
pub(crate) fn levels_differ(corners: [&ScreenVertex; 3]) -> f64 {
    let (least, most) = span::ends(corners.map(|v| f64::from(v.level().to_bits())));
    most - least
}

/// Whether distance bends what differs by so much; as the core decides it.
pub(crate) fn bend(corners: [&ScreenVertex; 3], difference: f64) -> bool {
    let (far, near) = span::ends(corners.map(|v| f64::from(v.z().to_bits() >> 4)));
    difference * (near - far) > far * 256.0
}
