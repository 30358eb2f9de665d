//! Oklab: Bjorn Ottosson, "A perceptual color space for image processing"
//! (2020). Powers and roots are `libm`'s, the same on every host.

use fixel_scene::Rgb;

/// Lightness and two opponent axes.
pub(crate) type Lab = [f64; 3];

/// From display-encoded sRGB.
pub(crate) fn from_rgb(rgb: Rgb) -> Lab {
    let [r, g, b] = rgb.map(|c| {
        let c = c.clamp(0.0, 1.0);
        if c <= 0.04045 {
            c / 12.92
        } else {
            libm::pow((c + 0.055) / 1.055, 2.4)
        }
    });
    let l = libm::cbrt(0.4122214708 * r + 0.5363325363 * g + 0.0514459929 * b);
    let m = libm::cbrt(0.2119034982 * r + 0.6806995451 * g + 0.1073969566 * b);
    let s = libm::cbrt(0.0883024619 * r + 0.2817188376 * g + 0.6299787005 * b);
    [
        0.2104542553 * l + 0.7936177850 * m - 0.0040720468 * s,
        1.9779984951 * l - 2.4285922050 * m + 0.4505937099 * s,
        0.0259040371 * l + 0.7827717662 * m - 0.8086757660 * s,
    ]
}

/// Squared distance.
pub(crate) fn distance2(a: Lab, b: Lab) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a - b) * (a - b)).sum()
}

/// To display-encoded sRGB; what is out of its range is cut off in each channel.
pub(crate) fn to_rgb([lightness, a, b]: Lab) -> Rgb {
    let l = lightness + 0.3963377774 * a + 0.2158037573 * b;
    let m = lightness - 0.1055613458 * a - 0.0638541728 * b;
    let s = lightness - 0.0894841775 * a - 1.2914855480 * b;
    let [l, m, s] = [l, m, s].map(|c| c * c * c);
    let linear = [
        4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s,
        -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
        -0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s,
    ];
    linear.map(|c| {
        let c = c.clamp(0.0, 1.0);
        if c <= 0.0031308 {
            c * 12.92
        } else {
            (1.055 * libm::pow(c, 1.0 / 2.4) - 0.055).min(1.0)
        }
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn there_and_back() {
        let steps = [0.0, 0.02, 0.25, 0.5, 0.8, 1.0];
        for red in steps {
            for green in steps {
                for blue in steps {
                    let colour = [red, green, blue];
                    let back = to_rgb(from_rgb(colour));
                    let off = [0, 1, 2].map(|i| (back[i] - colour[i]).abs());
                    assert!(off.iter().all(|off| *off < 1e-4), "{colour:?} {back:?}");
                }
            }
        }
    }

    #[test]
    fn values_of_the_source() {
        // White is (1, 0, 0); red as computed by the reference implementation.
        let close = |a: Lab, b: Lab| distance2(a, b) < 1e-8;
        assert!(close(from_rgb([1.0; 3]), [1.0, 0.0, 0.0]));
        assert!(close(
            from_rgb([1.0, 0.0, 0.0]),
            [0.627955, 0.224863, 0.125846]
        ));
        assert!(close(
            from_rgb([0.0, 0.0, 1.0]),
            [0.452014, -0.032457, -0.311528]
        ));
    }
}
