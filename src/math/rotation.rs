//! Rotation matrices in Q30.

use super::{Angle, Unit3, dot, keep_rolled, product};

/// A rotation: three rows of Q30 entries.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Rotation {
    /// Rows.
    pub rows: [Unit3; 3],
}

const ONE: i32 = 1 << 30;

impl Rotation {
    /// Leaves everything in place.
    pub const IDENTITY: Self = Self {
        rows: [[ONE, 0, 0], [0, ONE, 0], [0, 0, ONE]],
    };

    /// About the x axis: y turns towards z.
    pub fn about_x(angle: Angle) -> Self {
        let (s, c) = angle.sin_cos();
        Self {
            rows: [[ONE, 0, 0], [0, c, -s], [0, s, c]],
        }
    }

    /// About the y axis: z turns towards x.
    pub fn about_y(angle: Angle) -> Self {
        let (s, c) = angle.sin_cos();
        Self {
            rows: [[c, 0, s], [0, ONE, 0], [-s, 0, c]],
        }
    }

    /// About the z axis: x turns towards y.
    pub fn about_z(angle: Angle) -> Self {
        let (s, c) = angle.sin_cos();
        Self {
            rows: [[c, -s, 0], [s, c, 0], [0, 0, ONE]],
        }
    }

    /// About an axis of any direction, counter-clockwise seen against it
    /// (Rodrigues' formula).
    pub fn about(axis: Unit3, angle: Angle) -> Self {
        let (s, c) = angle.sin_cos();
        let scale = |a: i32, by: i64| ((i64::from(a) * by + (1 << 29)) >> 30) as i32;
        let [sx, sy, sz] = axis.map(|a| scale(a, s.into()));
        let [nx, ny, nz] = [sx, sy, sz].map(i32::wrapping_neg);
        let across = [[0, nz, sy], [sz, 0, nx], [ny, sx, 0]];
        let mut rows = Self {
            rows: [[c, 0, 0], [0, c, 0], [0, 0, c]],
        };
        for ((row, across), a) in rows.rows.iter_mut().zip(across).zip(axis) {
            for ((entry, across), b) in row.iter_mut().zip(across).zip(axis) {
                let both = scale(a, b.into());
                let rest = scale(both, i64::from(ONE) - i64::from(c));
                *entry = entry.wrapping_add(across).wrapping_add(rest);
            }
        }
        rows
    }

    /// About y, then x, then z: VTK's order for an actor's orientation.
    #[inline(never)] // once an actor: small code
    pub fn from_orientation([x, y, z]: [Angle; 3]) -> Self {
        let mut rotation = Self::about_y(y);
        let [first, second, third] = &mut rotation.rows;
        turn(second, third, x);
        turn(first, second, z);
        rotation
    }

    /// First `self`, then `next`: the matrix product `next * self`.
    #[must_use]
    #[inline(never)]
    pub fn then(&self, next: &Self) -> Self {
        let columns = self.transposed().rows;
        let mut product = Self { rows: [[0; 3]; 3] };
        for (to, row) in product.rows.iter_mut().zip(next.rows) {
            for (to, column) in to.iter_mut().zip(columns) {
                *to = dot(row, column);
                keep_rolled();
            }
        }
        product
    }

    /// The inverse.
    #[must_use]
    pub fn transposed(&self) -> Self {
        let [[a, b, c], [d, e, f], [g, h, i]] = self.rows;
        Self {
            rows: [[a, d, g], [b, e, h], [c, f, i]],
        }
    }

    /// Turns a direction.
    pub fn apply(&self, v: Unit3) -> Unit3 {
        self.rows.map(|row| dot(row, v))
    }

    /// Turns a vector of any scale below 2^47, rounded down; what is longer turns into anything.
    #[inline(never)]
    pub fn apply_wide(&self, [x, y, z]: [i64; 3]) -> [i64; 3] {
        self.rows.map(|row| turned(row, [x, y, z]))
    }
}

/// Turns what a row of a rotation gives towards what another one gives: the product with a
/// rotation about the axis of the third, to the last bit, of which half is 0 and 1.
#[inline(never)]
fn turn(from: &mut Unit3, to: &mut Unit3, angle: Angle) {
    if angle == Angle::ZERO {
        return;
    }
    let (s, c) = angle.sin_cos();
    for (a, b) in from.iter_mut().zip(to) {
        let turned = |by_a: i32, by_b: i32| {
            let sum = product(by_a, *a) + product(by_b, *b);
            ((sum + (1 << 29)) >> 30) as i32
        };
        (*a, *b) = (turned(c, -s), turned(s, c));
        keep_rolled();
    }
}

/// A row by a vector, as [`scale_q30`] has the products.
#[inline(always)]
pub(super) fn turned([a, b, c]: Unit3, [x, y, z]: [i64; 3]) -> i64 {
    let two = scale_q30(a, x).wrapping_add(scale_q30(b, y));
    two.wrapping_add(scale_q30(c, z))
}

/// `a * v / 2^30` for `|v| < 2^48`, rounded down, without 128-bit products.
#[inline(never)]
fn scale_q30(a: i32, v: i64) -> i64 {
    // 31 bits and a sign, and 17.
    let (high, low) = ((v >> 17) as i32, (v & 0x1_ffff) as i32);
    // a * high is a multiple of 2^17 in the product's scale.
    (product(a, high) + (product(a, low) >> 17)) >> 13
}
