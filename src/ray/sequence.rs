//! Places of samples, in 2^-32. Along one side they are even, along the other steps of
//! the golden ratio: few of them are spread well over the square and over each of its
//! sides, which matters for edges that are level or upright. What differs from pixel to
//! pixel is the pattern of the plastic number (Roberts, "The unreasonable effectiveness
//! of quasirandom sequences", 2018).

const GOLDEN: u32 = 2_654_435_769;
/// One over the plastic number, and its square.
const PLASTIC: [u32; 2] = [3_242_174_889, 2_447_445_414];

/// Place `number` of `count` (a power of two) in a pixel; the first is its middle.
pub(super) fn in_pixel(number: u32, count: u32) -> [u32; 2] {
    let from_middle = |step: u32| (1u32 << 31).wrapping_add(number.wrapping_mul(step));
    [from_middle(part(count) << 1), from_middle(GOLDEN)]
}

/// Place `number` of `count` on a light, for a sample of a pixel.
pub(super) fn on_light(number: u32, count: u32, sample: u32, pixel: [u32; 2]) -> [u32; 2] {
    let [ru, rv] = rotation(pixel);
    let u = (number * 2 + 1).wrapping_mul(part(count));
    let u = u.wrapping_add(sample.wrapping_mul(PLASTIC[0]));
    let step = number.wrapping_add(sample.wrapping_mul(count));
    let v = (1u32 << 31).wrapping_add(step.wrapping_mul(GOLDEN));
    [u.wrapping_add(ru), v.wrapping_add(rv)]
}

/// Half of one part of `count`.
fn part(count: u32) -> u32 {
    (1u32 << 31).checked_div(count).unwrap_or_default()
}

/// What the places of a pixel are moved by, so that neighbours have others.
fn rotation([x, y]: [u32; 2]) -> [u32; 2] {
    let [a, b] = PLASTIC;
    let at = |a: u32, b: u32| x.wrapping_mul(a).wrapping_add(y.wrapping_mul(b));
    [at(a, b), at(b, a)]
}
