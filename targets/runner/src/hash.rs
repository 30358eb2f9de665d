//! FNV-1a, 64 bits (Fowler, Noll, Vo; draft-eastlake-fnv): small, and the same
//! on every target.

/// A running FNV-1a hash.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Fnv64(u64);

impl Fnv64 {
    /// The hash of nothing: the offset basis.
    pub const fn new() -> Self {
        Self(0xcbf2_9ce4_8422_2325)
    }

    /// Takes in one byte.
    pub const fn byte(&mut self, byte: u8) {
        self.0 = (self.0 ^ byte as u64).wrapping_mul(0x0000_0100_0000_01b3);
    }

    /// Takes in bytes in order.
    pub fn bytes(&mut self, bytes: &[u8]) {
        for &byte in bytes {
            self.byte(byte);
        }
    }

    /// Takes in 16-bit words, the low byte of each first.
    pub fn words(&mut self, words: &[u16]) {
        for &word in words {
            let [low, high] = word.to_le_bytes();
            self.byte(low);
            self.byte(high);
        }
    }

    /// The hash so far.
    pub const fn value(&self) -> u64 {
        self.0
    }
}

impl Default for Fnv64 {
    fn default() -> Self {
        Self::new()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn hash(bytes: &[u8]) -> u64 {
        let mut hash = Fnv64::new();
        hash.bytes(bytes);
        hash.value()
    }

    /// Values published with the draft.
    #[test]
    fn published_values() {
        assert_eq!(hash(b""), 0xcbf2_9ce4_8422_2325);
        assert_eq!(hash(b"a"), 0xaf63_dc4c_8601_ec8c);
        assert_eq!(hash(b"foobar"), 0x8594_4171_f739_67e8);
    }

    #[test]
    fn words_are_little_endian_bytes() {
        let mut words = Fnv64::new();
        words.words(&[0x2211, 0x4433]);
        assert_eq!(words.value(), hash(&[0x11, 0x22, 0x33, 0x44]));
    }
}
