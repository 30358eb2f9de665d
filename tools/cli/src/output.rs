//! Figures to a file, and standard output.

use crate::args::Destination;
use anyhow::{Context, Result};
use serde::Serialize;
use std::io::{self, Write};
use std::path::Path;

pub use fixel_output::{png_grey16, png_rgb};

/// Writes a file, whole or not at all.
pub fn write(path: &Path, bytes: &[u8]) -> Result<()> {
    Ok(fixel_output::write(path, bytes)?)
}

/// Writes one JSON object, to a file or as all of standard output.
pub fn json(destination: &Destination, object: &impl Serialize) -> Result<()> {
    let text = serde_json::to_string_pretty(object)? + "\n";
    match destination {
        Destination::Stdout => stdout(&text),
        Destination::File(path) => write(path, text.as_bytes()),
    }
}

/// Writes to standard output.
pub fn stdout(text: &str) -> Result<()> {
    let mut out = io::stdout().lock();
    out.write_all(text.as_bytes())
        .and_then(|()| out.flush())
        .context("cannot write to standard output")
}
