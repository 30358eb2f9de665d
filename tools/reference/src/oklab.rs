//! Oklab (Bjorn Ottosson, 2020), in which a texture's colours are quantised.

use fixel_scene::Rgb;
use glam::{DMat3, DVec3};

/// Of a display-encoded sRGB colour.
pub(crate) fn oklab(colour: Rgb) -> DVec3 {
    let linear = colour.map(|c| {
        if c <= 0.04045 {
            c / 12.92
        } else {
            ((c + 0.055) / 1.055).powf(2.4)
        }
    });
    let cones = DMat3::from_cols_array_2d(&[
        [0.4122214708, 0.2119034982, 0.0883024619],
        [0.5363325363, 0.6806995451, 0.2817188376],
        [0.0514459929, 0.1073969566, 0.6299787005],
    ]);
    let lab = DMat3::from_cols_array_2d(&[
        [0.2104542553, 1.9779984951, 0.0259040371],
        [0.7936177850, -2.4285922050, 0.7827717662],
        [-0.0040720468, 0.4505937099, -0.8086757660],
    ]);
    lab * (cones * DVec3::from(linear)).map(f64::cbrt)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_of_the_source() {
        assert!(oklab([1.0; 3]).distance(DVec3::X) < 1e-4);
        let red = DVec3::new(0.627955, 0.224863, 0.125846);
        assert!(oklab([1.0, 0.0, 0.0]).distance(red) < 1e-4);
    }
}
