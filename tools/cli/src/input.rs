//! The scene that a command works on.

use crate::args::Frame;
use crate::baked;
use anyhow::{Context, Result, bail};
use fixel_bake::{BakeError, Baked};
use fixel_scene::{Loader, Scene, Screen};
use std::path::Path;

/// A scene, and its blob if it came baked.
#[derive(Debug)]
pub struct Input {
    /// The description; of a baked scene, what it still says of it.
    pub scene: Scene,
    /// The blob as it was in the file.
    pub baked: Option<Baked>,
}

impl Input {
    /// What is wrong with the scene as a whole, with its file.
    pub fn refused(&self, what: &str) -> anyhow::Error {
        self.scene.error(None, what).into()
    }

    /// Why the scene cannot be baked, with file and line.
    fn placed(&self, error: &BakeError) -> anyhow::Error {
        self.scene.error(error.element, &error.to_string()).into()
    }

    /// Simplifies the meshes to `most` triangles in total; says on standard error what
    /// became of them.
    pub fn reduce(&mut self, most: u32) -> Result<()> {
        if self.baked.is_some() {
            return Err(self.refused("--max-triangles needs a scene, this is baked already"));
        }
        let reduced = fixel_bake::reduce(&mut self.scene, most as usize)
            .map_err(|error| self.placed(&error))?;
        for mesh in reduced {
            eprintln!(
                "{}: {} of {} triangles, off by at most {:.3} % of its size ({:.4} of {:.4})",
                mesh.mesh,
                mesh.after,
                mesh.before,
                mesh.error / mesh.size * 100.0,
                mesh.error,
                mesh.size
            );
        }
        Ok(())
    }

    /// The blob: the file's own, or made now.
    pub fn bake(mut self) -> Result<Baked> {
        match self.baked.take() {
            Some(baked) => Ok(baked),
            None => fixel_bake::bake(&self.scene).map_err(|error| self.placed(&error)),
        }
    }

    /// The same, with what the ray caster needs.
    pub fn bake_for_rays(mut self) -> Result<Baked> {
        match self.baked.take() {
            Some(baked) if baked.scene()?.has_rays() => Ok(baked),
            Some(_) => {
                Err(self.refused("is not baked for rays; expected one made by fixel bake --ray"))
            }
            None => fixel_bake::bake_for_rays(&self.scene).map_err(|error| self.placed(&error)),
        }
    }
}

/// Loads a scene, a mesh or a baked scene; what the loader has to say goes to
/// standard error.
pub fn load(path: &Path) -> Result<Input> {
    load_on(path, None)
}

/// The same for a panel, if there is one.
pub fn load_on(path: &Path, screen: Option<Screen>) -> Result<Input> {
    if path
        .extension()
        .is_some_and(|extension| extension.eq_ignore_ascii_case("fxl"))
    {
        let mut baked = baked::read(path)?;
        if let Some(screen) = screen {
            let on = baked.on(&screen);
            baked = on.with_context(|| path.display().to_string())?;
        }
        let mut scene = fixel_bake::unbake(&baked.scene()?);
        scene.source.file = path.to_owned();
        return Ok(Input {
            scene,
            baked: Some(baked),
        });
    }
    let loader = Loader::default();
    let loader = screen.map_or(loader, |screen| loader.on(screen));
    let (scene, notes) = loader.load(path)?;
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
    Ok(Input { scene, baked: None })
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
