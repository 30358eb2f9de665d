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

/// Messages may quote input or come from a crate that likes several lines.
fn one_line(message: &str) -> String {
    message.split_whitespace().collect::<Vec<_>>().join(" ")
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
