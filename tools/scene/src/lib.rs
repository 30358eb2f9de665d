//! A scene file, or a bare mesh, becomes a [`Scene`]: plain data with every
//! default filled in. In: TOML, OBJ, glTF, STL, PLY. Out: [`Scene`], read by
//! the baker, the f64 reference and the commands.

mod bare;
mod description;
mod error;
mod fence;
mod file;
mod files;
mod framing;
mod loader;
mod look;
mod mesh;
mod motion;
mod panel;
mod parts;
mod picture;
mod reach;
mod texture;

use std::path::Path;

pub use description::*;
pub use error::{Error, one_line};
pub use fence::Fenced;
pub use files::{Disk, Files, InMemory};
pub use loader::Loader;
pub use look::*;
pub use motion::Moment;
pub use panel::{DITHERINGS, Feed, PANELS, Panel, Screen};
pub use reach::Reach;
pub use texture::*;

/// Reads a scene file (`.toml`), or a bare mesh (`.obj`, `.glb`, `.gltf`,
/// `.stl`, `.ply`), which is framed automatically. Extensions may be in
/// upper case.
///
/// # Errors
/// The first mistake found: what, in which file, and in which line of it.
///
/// ```
/// use std::path::Path;
///
/// let scene = fixel_scene::load(Path::new("../../scenes/cube.toml"))?;
/// assert_eq!(scene.meshes[0].triangles.len(), 12);
///
/// let error = fixel_scene::load(Path::new("../../scenes/cub.toml")).unwrap_err();
/// assert_eq!(error.to_string(), "../../scenes/cub.toml: does not exist");
/// # Ok::<(), fixel_scene::Error>(())
/// ```
pub fn load(path: &Path) -> Result<Scene, Error> {
    load_with_notes(path).map(|(scene, _)| scene)
}

/// As [`load`], with notes for the user, one line each, on what the meshes
/// have that a scene does not, such as a glTF file's skins.
///
/// # Errors
/// As [`load`].
pub fn load_with_notes(path: &Path) -> Result<(Scene, Vec<String>), Error> {
    Loader::default().load(path)
}

/// Reads one mesh file, by its extension.
///
/// # Errors
/// As [`load`].
pub fn load_mesh(path: &Path) -> Result<Mesh, Error> {
    let origin = files::Origin { path, files: &Disk };
    mesh::load(origin).map(|loaded| loaded.mesh)
}
