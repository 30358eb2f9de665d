//! What is wrong with an input file, and where.

use std::fmt;
use std::path::{Path, PathBuf};

/// Why a scene or a mesh was refused. `Display` gives one line:
/// `file:line: field: what is wrong; expected ...`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Error {
    /// The file that holds the mistake.
    pub file: PathBuf,
    /// Its line, from 1, if the file is text and the mistake has a place.
    pub line: Option<usize>,
    /// Column in characters, from 1, for mistakes of syntax.
    pub column: Option<usize>,
    /// Field, what is wrong, what is expected. One line.
    pub message: String,
}

impl Error {
    /// A mistake in the file as a whole.
    pub(crate) fn new(file: &Path, message: impl Into<String>) -> Self {
        Self {
            file: file.to_owned(),
            line: None,
            column: None,
            message: one_line(&message.into()),
        }
    }

    /// A mistake in one line of the file.
    pub(crate) fn at_line(file: &Path, line: usize, message: impl Into<String>) -> Self {
        Self {
            line: Some(line),
            ..Self::new(file, message)
        }
    }
}

/// A message as one line that a terminal can show, its middle left out if it is long. Messages
/// may quote input, which may hold what a terminal takes for orders, or be as long as a file;
/// or come from a crate that likes several lines.
pub fn one_line(message: &str) -> String {
    const BEGIN: usize = 700;
    const END: usize = 300;
    let words = message.split_whitespace().collect::<Vec<_>>().join(" ");
    let mut line = String::new();
    let count = words.chars().count();
    for (at, c) in words.chars().enumerate() {
        match c {
            _ if at == BEGIN && count > BEGIN + END => line.push_str(" ... "),
            _ if at > BEGIN && at + END < count => {}
            c if c.is_control() => line.extend(c.escape_default()),
            // They turn the direction of what comes after them.
            '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}' => line.extend(c.escape_unicode()),
            c => line.push(c),
        }
    }
    line
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.file.display())?;
        if let Some(line) = self.line {
            write!(f, ":{line}")?;
        }
        if let Some(column) = self.column {
            write!(f, ":{column}")?;
        }
        write!(f, ": {}", self.message)
    }
}

impl std::error::Error for Error {}

#[cfg(test)]
mod tests {
    use super::one_line;

    #[test]
    fn a_message_is_a_line_that_a_terminal_can_show() {
        assert_eq!(one_line("a\n  b\tc "), "a b c");
        assert_eq!(
            one_line("\u{1b}[2Jé\u{7}\u{202e}x"),
            "\\u{1b}[2Jé\\u{7}\\u{202e}x"
        );
        let line = one_line(&format!("begin {}; end", "x".repeat(5_000_000)));
        assert_eq!(line.chars().count(), 1005);
        assert!(
            line.starts_with("begin xx") && line.ends_with("xx; end"),
            "{line}"
        );
        assert!(line.contains("x ... x"), "{line}");
        assert_eq!(one_line(&"x".repeat(1000)).len(), 1000);
    }
}
