//! Places of samples: the R2 sequence (Roberts, "The unreasonable effectiveness of
//! quasirandom sequences", 2018), in 2^-32.

/// One over the plastic number, and its square.
const FIRST: u32 = 3_242_174_889;
const SECOND: u32 = 2_447_445_414;

/// The `number`th place in a unit square; the first is its middle.
pub(super) fn sample(number: u32) -> [u32; 2] {
    let at = |step: u32| (1u32 << 31).wrapping_add(number.wrapping_mul(step));
    [at(FIRST), at(SECOND)]
}

/// What the places of a pixel are moved by, so that neighbours have others.
pub(super) fn rotation([x, y]: [u32; 2]) -> [u32; 2] {
    let at = |a: u32, b: u32| x.wrapping_mul(a).wrapping_add(y.wrapping_mul(b));
    [at(FIRST, SECOND), at(SECOND, FIRST)]
}
