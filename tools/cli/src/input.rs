//! The scene that a command works on.

use crate::args::Frame;
use anyhow::Result;
use fixel_scene::{Disk, Scene, Screen};
use std::path::Path;

pub use fixel_bake::Input;

/// Loads a scene, a mesh or a baked scene; what the loader has to say goes to
/// standard error.
pub fn load(path: &Path) -> Result<Input> {
    load_on(path, None)
}

/// The same for a panel, if there is one.
pub fn load_on(path: &Path, screen: Option<Screen>) -> Result<Input> {
    let input = Input::load(path, &Disk, screen)?;
    for note in &input.notes {
        eprintln!("note: {note}");
    }
    Ok(input)
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
