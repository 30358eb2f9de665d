//! Files, whole or not at all, and standard output.

use crate::args::Destination;
use anyhow::{Context, Result};
use serde::Serialize;
use std::fs::{self, File};
use std::io::{self, Write};
use std::path::Path;

/// Writes a file by way of a temporary one in the same folder, so that no one
/// ever sees a part of it. What is there and no plain file (such as
/// `/dev/null`) is written to as it is; a link keeps pointing at its target.
pub fn write(path: &Path, bytes: &[u8]) -> Result<()> {
    write_whole(path, bytes).with_context(|| format!("cannot write {}", path.display()))
}

fn write_whole(path: &Path, bytes: &[u8]) -> io::Result<()> {
    let target = match fs::metadata(path) {
        // A folder refuses.
        Ok(there) if !there.is_file() => return fs::write(path, bytes),
        Ok(_) => fs::canonicalize(path)?,
        Err(_) => path.to_owned(),
    };
    let name = target.file_name().ok_or(io::ErrorKind::InvalidInput)?;
    let mut temporary_name = std::ffi::OsString::from(".");
    temporary_name.push(name);
    temporary_name.push(format!(".{}.tmp", std::process::id()));
    let temporary = target.with_file_name(temporary_name);
    let written = File::create(&temporary)
        .and_then(|mut file| file.write_all(bytes).and_then(|()| file.sync_all()))
        .and_then(|()| fs::rename(&temporary, &target));
    if written.is_err() {
        // The first error is the one to tell.
        let _ = fs::remove_file(&temporary);
    }
    written
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

/// A PNG of 8 bits a channel.
pub fn png_rgb(width: u32, height: u32, pixels: &[[u8; 3]]) -> Result<Vec<u8>> {
    png(
        width,
        height,
        png::ColorType::Rgb,
        png::BitDepth::Eight,
        pixels.as_flattened(),
    )
}

/// A PNG of 16-bit greys.
pub fn png_grey16(width: u32, height: u32, pixels: &[u16]) -> Result<Vec<u8>> {
    let bytes: Vec<u8> = pixels.iter().flat_map(|v| v.to_be_bytes()).collect();
    png(
        width,
        height,
        png::ColorType::Grayscale,
        png::BitDepth::Sixteen,
        &bytes,
    )
}

fn png(
    width: u32,
    height: u32,
    colour: png::ColorType,
    depth: png::BitDepth,
    bytes: &[u8],
) -> Result<Vec<u8>> {
    let mut file = Vec::new();
    let mut encoder = png::Encoder::new(&mut file, width, height);
    encoder.set_color(colour);
    encoder.set_depth(depth);
    encoder.write_header()?.write_image_data(bytes)?;
    Ok(file)
}
