//! Octahedral normals in two bytes.
//!
//! Meyer et al., "On Floating-Point Normal Vectors" (2010); of the codes around
//! the exact one the nearest is taken, as Cigolle et al., "A Survey of Efficient
//! Representations for Independent Unit Vectors" (2014), advise.

use glam::DVec3;

/// Largest coordinate of a code in two bytes.
pub(crate) const COARSE: i32 = 127;
/// Largest coordinate of a code with 4 bits more each.
pub(crate) const FINE: i32 = 127 << 4;

/// The code whose decoded direction is nearest to `normal`; its coordinates are
/// within `one`.
pub(crate) fn encode(normal: DVec3, one: i32) -> [i32; 2] {
    let n = normal.normalize_or(DVec3::Z);
    let on_octahedron = n / (n.x.abs() + n.y.abs() + n.z.abs());
    let (mut u, mut v) = (on_octahedron.x, on_octahedron.y);
    if n.z < 0.0 {
        (u, v) = ((1.0 - v.abs()).copysign(u), (1.0 - u.abs()).copysign(v));
    }
    let floor = |c: f64| (c * f64::from(one)).floor() as i32;
    let mut best = ([0, 0], f64::NEG_INFINITY);
    for du in -1..=2 {
        for dv in -1..=2 {
            let code = [floor(u) + du, floor(v) + dv];
            if code.iter().any(|c| c.abs() > one) {
                continue;
            }
            let likeness = decode(code, one).dot(n);
            if likeness > best.1 {
                best = (code, likeness);
            }
        }
    }
    best.0
}

/// The direction of a code, length 1.
pub(crate) fn decode([u, v]: [i32; 2], one: i32) -> DVec3 {
    let (x, y) = (f64::from(u), f64::from(v));
    let z = f64::from(one) - x.abs() - y.abs();
    let fold = (-z).max(0.0);
    // A coordinate of 0 counts as positive, as in the core.
    let toward_zero = |c: f64| if c >= 0.0 { c - fold } else { c + fold };
    DVec3::new(toward_zero(x), toward_zero(y), z).normalize()
}

/// A face's normal: 10 bits and a sign each for x, y, z, 511 is 1.
pub(crate) fn pack(normal: DVec3) -> u32 {
    let part = |c: f64| ((c * 511.0).round() as i32 as u32) & 0x3ff;
    part(normal.x) | part(normal.y) << 10 | part(normal.z) << 20
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn error_is_below_a_degree_everywhere() {
        let mut worst: f64 = 0.0;
        let mut sum = 0.0;
        let steps = 200;
        for i in 0..steps {
            for j in 0..2 * steps {
                let z = -1.0 + 2.0 * (f64::from(i) + 0.5) / f64::from(steps);
                let angle = std::f64::consts::PI * f64::from(j) / f64::from(steps);
                let r = (1.0 - z * z).sqrt();
                let n = DVec3::new(r * angle.cos(), r * angle.sin(), z);
                let error = decode(encode(n, COARSE), COARSE)
                    .dot(n)
                    .min(1.0)
                    .acos()
                    .to_degrees();
                worst = worst.max(error);
                sum += error;
            }
        }
        let mean = sum / f64::from(2 * steps * steps);
        assert!(worst < 0.95, "worst {worst} degrees");
        assert!(mean < 0.34, "mean {mean} degrees");
    }

    #[test]
    fn axes_are_exact() {
        for axis in [
            DVec3::X,
            DVec3::Y,
            DVec3::Z,
            -DVec3::X,
            -DVec3::Y,
            -DVec3::Z,
        ] {
            assert_eq!(decode(encode(axis, COARSE), COARSE), axis);
            assert_eq!(decode(encode(axis, FINE), FINE), axis);
        }
    }
}
