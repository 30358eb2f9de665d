//! What becomes of a ray at a surface: mirrored, or bent and partly mirrored.

use glam::DVec3;

/// A ray that goes on into a transparent body, or out of one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Bent {
    /// The part that is mirrored instead, 0..=1.
    pub mirrored: f64,
    /// Its direction, unit length; none where all is mirrored.
    pub direction: Option<DVec3>,
}

/// The mirror image of a direction of unit length at a surface with this normal, of
/// unit length and turned against it.
pub(crate) fn mirror(direction: DVec3, normal: DVec3) -> DVec3 {
    direction - normal * (2.0 * direction.dot(normal))
}

/// Snell's law, and Fresnel's equations for a dielectric and unpolarised light; `index`:
/// the refractive index behind the surface, divided by that before it.
pub(crate) fn refract(direction: DVec3, normal: DVec3, index: f64) -> Bent {
    let cosine = -direction.dot(normal);
    let sine = (1.0 - cosine * cosine).max(0.0).sqrt() / index;
    if sine >= 1.0 {
        return Bent {
            mirrored: 1.0,
            direction: None,
        };
    }
    let behind = (1.0 - sine * sine).sqrt();
    let across = (cosine - index * behind) / (cosine + index * behind);
    let along = (index * cosine - behind) / (index * cosine + behind);
    let bent = direction / index + normal * (cosine / index - behind);
    Bent {
        mirrored: (across * across + along * along) / 2.0,
        direction: Some(bent.normalize()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A direction that comes down at an angle to the vertical, in degrees.
    fn down(angle: f64) -> DVec3 {
        let (sin, cos) = angle.to_radians().sin_cos();
        DVec3::new(sin, -cos, 0.0)
    }

    #[test]
    fn snells_law() {
        let bent = refract(down(30.0), DVec3::Y, 1.5).direction.unwrap();
        let angle = (0.5_f64 / 1.5).asin();
        assert!(bent.distance(down(angle.to_degrees())) < 1e-12);
        // And back the same way.
        let back = refract(-bent, -DVec3::Y, 1.0 / 1.5).direction.unwrap();
        assert!(back.distance(-down(30.0)) < 1e-12);
    }

    #[test]
    fn fresnel_at_known_angles() {
        for index in [1.33_f64, 1.5, 2.4, 1.0 / 1.5] {
            let straight = ((index - 1.0) / (index + 1.0)).powi(2);
            let found = refract(down(0.0), DVec3::Y, index).mirrored;
            assert!((found - straight).abs() < 1e-12);
        }
        // At Brewster's angle only light across the plane is mirrored:
        // sin^2(b - r), with b + r a right angle.
        let brewster = 1.5_f64.atan();
        let across = (2.0 * brewster - std::f64::consts::FRAC_PI_2).sin().powi(2);
        let found = refract(down(brewster.to_degrees()), DVec3::Y, 1.5).mirrored;
        assert!((found - across / 2.0).abs() < 1e-12);
        assert!(refract(down(89.999), DVec3::Y, 1.5).mirrored > 0.999);
        assert_eq!(refract(down(40.0), DVec3::Y, 1.0).mirrored, 0.0);
        // The same from both sides.
        let bent = refract(down(50.0), DVec3::Y, 1.5);
        let back = refract(-bent.direction.unwrap(), -DVec3::Y, 1.0 / 1.5);
        assert!((bent.mirrored - back.mirrored).abs() < 1e-12);
    }

    #[test]
    fn beyond_the_critical_angle_all_is_mirrored() {
        let critical = (1.0_f64 / 1.5).asin().to_degrees();
        let inside = |angle| refract(down(angle), DVec3::Y, 1.0 / 1.5);
        assert!(inside(critical - 0.01).direction.is_some());
        let total = inside(critical + 0.01);
        assert_eq!((total.mirrored, total.direction), (1.0, None));
    }

    #[test]
    fn a_mirror_keeps_the_angle() {
        assert!(
            mirror(down(30.0), DVec3::Y).distance(DVec3::new(0.5, 0.75_f64.sqrt(), 0.0)) < 1e-12
        );
    }
}
