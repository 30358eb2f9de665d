//! The scene that a command works on.

use crate::args::Frame;
use anyhow::{Result, bail};
use fixel_scene::Scene;
use std::path::Path;

/// Loads a scene or a mesh; what the loader has to say goes to standard error.
pub fn load(path: &Path) -> Result<Scene> {
    if path
        .extension()
        .is_some_and(|extension| extension.eq_ignore_ascii_case("fxl"))
    {
        bail!("{}: reading a baked scene is not there yet", path.display());
    }
    let (scene, notes) = fixel_scene::load_with_notes(path)?;
    for note in notes {
        eprintln!("note: {note}");
    }
    // Actors are numbered from 1 in 16 bits.
    if scene.actors.len() >= usize::from(u16::MAX) {
        bail!(
            "{}: {} actors; at most 65534",
            path.display(),
            scene.actors.len()
        );
    }
    Ok(scene)
}

/// The picture to render: the size asked for, or the display's.
pub fn options(scene: &Scene, frame: &Frame) -> fixel_reference::Options {
    let (width, height) = match frame.size {
        Some(size) => (size.width, size.height),
        None => (scene.display.width, scene.display.height),
    };
    fixel_reference::Options {
        width,
        height,
        frame: frame.number,
    }
}
