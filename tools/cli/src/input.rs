//! The scene that a command works on.

use crate::args::{self, Frame};
use anyhow::{Result, anyhow};
use fixel_scene::{Fenced, Scene, Screen};

pub use fixel_bake::Input;

/// Loads a scene, a mesh or a baked scene; what the loader has to say goes to
/// standard error.
pub fn load(file: &args::Input) -> Result<Input> {
    load_on(file, None)
}

/// The same for a panel, if there is one.
pub fn load_on(file: &args::Input, screen: Option<Screen>) -> Result<Input> {
    let always = std::env::var_os("FIXEL_ALLOW").unwrap_or_default();
    let mut allowed: Vec<_> = std::env::split_paths(&always).collect();
    // What an empty variable splits into.
    allowed.retain(|folder| !folder.as_os_str().is_empty());
    allowed.extend_from_slice(&file.allow);
    let files = Fenced::around(&file.scene, &allowed).map_err(|error| anyhow!(error))?;
    let input = Input::load(&file.scene, &files, screen)?;
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
