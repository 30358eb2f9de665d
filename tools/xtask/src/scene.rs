//! The scenes that the commands render, baked.

use std::fs;
use std::path::{Path, PathBuf};
use std::sync::Mutex;

use crate::paths;
use crate::problem::{Problem, Result};

/// The bench scenes, in the order of the README's table. They are in
/// `scenes/bench/`.
pub const BENCH: [&str; 6] = [
    "w1_teapot_flat",
    "w2_teapot_gouraud",
    "w3_bunny_gouraud",
    "w4_cube_textured",
    "w5_fill",
    "w6_bunny_64x64",
];

/// The bench scenes of the ray caster; in `scenes/bench/` too.
pub const RAY_BENCH: [&str; 3] = ["r1_bunny_rays", "r2_bunny_shadow", "r3_spheres_whitted"];

/// A small scene, for checks that need any.
pub const SMALL: &str = "w2_teapot_gouraud";

/// Folders of scenes.
const FOLDERS: [&str; 4] = ["scenes", "scenes/bench", "scenes/ray", "scenes/small"];

/// Every scene that is measured.
pub fn bench() -> impl Iterator<Item = &'static str> {
    BENCH.into_iter().chain(RAY_BENCH)
}

/// Whether a scene is drawn by rays: it is one of [`RAY_BENCH`], or its folder is
/// called so.
pub fn by_rays(name: &str) -> bool {
    let file = file(name);
    let is = |name: &&str| file.file_stem().is_some_and(|stem| stem == *name);
    RAY_BENCH.iter().any(is) || file.parent().is_some_and(|folder| folder.ends_with("ray"))
}

/// Every scene file, by name.
pub fn all() -> Result<Vec<PathBuf>> {
    let mut files = Vec::new();
    for folder in FOLDERS {
        let folder = paths::root().join(folder);
        let fail = |error| format!("{}: {error}", folder.display());
        for entry in fs::read_dir(&folder).map_err(fail)? {
            let path = entry.map_err(fail)?.path();
            if path.extension().is_some_and(|kind| kind == "toml") {
                files.push(path);
            }
        }
    }
    files.sort_by_key(|file| file.file_stem().map(ToOwned::to_owned));
    Ok(files)
}

/// A scene file's name.
pub fn name(file: &Path) -> String {
    let stem = file.file_stem().unwrap_or_default();
    stem.to_string_lossy().into_owned()
}

/// The names asked for, or else those of all scenes.
pub fn named_or_all(names: &[String]) -> Result<Vec<String>> {
    if names.is_empty() {
        return Ok(all()?.iter().map(|file| name(file)).collect());
    }
    Ok(names.to_vec())
}

/// The scene's file: a name from the lists above, or a path.
pub fn file(name: &str) -> PathBuf {
    if Path::new(name).extension().is_some() {
        return name.into();
    }
    let place = |folder| paths::root().join(folder).join(format!("{name}.toml"));
    let mut places = FOLDERS.map(place).into_iter();
    let first = places.next().unwrap_or_default();
    if first.exists() {
        return first;
    }
    places.find(|file| file.exists()).unwrap_or(first)
}

/// A baked scene.
#[derive(Clone, Debug)]
pub struct Baked {
    /// The `.fxl` file.
    pub path: PathBuf,
    /// Its size.
    pub bytes: u64,
}

impl Baked {
    /// Writes a blob into a folder of the work folder.
    pub fn keep(folder: &str, name: &str, blob: &fixel_bake::Baked) -> Result<Self> {
        let path = paths::work(folder)?.join(format!("{name}.fxl"));
        fixel_output::write(&path, blob.bytes())?;
        let bytes = blob.bytes().len() as u64;
        Ok(Self { path, bytes })
    }
}

/// Bakes a scene into the work folder.
pub fn bake(name: &str) -> Result<Baked> {
    let source = file(name);
    let path = paths::work("scenes")?.join(format!("{}.fxl", self::name(&source)));
    let blob = blob(&source, by_rays(name))?;
    /// Firmware with the same scene is built side by side.
    static ALONE: Mutex<()> = Mutex::new(());
    let _alone = ALONE.lock().map_err(|error| error.to_string())?;
    let same = fs::read(&path).is_ok_and(|old| old == blob);
    if !same {
        fixel_output::write(&path, &blob)?;
    }
    Ok(Baked {
        path,
        bytes: blob.len() as u64,
    })
}

/// The scene as bytes for flash.
pub fn blob(source: &Path, for_rays: bool) -> Result<Vec<u8>> {
    let scene = fixel_scene::load(source).map_err(|error| error.to_string())?;
    let placed =
        |error: &fixel_bake::BakeError| scene.error(error.element, &error.to_string()).to_string();
    let baked = if for_rays {
        fixel_bake::bake_for_rays(&scene)
    } else {
        fixel_bake::bake(&scene)
    };
    let baked = baked.map_err(|error| match error.problem {
        fixel_bake::Problem::NotYet { .. } => Problem::Missing(placed(&error)),
        _ => Problem::Failed(placed(&error)),
    })?;
    Ok(baked.bytes().to_vec())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn where_scenes_are() {
        assert!(file("teapot").ends_with("scenes/teapot.toml"));
        assert!(file("w5_fill").ends_with("scenes/bench/w5_fill.toml"));
        assert_eq!(file("other/x.obj"), Path::new("other/x.obj"));
    }
}
