//! Exact integer quotients. Scan conversion lives on these: an edge's crossing
//! with a row is a quotient and a remainder, not an approximation.

/// `(ceil(n / d), ceil(n / d) * d - n)` for `d > 0`: the remainder, in
/// `0..d`, is what the quotient is too large by. The quotient must fit `i32`;
/// it saturates otherwise. A divisor below 1 counts as 1.
#[inline(always)]
pub fn ceil_div(n: i64, d: i32) -> (i32, i32) {
    let (q, r) = floor_div(n.wrapping_neg(), d);
    (q.wrapping_neg(), r)
}

/// `(floor(n / d), n - floor(n / d) * d)` for `d > 0`. The quotient must fit
/// `i32`; it saturates otherwise. A divisor below 1 counts as 1.
#[inline(always)]
pub fn floor_div(n: i64, d: i32) -> (i32, i32) {
    let d = d.max(1);
    match i32::try_from(n) {
        // Most edges are short: one 32-bit division.
        Ok(n) => {
            let q = n.wrapping_div_euclid(d);
            (q, n.wrapping_sub(q.wrapping_mul(d)))
        }
        Err(_) => wide_floor_div(n, d),
    }
}

#[cold]
#[inline(never)]
fn wide_floor_div(n: i64, d: i32) -> (i32, i32) {
    let d = i64::from(d);
    let q = n.wrapping_div_euclid(d);
    let r = n.wrapping_sub(q.wrapping_mul(d));
    (
        q.clamp(i64::from(i32::MIN), i64::from(i32::MAX)) as i32,
        r as i32,
    )
}
