//! Which way a few triangles face.

/// Which way some triangles of a meshlet face, in three bytes: all of them are seen from
/// behind by an eye from which
///
/// ```text
/// axis . (base - eye) >= spread * |base - eye| + 2 * offset * radius
/// ```
///
/// with the meshlet's base and radius. An axis may have any length, so that short numbers
/// meet many directions; `spread` is that length times the sine of the widest angle to it, and
/// `offset` says how far the faces' planes are behind the base.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FaceCone {
    /// -15..=15 each.
    pub axis: [i8; 3],
    /// 0..=31.
    pub spread: u8,
    /// -8..=7.
    pub offset: i8,
}

impl FaceCone {
    /// Of triangles that face all ways.
    pub const NEVER: Self = Self {
        axis: [0; 3],
        spread: 31,
        offset: 7,
    };

    /// As it is stored: x in the highest five bits, then y, z, spread (five bits each) and
    /// offset, little-endian.
    #[inline(always)]
    pub fn from_bytes([low, middle, high]: [u8; 3]) -> Self {
        let word = i32::from_le_bytes([0, low, middle, high]);
        let part = |up: u32| (word << up >> 27) as i8;
        Self {
            axis: [part(0), part(5), part(10)],
            spread: ((word << 15) as u32 >> 27) as u8,
            offset: (word << 20 >> 28) as i8,
        }
    }

    /// As it is stored.
    pub fn to_bytes(&self) -> [u8; 3] {
        let [x, y, z] = self.axis.map(|c| u32::from(c as u8) & 31);
        let (spread, offset) = (
            u32::from(self.spread & 31),
            u32::from(self.offset as u8) & 15,
        );
        let word = x << 19 | y << 14 | z << 9 | spread << 4 | offset;
        let [low, middle, high, _] = word.to_le_bytes();
        [low, middle, high]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bytes_are_what_they_were_made_of() {
        let cone = FaceCone {
            axis: [-15, 15, -1],
            spread: 30,
            offset: -8,
        };
        for cone in [cone, FaceCone::NEVER] {
            assert_eq!(FaceCone::from_bytes(cone.to_bytes()), cone);
        }
    }
}
