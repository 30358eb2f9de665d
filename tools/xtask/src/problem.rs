//! What can go wrong: something that this machine lacks, so that a test is
//! skipped, or something that failed.

use std::fmt;

/// Why a step did not succeed.
#[derive(Clone, Debug)]
pub enum Problem {
    /// The machine lacks a program or a target; the text says which command
    /// would bring it. A test is then skipped, visibly.
    Missing(String),
    /// It failed.
    Failed(String),
}

impl fmt::Display for Problem {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Missing(text) | Self::Failed(text) => f.write_str(text),
        }
    }
}

impl From<String> for Problem {
    fn from(text: String) -> Self {
        Self::Failed(text)
    }
}

impl From<&str> for Problem {
    fn from(text: &str) -> Self {
        Self::Failed(text.to_owned())
    }
}

impl From<fixel_output::Error> for Problem {
    fn from(error: fixel_output::Error) -> Self {
        Self::Failed(error.to_string())
    }
}

/// What a step gives.
pub type Result<T> = std::result::Result<T, Problem>;
