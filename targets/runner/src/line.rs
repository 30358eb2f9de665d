//! One line of JSON in a fixed buffer, without `core::fmt`.

/// Bytes that a line can hold; what does not fit is dropped, which the reader
/// notices, because the closing brace is missing.
const CAPACITY: usize = 256;

/// A JSON object on one line, built field by field.
#[derive(Clone, Debug)]
pub struct Line {
    text: [u8; CAPACITY],
    length: usize,
}

impl Line {
    /// An object without fields so far.
    pub const fn new() -> Self {
        Self {
            text: [0; CAPACITY],
            length: 0,
        }
    }

    /// Adds a number of at most 32 bits: small cores divide 64 bits by a
    /// library routine, which a demo shall not carry for this.
    pub fn small(&mut self, name: &str, value: u32) -> &mut Self {
        self.name(name);
        self.small_decimal(value);
        self
    }

    /// Adds a number.
    pub fn number(&mut self, name: &str, value: u64) -> &mut Self {
        self.name(name);
        let mut value = value;
        self.decimal(|| {
            let digit = value % 10;
            value /= 10;
            (digit as u8, value == 0)
        });
        self
    }

    /// Adds a text, which must need no escapes.
    pub fn text(&mut self, name: &str, value: &str) -> &mut Self {
        self.name(name);
        self.push(b'"');
        self.push_all(value.as_bytes());
        self.push(b'"');
        self
    }

    /// Adds 64 bits as a text of 16 hexadecimal digits.
    pub fn hex(&mut self, name: &str, value: u64) -> &mut Self {
        self.name(name);
        self.push(b'"');
        let mut shift = 64;
        while shift > 0 {
            shift -= 4;
            let digit = (value >> shift) as u8 & 15;
            self.push(if digit < 10 {
                b'0' + digit
            } else {
                b'a' - 10 + digit
            });
        }
        self.push(b'"');
        self
    }

    /// Closes the object and the line, and hands the text over.
    pub fn end(&mut self, print: impl FnOnce(&[u8])) {
        if self.length == 0 {
            self.push(b'{');
        }
        self.push_all(b"}\n");
        print(self.text.get(..self.length).unwrap_or(&[]));
    }

    fn name(&mut self, name: &str) {
        self.push(if self.length == 0 { b'{' } else { b',' });
        self.push(b'"');
        self.push_all(name.as_bytes());
        self.push_all(b"\":");
    }

    /// A digit a call: less code than a list of digits.
    #[inline(never)]
    fn small_decimal(&mut self, value: u32) {
        if value >= 10 {
            self.small_decimal(value / 10);
        }
        self.push(b'0' + (value % 10) as u8);
    }

    /// `next` gives the digits from the last to the first, and whether that
    /// was the first.
    fn decimal(&mut self, mut next: impl FnMut() -> (u8, bool)) {
        let mut digits = [0; 20];
        let mut used = 0;
        for place in digits.iter_mut().rev() {
            let (digit, first) = next();
            *place = b'0' + digit;
            used += 1;
            if first {
                break;
            }
        }
        for &digit in digits.iter().skip(digits.len().wrapping_sub(used)) {
            self.push(digit);
        }
    }

    #[inline(never)]
    fn push_all(&mut self, bytes: &[u8]) {
        for &byte in bytes {
            self.push(byte);
        }
    }

    #[inline(never)]
    fn push(&mut self, byte: u8) {
        if let Some(place) = self.text.get_mut(self.length) {
            *place = byte;
            self.length += 1;
        }
    }
}

impl Default for Line {
    fn default() -> Self {
        Self::new()
    }
}

#[cfg(test)]
mod tests {
    extern crate std;
    use super::*;
    use std::string::String;

    fn text(line: &mut Line) -> String {
        let mut out = std::vec::Vec::new();
        line.end(|text| out.extend_from_slice(text));
        String::from_utf8(out).unwrap_or_default()
    }

    #[test]
    fn fields_in_order() {
        let mut line = Line::new();
        line.small("a", 0)
            .number("b", u64::MAX)
            .hex("c", 0x0123_4567_89ab_cdef)
            .text("d", "x");
        assert_eq!(
            text(&mut line),
            "{\"a\":0,\"b\":18446744073709551615,\"c\":\"0123456789abcdef\",\"d\":\"x\"}\n"
        );
        assert_eq!(text(&mut Line::new()), "{}\n");
    }

    #[test]
    fn too_long_is_cut_without_a_brace() {
        let long = "0123456789".repeat(30);
        let cut = text(Line::new().text("a", &long));
        assert_eq!(cut.len(), CAPACITY);
        assert!(!cut.ends_with("}\n"));
    }
}
