//! How much of a surface two-byte normals would light wrongly.

use glam::DVec3;

use crate::normal;

/// Lights that a surface is tried under, spread evenly.
const LIGHTS: usize = 64;
/// Full light.
const FULL: f64 = 255.0;
/// A level may be off by so much in all, half of which at most is its own rounding.
const LIMIT: f64 = 2.0;
const ROUNDING: f64 = 0.5;

/// The share of the lit surface whose level two-byte normals would put off by more
/// than 2 of 255, under the light that shows it most: directional, white, `brightness`
/// times full; what is lit by more than full light does not show it.
///
/// Along each triangle levels are interpolated, as in Gouraud shading; a level that is
/// then rounded goes over the limit as often as its distance from a whole one has it.
pub(crate) fn wrong_share(
    positions: &[DVec3],
    normals: &[DVec3],
    triangles: &[[u32; 3]],
    brightness: f64,
) -> f64 {
    let error = |n: &DVec3| normal::decode(normal::encode(*n, normal::COARSE), normal::COARSE) - *n;
    let errors: Vec<DVec3> = normals.iter().map(error).collect();
    let share = |light: DVec3| {
        let (mut lit, mut wrong) = (0.0, 0.0);
        for triangle in triangles {
            let [a, b, c] = triangle.map(|v| positions[v as usize]);
            // What is seen of it from where the light is.
            let area = (b - a).cross(c - a).dot(light).max(0.0);
            let off = triangle.map(|v| errors[v as usize].dot(light) * brightness * FULL);
            let least = triangle.map(|v| normals[v as usize].dot(light) * brightness);
            lit += area;
            if least.into_iter().fold(f64::INFINITY, f64::min) < 1.0 {
                wrong += area * over_limit(off);
            }
        }
        if lit > 0.0 { wrong / lit } else { 0.0 }
    };
    (0..LIGHTS).map(direction).map(share).fold(0.0, f64::max)
}

/// How often a level is over the limit in a triangle whose corners are `off` by so much:
/// in the middle and, twice, half way to each corner.
fn over_limit(off: [f64; 3]) -> f64 {
    let middle = off.iter().sum::<f64>() / 3.0;
    let often = |off: f64| (off.abs() - (LIMIT - ROUNDING)).clamp(0.0, 1.0);
    let near_corners = off.map(|corner| 2.0 * often((corner + middle) / 2.0));
    (often(middle) + near_corners.iter().sum::<f64>()) / 7.0
}

/// The `i`-th of [`LIGHTS`] directions on a spherical Fibonacci lattice.
fn direction(i: usize) -> DVec3 {
    let z = 1.0 - (2.0 * i as f64 + 1.0) / LIGHTS as f64;
    let turn = std::f64::consts::TAU * 0.618_033_988_749_895 * i as f64;
    let r = (1.0 - z * z).sqrt();
    DVec3::new(r * turn.cos(), r * turn.sin(), z)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A square that faces `normal`.
    fn square(normal: DVec3, brightness: f64) -> f64 {
        let x = normal.any_orthonormal_vector();
        let y = normal.cross(x);
        let corners = [-x - y, x - y, x + y, y - x];
        wrong_share(&corners, &[normal; 4], &[[0, 1, 2], [0, 2, 3]], brightness)
    }

    #[test]
    fn a_face_along_an_axis_is_right_and_one_between_codes_is_not() {
        assert_eq!(square(DVec3::Z, 1.0), 0.0);
        let between = normal::decode([83, 85], 255);
        assert!(square(between, 1.0) > 0.05);
        assert_eq!(square(between, 0.5), 0.0);
        // It shows where light is not full, hence at 60 degrees or more from the normal.
        assert!(square(between, 2.0) > 0.05);
        assert_eq!(square(DVec3::Z, 2.0), 0.0);
    }
}
