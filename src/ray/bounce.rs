//! Where rays go on: mirrored, straight, refracted.

use super::surface::Surface;
use crate::math::{Unit3, mul_high_u, mul_q30, reciprocal, root, unit};

const ONE: i32 = 1 << 30;

/// The normals of a surface on the side that a ray comes from.
#[derive(Clone, Copy, Debug)]
pub(super) struct Facing {
    normal: Unit3,
    face: Unit3,
}

fn dot([ax, ay, az]: Unit3, [bx, by, bz]: Unit3) -> i32 {
    mul_q30(ax, bx) + mul_q30(ay, by) + mul_q30(az, bz)
}

fn turned(v: Unit3, against: Unit3) -> Unit3 {
    if dot(v, against) > 0 {
        v.map(|c| -c)
    } else {
        v
    }
}

impl Facing {
    pub(super) fn new(surface: &Surface, direction: Unit3) -> Self {
        Self {
            normal: turned(surface.normal, direction),
            face: turned(surface.face, direction),
        }
    }

    /// Away from the surface, on the side that the ray comes from.
    pub(super) fn outward(&self) -> Unit3 {
        self.face
    }

    /// The mirrored direction.
    pub(super) fn mirrored(&self, direction: Unit3) -> Unit3 {
        let about = |normal: Unit3| {
            let twice = dot(direction, normal) * 2;
            let mut out = direction;
            for (c, n) in out.iter_mut().zip(normal) {
                *c -= mul_q30(twice, n);
            }
            unit(out).map_or(self.face, |(unit, _)| unit)
        };
        let way = about(self.normal);
        if dot(way, self.face) > 0 {
            way
        } else {
            about(self.face)
        }
    }

    /// The refracted direction, and the part that is mirrored (2^16 is 1), by Snell's
    /// and Fresnel's laws for unpolarised light; `None` where all of it is mirrored.
    /// `ratio` is the refractive index on the ray's side over that beyond, Q28.
    pub(super) fn refracted(&self, direction: Unit3, ratio: i32) -> Option<(Unit3, u32)> {
        let (way, mirrored) = refract(direction, self.normal, ratio)?;
        if dot(way, self.face) < 0 {
            return Some((way, mirrored));
        }
        refract(direction, self.face, ratio)
    }
}

fn refract(direction: Unit3, normal: Unit3, ratio: i32) -> Option<(Unit3, u32)> {
    let cosine = dot(direction, normal).saturating_neg().clamp(0, ONE);
    let sine_squared = ONE - mul_q30(cosine, cosine);
    // Q26: at most 16.
    let beyond = mul_q30(mul_q30(ratio, ratio), sine_squared);
    let left = (1i32 << 26).checked_sub(beyond).filter(|left| *left > 0)?;
    let cosine_beyond = root((left as u64) << 30) as i32; // Q28
    let bent = mul_q30(ratio, cosine);
    let along = bent - cosine_beyond;
    let mut way = direction.map(|c| mul_q30(ratio, c));
    for (c, n) in way.iter_mut().zip(normal) {
        *c += mul_q30(along, n);
    }
    // Amplitudes of both polarisations, over a common ratio of the indices.
    let across = fraction(bent - cosine_beyond, bent + cosine_beyond);
    let (a, b) = (mul_q30(ratio, cosine_beyond << 2), cosine >> 2);
    let within = fraction(a - b, a + b);
    let (unit, _) = unit(way)?;
    Some((unit, (across * across + within * within) >> 15))
}

/// `|part| / whole`, 2^15 is 1.
fn fraction(part: i32, whole: i32) -> u32 {
    let recip = reciprocal(whole.max(1) as u32);
    let part = part.unsigned_abs().min(whole.unsigned_abs());
    // 2^30 is 1.
    mul_high_u(part << recip.shift.min(31), recip.mantissa as u32) >> 15
}
