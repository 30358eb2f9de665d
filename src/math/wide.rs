//! High halves of products, on cores that have them and on cores that do not
//! (ARMv6-M: a 64-bit product is a call of some 40 instructions). The results
//! are the same, which a test checks on random and on extreme factors.

/// High 32 bits of the 64-bit product, rounded down.
#[inline(always)]
pub fn mul_high(a: i32, b: i32) -> i32 {
    if cfg!(narrow_multiply) {
        mul_high_by_halves(a, b)
    } else {
        ((i64::from(a) * i64::from(b)) >> 32) as i32
    }
}

/// `a * b / 2^30`, rounded down, modulo 2^32.
#[inline(always)]
pub fn mul_q30(a: i32, b: i32) -> i32 {
    if cfg!(narrow_multiply) {
        let low = a.wrapping_mul(b) as u32;
        mul_high_by_halves(a, b).wrapping_shl(2) | (low >> 30) as i32
    } else {
        ((i64::from(a) * i64::from(b)) >> 30) as i32
    }
}

/// The product.
#[inline(always)]
pub fn product(a: i32, b: i32) -> i64 {
    if cfg!(narrow_multiply) {
        product_by_halves(a, b)
    } else {
        i64::from(a) * i64::from(b)
    }
}

/// The square in 64 bits.
#[inline(always)]
pub fn square(v: i32) -> u64 {
    if cfg!(narrow_multiply) {
        let v = v.unsigned_abs();
        u64::from(mul_high_u_by_halves(v, v)) << 32 | u64::from(v.wrapping_mul(v))
    } else {
        (i64::from(v) * i64::from(v)) as u64
    }
}

/// High 32 bits of the unsigned 64-bit product.
#[inline(always)]
pub(crate) fn mul_high_u(a: u32, b: u32) -> u32 {
    if cfg!(narrow_multiply) {
        mul_high_u_by_halves(a, b)
    } else {
        ((u64::from(a) * u64::from(b)) >> 32) as u32
    }
}

/// [`mul_high`] from four products of 16-bit halves (Knuth's algorithm M; see
/// Warren, "Hacker's Delight", section 8-2).
#[inline(always)]
pub(super) fn mul_high_by_halves(a: i32, b: i32) -> i32 {
    let (a_low, a_high) = (a & 0xffff, a >> 16);
    let (b_low, b_high) = (b & 0xffff, b >> 16);
    let low = a_low.wrapping_mul(b_low) as u32;
    let middle = a_high.wrapping_mul(b_low).wrapping_add((low >> 16) as i32);
    let carry = (middle & 0xffff).wrapping_add(a_low.wrapping_mul(b_high));
    a_high
        .wrapping_mul(b_high)
        .wrapping_add(middle >> 16)
        .wrapping_add(carry >> 16)
}

/// [`product`] from the high half's four products and the low half.
#[inline(always)]
pub(super) fn product_by_halves(a: i32, b: i32) -> i64 {
    i64::from(mul_high_by_halves(a, b)) << 32 | i64::from(a.wrapping_mul(b) as u32)
}

/// [`mul_high_u`] from four products of 16-bit halves.
#[inline(always)]
pub(super) fn mul_high_u_by_halves(a: u32, b: u32) -> u32 {
    let (a_low, a_high) = (a & 0xffff, a >> 16);
    let (b_low, b_high) = (b & 0xffff, b >> 16);
    // Hidden from the compiler, which would make a call for a 64-bit product of it.
    let low = core::hint::black_box((a_low * b_low) >> 16);
    let middle = (a_high * b_low).wrapping_add(low);
    let carry = (middle & 0xffff).wrapping_add(a_low * b_high);
    (a_high * b_high)
        .wrapping_add(middle >> 16)
        .wrapping_add(carry >> 16)
}
