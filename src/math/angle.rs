//! Angles and their sine and cosine.

/// An angle in binary turns: 2^32 is one turn, so that it wraps as an angle
/// does. Positive is counter-clockwise seen against the axis.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Angle(u32);

/// Steps of the sine table in a quarter turn.
const STEPS: usize = 64;

/// `sin(i / 64 of a quarter turn)` in Q30, made by the compiler in integers.
const SINES: [i32; STEPS + 1] = sines();

/// pi / 2 in Q60.
const QUARTER_Q60: i128 = 1_811_004_864_519_280_710;

/// Table by Taylor's series in Q60: 12 terms are exact to the last bit of Q30.
const fn sines() -> [i32; STEPS + 1] {
    let mut table = [0i32; STEPS + 1];
    let mut i = 0;
    while i <= STEPS {
        let x = QUARTER_Q60 * i as i128 / STEPS as i128;
        let square = (x * x) >> 60;
        let mut term = x;
        let mut sum = x;
        let mut k = 1;
        while k < 12 {
            term = -((term * square) >> 60) / ((2 * k) * (2 * k + 1));
            sum += term;
            k += 1;
        }
        #[expect(clippy::indexing_slicing, reason = "evaluated by the compiler")]
        {
            table[i] = ((sum + (1 << 29)) >> 30) as i32;
        }
        i += 1;
    }
    table
}

impl Angle {
    /// No turn.
    pub const ZERO: Self = Self(0);
    /// A quarter of a turn.
    pub const QUARTER: Self = Self(1 << 30);

    /// From binary turns of 32 bits: 2^32 is one turn.
    pub const fn from_bits(bits: u32) -> Self {
        Self(bits)
    }

    /// From binary turns of 16 bits: 65536 is one turn.
    pub const fn from_turns16(turns: u16) -> Self {
        Self((turns as u32) << 16)
    }

    /// In binary turns of 32 bits.
    pub const fn to_bits(self) -> u32 {
        self.0
    }

    /// `numerator / denominator` of a turn, rounded down; a denominator of 0
    /// gives no turn.
    pub const fn fraction(numerator: u32, denominator: u32) -> Self {
        if denominator == 0 {
            return Self(0);
        }
        let part = (numerator % denominator) as u64;
        Self(((part << 32) / denominator as u64) as u32)
    }

    /// The angle in 0..a quarter turn with this tangent (in 2^-24), rounded down to
    /// what [`Angle::sin_cos`] tells apart: within 2^-27 turns.
    pub fn of_tangent(tangent: u32) -> Self {
        // From the highest bit, those that leave sin <= tangent * cos.
        let below = |angle: Self| {
            let (sin, cos) = angle.sin_cos();
            i64::from(sin) << 24 <= i64::from(tangent) * i64::from(cos)
        };
        let bits = (0..30).rev().map(|bit| 1u32 << bit);
        bits.fold(Self(0), |angle, bit| {
            let more = Self(angle.0 | bit);
            if below(more) { more } else { angle }
        })
    }

    /// The tangent in 2^-24, rounded to nearest; within 1..=2^32 - 1 for angles of
    /// up to a quarter turn.
    pub fn tangent(self) -> u32 {
        let (sin, cos) = self.sin_cos();
        let (sin, cos) = (i64::from(sin.max(0)), i64::from(cos.max(1)));
        let quotient = ((sin << 24) + cos / 2) / cos;
        quotient.clamp(1, i64::from(u32::MAX)) as u32
    }

    /// The sum, wrapping at a full turn.
    #[must_use]
    pub const fn plus(self, other: Self) -> Self {
        Self(self.0.wrapping_add(other.0))
    }

    /// Sine and cosine in Q30. Error below 2^-28, tested over the whole range:
    /// the nearest of 64 table steps a quarter turn, and the addition theorem
    /// with Taylor's series for the rest.
    #[inline(never)]
    pub fn sin_cos(self) -> (i32, i32) {
        const STEP_BITS: u32 = 30 - 6;
        if self == Self::ZERO {
            // As many things stand.
            return (0, 1 << 30);
        }
        let in_quarter = (self.0 & 0x3fff_ffff).wrapping_add(1 << (STEP_BITS - 1));
        let step = (in_quarter >> STEP_BITS) as usize; // 0..=64, the nearest
        let rest = (in_quarter & ((1 << STEP_BITS) - 1)) as i64 - (1 << (STEP_BITS - 1));

        #[expect(clippy::indexing_slicing, reason = "step is 0..=64 of 65 entries")]
        let (sin_a, cos_a) = (i64::from(SINES[step]), i64::from(SINES[STEPS - step]));

        // rest is in 2^-32 turns, at most 2^-9 turns: radians in Q36, from 2 pi /
        // 2^32 in Q64.
        let d = (rest * 26_986_075_409) >> 28;
        let square = (d * d) >> 36;
        let cos_d = (1i64 << 36) - (square >> 1) + ((square * square) >> 36) / 24;
        let sin_d = d - ((d * square) >> 36) / 6;
        // Q30 times Q30: 60 bits and a sign.
        let (cos_d, sin_d) = ((cos_d + 32) >> 6, (sin_d + 32) >> 6);
        let round = 1i64 << 29;
        let sin = ((sin_a * cos_d + cos_a * sin_d + round) >> 30) as i32;
        let cos = ((cos_a * cos_d - sin_a * sin_d + round) >> 30) as i32;
        match self.0 >> 30 {
            0 => (sin, cos),
            1 => (cos, -sin),
            2 => (-sin, -cos),
            _ => (-cos, sin),
        }
    }
}
