//! From the distance along the line of sight to a depth.

use super::ViewFrame;
use crate::math::{FineDepth, Reciprocal, mul_high};

/// Depth of a clip distance `d`: near / d for perspective, (far - d) /
/// (far - near) for parallel, times 65535, held in 0.5..=65535 so that what is
/// drawn differs from what is not.
#[derive(Clone, Copy, Debug)]
pub enum DepthMap {
    /// In inverse proportion to distance.
    Perspective(PerspectiveDepth),
    /// A straight line.
    Parallel {
        /// Depth at distance `reference`, raw [`FineDepth`].
        base: i32,
        /// A clip distance.
        reference: i32,
        /// Fall a unit of clip distance.
        mantissa: i32,
        /// Right shift of the product; negative: left shift of the distance.
        shift: i32,
    },
}

/// `near * 65535 * 16 = mantissa * 2^..`, the power folded into `shift`.
#[derive(Clone, Copy, Debug)]
pub struct PerspectiveDepth {
    /// 2^30..2^31.
    mantissa: i32,
    /// Right shift of the product, before the reciprocal's own shift.
    shift: i32,
}

impl PerspectiveDepth {
    /// The depth at a distance whose reciprocal is `recip`.
    #[inline(always)]
    pub fn depth(self, recip: Reciprocal) -> FineDepth {
        let product = mul_high(self.mantissa, recip.mantissa);
        held(round_shift(product, self.shift - recip.shift as i32))
    }
}

/// The least depth, raw [`FineDepth`]: just rounds to 1, so that what lies on the
/// far plane of a parallel view is drawn, and off by no more than that.
const LEAST: i32 = 9;

/// 65535 in raw [`FineDepth`].
const ONE: u64 = 65535 << 4;

impl DepthMap {
    /// No view's.
    pub(super) const ZERO: Self = Self::Perspective(PerspectiveDepth {
        mantissa: 0,
        shift: 0,
    });

    /// As near as depth goes, wherever.
    pub(super) const NEAREST: Self = Self::Parallel {
        base: ONE as i32,
        reference: 0,
        mantissa: 0,
        shift: 0,
    };

    /// For clip distances that are world distances times `2^scale`, where the near
    /// plane's is `near`.
    #[inline(never)]
    pub(crate) fn new(frame: &ViewFrame, scale: i32, near: i32) -> Self {
        if frame.perspective {
            let (mantissa, bits) = top_31_bits(frame.near.unsigned_abs().saturating_mul(ONE));
            // near has 16 fractional bits; 62 is the reciprocal's scale, 32 the
            // high product's.
            let shift = 62 - 32 - (bits - 31) - (scale - 16);
            return Self::Perspective(PerspectiveDepth { mantissa, shift });
        }
        let range = frame.far.saturating_sub(frame.near).unsigned_abs();
        let (mantissa, bits) = top_31_bits((ONE << 43).checked_div(range).unwrap_or(ONE));
        // Fall a world unit: quotient * 2^(16 - 43).
        let shift = scale + (43 - 16) - (bits - 31) - 32;
        // Depth at the eye, or at the near plane if that is too far away from the
        // eye, in terms of the range, for a number of this format.
        let at_eye = frame
            .far
            .saturating_mul(ONE as i64)
            .checked_div(range as i64)
            .unwrap_or(0);
        let (base, reference) = match i32::try_from(at_eye) {
            Ok(at_eye) if at_eye.abs() < 1 << 28 => (at_eye, 0),
            _ => (ONE as i32, near),
        };
        Self::Parallel {
            base,
            reference,
            mantissa,
            shift,
        }
    }

    /// The depth at distance `d`, whose reciprocal is `recip` (perspective).
    #[inline(always)]
    pub fn depth(&self, d: i32, recip: Reciprocal) -> FineDepth {
        match *self {
            Self::Perspective(map) => map.depth(recip),
            Self::Parallel {
                base,
                reference,
                mantissa,
                shift,
            } => {
                // To the left before the product cuts bits off. What that saturates is
                // beyond both planes: 2^29 or more, twice what a base can be.
                let up = 1 << shift.wrapping_neg().clamp(0, 30);
                let behind = d.saturating_sub(reference).saturating_mul(up);
                held(base.saturating_sub(round_shift(mul_high(mantissa, behind), shift.max(0))))
            }
        }
    }
}

#[inline(always)]
fn held(depth: i32) -> FineDepth {
    FineDepth::from_bits(depth.clamp(LEAST, ONE as i32) as u32)
}

/// `v / 2^by` rounded to nearest; saturates to the left.
#[inline(always)]
fn round_shift(v: i32, by: i32) -> i32 {
    if by > 0 {
        let by = by.min(31);
        // v is a high product, below 2^30: the sum fits.
        v.wrapping_add(1 << (by - 1)) >> by
    } else {
        v.saturating_mul(1 << by.wrapping_neg().clamp(0, 30))
    }
}

/// The 31 highest bits and how many bits there were.
fn top_31_bits(v: u64) -> (i32, i32) {
    let bits = 64 - v.leading_zeros() as i32;
    let mantissa = if bits > 31 {
        v >> (bits - 31)
    } else {
        v << (31 - bits)
    };
    (mantissa as i32, bits)
}
