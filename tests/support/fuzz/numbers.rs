//! Numbers out of bytes.

/// Bytes that are taken one after the other; zeros after the last.
#[derive(Clone, Copy, Debug)]
pub struct Numbers<'a>(pub &'a [u8]);

impl Numbers<'_> {
    pub fn byte(&mut self) -> u8 {
        let Some((first, rest)) = self.0.split_first() else {
            return 0;
        };
        self.0 = rest;
        *first
    }

    pub fn word(&mut self) -> u32 {
        u32::from_le_bytes([0; 4].map(|_| self.byte()))
    }

    /// A number below `end`, which is at most 256.
    pub fn below(&mut self, end: usize) -> usize {
        usize::from(self.byte()) % end
    }

    pub fn one_of<T: Copy>(&mut self, all: &[T]) -> T {
        all[self.below(all.len())]
    }

    /// A whole number that is often at an end of its range or beside a power of two.
    pub fn extreme(&mut self) -> i32 {
        let power = 1i32.wrapping_shl(self.byte().into());
        match self.below(8) {
            0 => 0,
            1 => i32::MIN,
            2 => i32::MAX,
            3 => power,
            4 => power.wrapping_neg(),
            5 => power.wrapping_sub(1),
            6 => i32::from(self.byte()) - 128,
            _ => self.word() as i32,
        }
    }

    /// The same of 64 bits.
    pub fn wide(&mut self) -> i64 {
        let shift = self.byte() % 64;
        match self.below(4) {
            0 => i64::from(self.extreme()) << shift,
            1 => i64::MIN >> shift,
            2 => i64::MAX >> shift,
            _ => i64::from(self.extreme()) << 32 | i64::from(self.word()),
        }
    }

    /// A number from `low` to `high`, sometimes one of these or 0.
    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        match self.below(16) {
            0 => 0.0_f64.clamp(low, high),
            1 => low,
            2 => high,
            // Of a grid, so that things coincide.
            3..=6 => low + (high - low) * f64::from(self.byte() / 16) / 16.0,
            _ => low + (high - low) * f64::from(self.word()) / f64::from(u32::MAX),
        }
    }

    pub fn place(&mut self, reach: f64) -> [f64; 3] {
        [0; 3].map(|_| self.between(-reach, reach))
    }
}
