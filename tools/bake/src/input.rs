//! A scene file on its way to a blob: what commands and build scripts share.

use std::path::Path;

use fixel::SceneError;
use fixel_scene::{Error, Files, Loader, Scene, Screen};

use crate::blob::{Baked, bake, bake_for_rays};
use crate::error::BakeError;
use crate::simplify::{Reduced, reduce};
use crate::unbake::unbake;

/// A scene, and its blob if it came baked.
#[derive(Debug)]
pub struct Input {
    /// The description; of a baked scene, what it still says of it.
    pub scene: Scene,
    /// The blob as it was in the file.
    pub baked: Option<Baked>,
    /// What the loader left out, a line each.
    pub notes: Vec<String>,
}

/// What a blob is to hold, beyond what the scene file says.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Options {
    /// With what the ray caster needs. `None`: without, and a scene that asks for rays is
    /// an error.
    pub rays: Option<bool>,
    /// At most so many triangles in all meshes together.
    pub max_triangles: Option<u32>,
    /// Entries of the palette, 2..=256.
    pub colours: Option<u32>,
}

impl Input {
    /// Reads a scene file, a mesh, or a baked scene (`.fxl`), for its own display or for
    /// another panel.
    ///
    /// # Errors
    /// The first mistake found: what, in which file, and in which line of it.
    pub fn load(path: &Path, files: &dyn Files, screen: Option<Screen>) -> Result<Self, Error> {
        let extension = path.extension().unwrap_or_default();
        if extension.eq_ignore_ascii_case("fxl") {
            return Self::load_baked(path, files, screen);
        }
        let loader = Loader::new(files);
        let loader = screen.map_or(loader, |screen| loader.on(screen));
        let (scene, notes) = loader.load(path)?;
        let input = Self {
            scene,
            baked: None,
            notes,
        };
        // Actors are numbered from 1 in 16 bits.
        let actors = input.scene.actors.len();
        if actors >= usize::from(u16::MAX) {
            return Err(input.refused(&format!("{actors} actors; expected at most 65534")));
        }
        Ok(input)
    }

    fn load_baked(path: &Path, files: &dyn Files, screen: Option<Screen>) -> Result<Self, Error> {
        let mut baked = Baked::read(path, files)?;
        if let Some(screen) = screen {
            let on = baked.on(&screen);
            baked = on.map_err(|error| refused(path, error.to_string()))?;
        }
        let mut scene = unbake(&baked.scene().map_err(|error| damaged(path, error))?);
        scene.source.file = path.to_owned();
        Ok(Self {
            scene,
            baked: Some(baked),
            notes: Vec::new(),
        })
    }

    /// What is wrong with the scene as a whole, with its file.
    pub fn refused(&self, what: &str) -> Error {
        self.scene.error(None, what)
    }

    fn placed(&self, error: &BakeError) -> Error {
        self.scene.error(error.element, &error.to_string())
    }

    /// The blob: the file's own, or made now.
    ///
    /// # Errors
    /// As [`bake`](crate::bake), with file and line.
    pub fn bake(mut self) -> Result<Baked, Error> {
        match self.baked.take() {
            Some(baked) => Ok(baked),
            None => bake(&self.scene).map_err(|error| self.placed(&error)),
        }
    }

    /// The same, with what the ray caster needs.
    ///
    /// # Errors
    /// As [`bake`](crate::bake), and if the file is baked without.
    pub fn bake_for_rays(mut self) -> Result<Baked, Error> {
        match self.baked.take() {
            Some(baked) if baked.scene().is_ok_and(|scene| scene.has_rays()) => Ok(baked),
            Some(_) => {
                Err(self.refused("is not baked for rays; expected one made by fixel bake --ray"))
            }
            None => bake_for_rays(&self.scene).map_err(|error| self.placed(&error)),
        }
    }

    /// Simplifies the meshes to `most` triangles in total; gives a line on each, for the
    /// user.
    fn reduce(&mut self, most: u32) -> Result<Vec<String>, Error> {
        if self.baked.is_some() {
            return Err(self.refused("--max-triangles needs a scene, this is baked already"));
        }
        let reduced = reduce(&mut self.scene, most as usize);
        let reduced = reduced.map_err(|error| self.placed(&error))?;
        let line = |mesh: Reduced| {
            format!(
                "{}: {} of {} triangles, off by at most {:.3} % of its size ({:.4} of {:.4})",
                mesh.mesh,
                mesh.after,
                mesh.before,
                mesh.error / mesh.size * 100.0,
                mesh.error,
                mesh.size
            )
        };
        Ok(reduced.into_iter().map(line).collect())
    }

    /// The blob that the options ask for, and a line on each mesh that was simplified.
    ///
    /// # Errors
    /// As [`Input::bake`] and [`Input::bake_for_rays`], and if an option does not go with
    /// the scene.
    pub fn bake_with(mut self, options: &Options) -> Result<(Baked, Vec<String>), Error> {
        if let Some(colours) = options.colours {
            if self.baked.is_some() {
                return Err(self.refused("--colours needs a scene, this is baked already"));
            }
            if !self.scene.palette.fixed.is_empty() {
                return Err(
                    self.refused("--colours does not go with palette.file, which has all entries")
                );
            }
            self.scene.palette.colours = colours;
        }
        if options.rays.is_none()
            && self.baked.is_none()
            && let Some(why) = self.scene.asks_for_rays()
        {
            return Err(self.refused(&format!(
                "{why} asks for rays, which firmware casts only if --ray bakes what they need; \
                 expected --ray, or --raster for triangles alone \
                 (in a build script .rays(true) or .rays(false))"
            )));
        }
        let reduced = match options.max_triangles {
            Some(most) => self.reduce(most)?,
            None => Vec::new(),
        };
        let mistake = self.refused("became a blob that is refused, a mistake of the baker");
        let baked = if options.rays == Some(true) {
            self.bake_for_rays()?
        } else {
            self.bake()?
        };
        // What firmware takes from `Scene::embedded` without looking at it again.
        match baked.scene() {
            Ok(_) => Ok((baked, reduced)),
            Err(error) => Err(Error {
                message: format!("{}: {error}", mistake.message),
                ..mistake
            }),
        }
    }
}

impl Baked {
    /// Reads a baked scene (`.fxl`) and checks it.
    ///
    /// # Errors
    /// If there is no such file, or it is not whole.
    pub fn read(path: &Path, files: &dyn Files) -> Result<Self, Error> {
        let bytes = files.read(path).map_err(|what| refused(path, what))?;
        Self::from_bytes(&bytes).map_err(|error| damaged(path, error))
    }
}

fn damaged(path: &Path, error: SceneError) -> Error {
    refused(path, format!("{error}; expected a file made by fixel bake"))
}

fn refused(path: &Path, message: String) -> Error {
    Error {
        file: path.to_owned(),
        line: None,
        column: None,
        message,
    }
}
