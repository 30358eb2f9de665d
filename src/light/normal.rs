//! Normals as a mesh stores them, as directions of length 1.

use crate::math::{ShortUnit, decode_octahedral};

/// A vertex normal from its two bytes, and of a fine mesh the byte with 4 more bits
/// each.
pub fn vertex_normal(code: i16, low: Option<u8>) -> ShortUnit {
    let code = code.to_le_bytes().map(|b| i32::from(b as i8));
    let (code, extra) = match low {
        Some(low) => {
            let ([u, v], low) = (code, i32::from(low));
            ([u << 4 | low & 15, v << 4 | low >> 4], 4)
        }
        None => (code, 0),
    };
    let (normal, recip) = decode_octahedral(code, extra);
    // 8 bits (12 of a fine mesh) and 16.
    normal.map(|c| (c * recip as i32 + (1 << (7 + extra))) >> (8 + extra))
}

/// A face's normal from its packed form: 10 bits and a sign each for x, y and z, from
/// the lowest, 511 is 1.
pub fn face_normal(packed: u32) -> ShortUnit {
    // 2^14 / 511, 10 fractional bits.
    const ONE: i32 = ((1 << 24) + 255) / 511;
    let part = |shift: u32| (packed as i32) << shift >> 22;
    [part(22), part(12), part(2)].map(|c| (c * ONE + (1 << 9)) >> 10)
}
