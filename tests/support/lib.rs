//! What the tests share: scenes of the repository, and small ones made in code.

pub mod fuzz;
pub mod made;

use std::path::{Path, PathBuf};

use fixel_bake::{BakeError, Baked};
use fixel_scene::Scene;

/// The repository's root.
///
/// # Panics
/// If it is gone.
pub fn root() -> PathBuf {
    let tests = Path::new(env!("CARGO_MANIFEST_DIR"));
    tests
        .parent()
        .expect("tests/ is in the repository")
        .to_owned()
}

/// The scene files of a folder, sorted.
///
/// # Panics
/// If the folder cannot be read.
pub fn scenes(folder: &str) -> Vec<PathBuf> {
    let entries = std::fs::read_dir(root().join(folder)).expect("the folder is there");
    let mut files: Vec<PathBuf> = entries
        .map(|entry| entry.expect("an entry").path())
        .filter(|path| path.extension().is_some_and(|e| e == "toml"))
        .collect();
    files.sort();
    files
}

/// A scene of the repository, as described and baked.
///
/// # Panics
/// If it does not load or bake.
pub fn load(path: &Path) -> (Scene, Baked) {
    load_by(path, fixel_bake::bake)
}

/// The same, baked for rays.
///
/// # Panics
/// If it does not load or bake.
pub fn load_for_rays(path: &Path) -> (Scene, Baked) {
    load_by(path, fixel_bake::bake_for_rays)
}

fn load_by(path: &Path, bake: impl Fn(&Scene) -> Result<Baked, BakeError>) -> (Scene, Baked) {
    let scene = fixel_scene::load(path).unwrap_or_else(|e| panic!("{e}"));
    let baked = bake(&scene).unwrap_or_else(|e| panic!("{}: {e}", path.display()));
    (scene, baked)
}
