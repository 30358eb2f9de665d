//! Where a pixel and a light are sampled: the same places as in the core, so that the
//! two can be compared pixel by pixel.
//!
//! Along one side the places are even, along the other steps of the golden ratio: few of
//! them are spread well over the square, and over each of its sides. What differs from
//! pixel to pixel is the plastic number's pattern (M. Roberts, "The Unreasonable
//! Effectiveness of Quasirandom Sequences", 2018).

const GOLDEN: f64 = 0.6180339887498949;
const PLASTIC: [f64; 2] = [0.7548776662466927, 0.5698402909980532];

/// Place number `i` of `count` in a pixel; number 0 is its centre.
pub(crate) fn in_pixel(i: u32, count: u32) -> [f64; 2] {
    let i = f64::from(i);
    [0.5 + i / f64::from(count), 0.5 + i * GOLDEN].map(f64::fract)
}

/// Place number `j` of `count` on a light, for a sample of a pixel: moved round by an
/// amount that differs from pixel to pixel, so that what few places get wrong is noise
/// rather than bands.
pub(crate) fn on_light(j: u32, count: u32, sample: u32, [x, y]: [u32; 2]) -> [f64; 2] {
    let [x, y, j, sample, count] = [x, y, j, sample, count].map(f64::from);
    let across = (x * PLASTIC[0] + y * PLASTIC[1]).fract();
    let along = (x * PLASTIC[1] + y * PLASTIC[0]).fract();
    let u = (j + 0.5) / count + sample * PLASTIC[0] + across;
    let v = 0.5 + (j + sample * count) * GOLDEN + along;
    [u.fract(), v.fract()]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// How many of the places are in each of so many equal columns and rows.
    fn spread(places: &[[f64; 2]], parts: usize) -> [Vec<usize>; 2] {
        [0, 1].map(|axis| {
            let part = |place: &[f64; 2]| (place[axis] * parts as f64) as usize;
            let count = |p: usize| places.iter().filter(|place| part(place) == p).count();
            (0..parts).map(count).collect()
        })
    }

    #[test]
    fn places_are_spread_over_the_square_and_its_sides() {
        for count in [4, 8, 16] {
            let pixel: Vec<_> = (0..count).map(|i| in_pixel(i, count)).collect();
            assert_eq!(pixel[0], [0.5, 0.5]);
            let light = |at| (0..count).map(|j| on_light(j, count, 1, at)).collect();
            for places in [pixel, light([0, 0]), light([7, 3])] {
                for parts in spread(&places, 4) {
                    let even = count as usize / 4;
                    let good = parts.iter().all(|n| n.abs_diff(even) <= 1);
                    assert!(good, "{count}: {parts:?}");
                }
            }
        }
    }
}
