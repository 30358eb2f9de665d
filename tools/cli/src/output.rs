//! Figures to a file, and standard output.

use crate::args::Destination;
use anyhow::{Context, Result, ensure};
use serde::Serialize;
use std::io::{self, Write};
use std::path::Path;

pub use fixel_output::{png_grey16, png_rgb};

/// Writes a file, whole or not at all.
pub fn write(path: &Path, bytes: &[u8]) -> Result<()> {
    Ok(fixel_output::write(path, bytes)?)
}

/// Refuses `-`, which stands for standard output where JSON goes, and is no file here.
pub fn refuse_stdout(path: &Path) -> Result<()> {
    let is_stdout = path == Path::new("-");
    ensure!(
        !is_stdout,
        "-: standard output takes JSON and text alone; expected the name of a file"
    );
    Ok(())
}

/// Refuses names that promise another kind of picture than is written. One without an ending
/// may be a device.
pub fn refuse_other_than_png(path: &Path) -> Result<()> {
    refuse_stdout(path)?;
    let kind = path.extension();
    let png = kind.is_none_or(|kind| kind.eq_ignore_ascii_case("png"));
    ensure!(
        png,
        "{}: pictures are written as PNG; expected a name that ends in .png, such as frame.png",
        path.display()
    );
    Ok(())
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
