//! For build scripts: a scene file becomes a blob in the build folder.

use std::cell::RefCell;
use std::collections::BTreeSet;
use std::env;
use std::path::{Path, PathBuf};

use fixel_scene::{Disk, Files};

use crate::input::{Input, Options};

/// Bakes a scene for the firmware whose build script this is: `path`, a scene file
/// (`.toml`), a mesh (`.obj`, `.glb`, `.gltf`, `.stl`, `.ply`) or a baked scene (`.fxl`),
/// relative to the folder of its `Cargo.toml`, becomes a file of the same name with the
/// extension `.fxl` in `OUT_DIR`, which `fixel::include_scene!(OUT_DIR, "NAME.fxl")` puts
/// into flash.
///
/// Cargo runs the script again when the scene or any file that it names has changed. A
/// mistake in one of them is cargo's error, with file and line:
///
/// ```text
/// error: firmware@0.1.0: scene.toml:7: material `red`: no such colour ...
/// ```
///
/// Cargo does not optimise what build scripts need unless it is told to; the baker takes many
/// times longer then. In the firmware's `Cargo.toml`, and the same for `release`:
///
/// ```toml
/// [profile.dev.build-override]
/// opt-level = 2
/// ```
///
/// [`SceneFile`] has options.
pub fn scene(path: impl AsRef<Path>) {
    SceneFile::new(path).build();
}

/// A scene file, and what its blob is to hold; see [`scene`].
///
/// ```no_run
/// fixel_bake::SceneFile::new("scene.toml").rays(true).colours(64).build();
/// ```
#[derive(Clone, Debug)]
pub struct SceneFile {
    path: PathBuf,
    options: Options,
}

impl SceneFile {
    /// As the scene file says, for triangles.
    pub fn new(path: impl AsRef<Path>) -> Self {
        Self {
            path: path.as_ref().to_owned(),
            options: Options::default(),
        }
    }

    /// With what the ray caster needs, or without although the scene asks for it.
    #[must_use]
    pub fn rays(mut self, rays: bool) -> Self {
        self.options.rays = Some(rays);
        self
    }

    /// Meshes simplified to at most so many triangles in total.
    #[must_use]
    pub fn max_triangles(mut self, most: u32) -> Self {
        self.options.max_triangles = Some(most);
        self
    }

    /// So many entries of the palette, 2..=256.
    #[must_use]
    pub fn colours(mut self, colours: u32) -> Self {
        self.options.colours = Some(colours);
        self
    }

    /// Bakes it, in a build script. What is wrong is told to cargo, which fails after the
    /// script.
    pub fn build(&self) {
        let out = PathBuf::from(env::var_os("OUT_DIR").unwrap_or_default());
        let files = Watched::default();
        let result = self.bake(&files, &out);
        for file in files.read.into_inner() {
            println!("cargo::rerun-if-changed={}", file.display());
        }
        match result {
            Ok(notes) => notes
                .iter()
                .for_each(|note| println!("cargo::warning={note}")),
            Err(error) => println!("cargo::error={}", error.replace('\n', " ")),
        }
    }

    fn bake(&self, files: &Watched, out: &Path) -> Result<Vec<String>, String> {
        // Cargo runs build scripts in their package's folder.
        let mut input = Input::load(&self.path, files, None).map_err(|error| error.to_string())?;
        let mut notes = std::mem::take(&mut input.notes);
        let baked = input.bake_with(&self.options);
        let (baked, reduced) = baked.map_err(|error| error.to_string())?;
        notes.extend(reduced);
        let name = self.path.file_name().unwrap_or_default();
        let blob = out.join(name).with_extension("fxl");
        fixel_output::write(&blob, baked.bytes())?;
        Ok(notes)
    }
}

/// The files of this machine, and which of them were asked for.
#[derive(Debug, Default)]
struct Watched {
    read: RefCell<BTreeSet<PathBuf>>,
}

impl Files for Watched {
    fn read(&self, path: &Path) -> Result<Vec<u8>, String> {
        self.read.borrow_mut().insert(path.to_owned());
        Disk.read(path)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Baked;

    fn baked(scene: &SceneFile, out: &Path) -> (Result<Vec<String>, String>, Vec<PathBuf>) {
        let files = Watched::default();
        let result = scene.bake(&files, out);
        (result, files.read.into_inner().into_iter().collect())
    }

    #[test]
    fn a_blob_is_written_and_every_file_is_watched() {
        let out = tempfile::tempdir().unwrap();
        let scene = SceneFile::new("../../scenes/textured_floor.toml");
        let (result, watched) = baked(&scene, out.path());
        assert_eq!(result, Ok(Vec::new()));
        let blob = std::fs::read(out.path().join("textured_floor.fxl")).unwrap();
        assert!(
            !Baked::from_bytes(&blob)
                .unwrap()
                .scene()
                .unwrap()
                .has_rays()
        );
        let names = watched.iter().map(|path| path.file_name().unwrap());
        let names: Vec<_> = names.map(|name| name.to_string_lossy()).collect();
        for name in ["textured_floor.toml", "floor_textured.obj", "tiles.png"] {
            assert!(names.iter().any(|other| other == name), "{name}: {names:?}");
        }
        let (result, _) = baked(&scene.rays(true), out.path());
        assert_eq!(result, Ok(Vec::new()));
        let blob = std::fs::read(out.path().join("textured_floor.fxl")).unwrap();
        assert!(
            Baked::from_bytes(&blob)
                .unwrap()
                .scene()
                .unwrap()
                .has_rays()
        );
    }

    #[test]
    fn a_mistake_has_file_and_line_and_what_is_missing_is_watched() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("scene.toml");
        std::fs::write(
            &path,
            "[display]\nwidth = 8\n\n[[actor]]\nmesh = \"no.obj\"\n",
        )
        .unwrap();
        let (result, watched) = baked(&SceneFile::new(&path), folder.path());
        let error = result.unwrap_err();
        let place = format!("{}:5: ", path.display());
        assert!(
            error.starts_with(&place) && error.contains("no.obj"),
            "{error}"
        );
        assert_eq!(watched, [folder.path().join("no.obj"), path]);
        assert!(!folder.path().join("scene.fxl").exists());
    }
}
