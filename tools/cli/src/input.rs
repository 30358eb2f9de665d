//! The scene that a command works on.

use crate::args::{self, Frame};
use anyhow::{Result, anyhow};
use fixel_scene::{Fenced, Files, Scene, Screen};
use std::path::{Path, PathBuf};

pub use fixel_bake::Input;

/// The files that a command may read: none that it will write.
#[derive(Debug)]
struct Inputs {
    files: Fenced,
    /// Those outputs that are there already.
    outputs: Vec<PathBuf>,
}

impl Files for Inputs {
    fn read(&self, path: &Path) -> Result<Vec<u8>, String> {
        if let Ok(real) = path.canonicalize()
            && self.outputs.contains(&real)
        {
            return Err("is what the output would replace; expected another name for it".into());
        }
        self.files.read(path)
    }
}

/// Loads a scene, a mesh or a baked scene; what the loader has to say goes to
/// standard error. What is read is none of the outputs.
pub fn load(file: &args::Input, outputs: &[Option<&Path>]) -> Result<Input> {
    load_on(file, None, outputs)
}

/// The same for a panel, if there is one.
pub fn load_on(
    file: &args::Input,
    screen: Option<Screen>,
    outputs: &[Option<&Path>],
) -> Result<Input> {
    read(file, screen, outputs).map(tell)
}

/// The same, and says nothing.
pub fn read(
    file: &args::Input,
    screen: Option<Screen>,
    outputs: &[Option<&Path>],
) -> Result<Input> {
    let always = std::env::var_os("FIXEL_ALLOW").unwrap_or_default();
    let mut allowed: Vec<_> = std::env::split_paths(&always).collect();
    // What an empty variable splits into.
    allowed.retain(|folder| !folder.as_os_str().is_empty());
    allowed.extend_from_slice(&file.allow);
    let files = Fenced::around(&file.scene, &allowed).map_err(|error| anyhow!(error))?;
    let outputs = outputs.iter().flatten();
    let files = Inputs {
        files,
        outputs: outputs
            .filter_map(|path| path.canonicalize().ok())
            .collect(),
    };
    Ok(Input::load(&file.scene, &files, screen)?)
}

/// Tells what the loader has to say on standard error.
pub fn tell(input: Input) -> Input {
    for note in &input.notes {
        eprintln!("note: {}", fixel_scene::one_line(note));
    }
    input
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
