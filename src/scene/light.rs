//! Lights, as a blob has them.

use super::Record;
use super::records::{i, u, w};
use crate::math::Scaled;

/// Kinds of light.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LightKind {
    /// From infinitely far.
    Directional,
    /// From a place to all sides.
    Point,
    /// From a place, within a cone.
    Spot,
}

impl LightKind {
    /// All, in the order of their codes.
    pub const ALL: [Self; 3] = [Self::Directional, Self::Point, Self::Spot];
}

/// A light that has a direction or a place.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Light {
    /// Its kind.
    pub kind: LightKind,
    /// From the surface to a directional light, or from where a spot shines to the
    /// spot; length 1, Q30.
    pub towards: [i32; 3],
    /// Where it is, raw world bits.
    pub position: [i32; 3],
    /// Red, green and blue times intensity in 2^-16, at most 32.
    pub colour: [u32; 3],
    /// `[c, l, q]`: light at `d` world units is divided by `c + l d + q d^2`.
    pub attenuation: [Scaled; 3],
    /// Cosine of the angle from a spot's axis to its edge, Q30.
    pub cone: i32,
    /// How much a spot's light is gathered about its axis, 8 fractional bits.
    pub exponent: u16,
}

impl Light {
    /// Whether it is directional and grey, so that a level is all there is to it.
    pub fn is_plain(&self) -> bool {
        let [r, g, b] = self.colour;
        self.kind == LightKind::Directional && r == g && g == b
    }
}

impl Record for Light {
    type Words = [u32; 15];

    fn from_words(words: &Self::Words) -> Self {
        let [head, x, y, z, px, py, pz, r, g, b, c, l, q, powers, cone] = *words;
        let [kind, _, low, high] = head.to_ne_bytes();
        let [power_c, power_l, power_q, _] = powers.to_ne_bytes();
        let scaled = |mantissa, power: u8| Scaled::new(u(mantissa), i32::from(power as i8));
        Self {
            kind: LightKind::ALL
                .get(usize::from(kind))
                .copied()
                .unwrap_or(LightKind::Directional),
            towards: [i(x), i(y), i(z)],
            position: [i(px), i(py), i(pz)],
            colour: [u(r), u(g), u(b)],
            attenuation: [scaled(c, power_c), scaled(l, power_l), scaled(q, power_q)],
            cone: i(cone),
            exponent: u16::from_le_bytes([low, high]),
        }
    }

    fn to_words(&self) -> Self::Words {
        let [low, high] = self.exponent.to_le_bytes();
        let head = u32::from_ne_bytes([self.kind as u8, 0, low, high]);
        let ([x, y, z], [px, py, pz]) = (self.towards.map(w), self.position.map(w));
        let [r, g, b] = self.colour.map(u32::to_le);
        let [c, l, q] = self.attenuation.map(|s| s.mantissa().to_le());
        let [power_c, power_l, power_q] = self.attenuation.map(|s| s.exponent() as i8 as u8);
        let powers = u32::from_ne_bytes([power_c, power_l, power_q, 0]);
        [
            head,
            x,
            y,
            z,
            px,
            py,
            pz,
            r,
            g,
            b,
            c,
            l,
            q,
            powers,
            w(self.cone),
        ]
    }
}
