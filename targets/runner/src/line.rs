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

    /// Adds a number.
    #[must_use]
    pub fn number(mut self, name: &str, value: u64) -> Self {
        self.name(name);
        self.decimal(value);
        self
    }

    /// Adds a text, which must need no escapes.
    #[must_use]
    pub fn text(mut self, name: &str, value: &str) -> Self {
        self.name(name);
        self.push(b'"');
        self.push_all(value.as_bytes());
        self.push(b'"');
        self
    }

    /// Adds 64 bits as a text of 16 hexadecimal digits.
    #[must_use]
    pub fn hex(mut self, name: &str, value: u64) -> Self {
        self.name(name);
        self.push(b'"');
        let mut shift = 64;
        while shift > 0 {
            shift -= 4;
            let digit = (value >> shift) as u8 & 15;
            self.push(if digit < 10 { b'0' + digit } else { b'a' - 10 + digit });
        }
        self.push(b'"');
        self
    }

    /// Closes the object and the line, and hands the text over.
    pub fn end(mut self, print: impl FnOnce(&str)) {
        if self.length == 0 {
            self.push(b'{');
        }
        self.push_all(b"}\n");
        let bytes = self.text.get(..self.length).unwrap_or(&[]);
        print(core::str::from_utf8(bytes).unwrap_or("{}\n"));
    }

    fn name(&mut self, name: &str) {
        self.push(if self.length == 0 { b'{' } else { b',' });
        self.push(b'"');
        self.push_all(name.as_bytes());
        self.push_all(b"\":");
    }

    fn decimal(&mut self, mut value: u64) {
        let mut digits = [b'0'; 20];
        let mut used = 0;
        for digit in digits.iter_mut().rev() {
            *digit = b'0' + (value % 10) as u8;
            value /= 10;
            used += 1;
            if value == 0 {
                break;
            }
        }
        for &digit in digits.iter().skip(digits.len().wrapping_sub(used)) {
            self.push(digit);
        }
    }

    fn push_all(&mut self, bytes: &[u8]) {
        for &byte in bytes {
            self.push(byte);
        }
    }

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

    fn text(line: Line) -> String {
        let mut out = String::new();
        line.end(|text| out.push_str(text));
        out
    }

    #[test]
    fn fields_in_order() {
        let line = Line::new()
            .number("a", 0)
            .number("b", u64::MAX)
            .hex("c", 0x0123_4567_89ab_cdef)
            .text("d", "x");
        assert_eq!(
            text(line),
            "{\"a\":0,\"b\":18446744073709551615,\"c\":\"0123456789abcdef\",\"d\":\"x\"}\n"
        );
        assert_eq!(text(Line::new()), "{}\n");
    }

    #[test]
    fn too_long_is_cut_without_a_brace() {
        let long = "0123456789".repeat(30);
        let cut = text(Line::new().text("a", &long));
        assert_eq!(cut.len(), CAPACITY);
        assert!(!cut.ends_with("}\n"));
    }
}
