//! Where things are in the repository.

use std::fs;
use std::path::{Path, PathBuf};

use crate::problem::Result;

/// The repository's root.
pub fn root() -> PathBuf {
    let tools = Path::new(env!("CARGO_MANIFEST_DIR")).parent();
    tools
        .and_then(Path::parent)
        .unwrap_or(Path::new("."))
        .into()
}

/// A folder of `targets/`.
pub fn target_crate(folder: &str) -> PathBuf {
    root().join("targets").join(folder)
}

/// A folder for what the commands make (baked scenes, firmware with a scene
/// linked in), created if need be.
pub fn work(folder: &str) -> Result<PathBuf> {
    let path = root().join("target/xtask").join(folder);
    fs::create_dir_all(&path).map_err(|error| format!("{}: {error}", path.display()))?;
    Ok(path)
}
