//! A scene file, or a bare mesh, becomes a [`Scene`]: plain data with every
//! default filled in. In: TOML, OBJ, glTF, STL, PLY. Out: [`Scene`], read by
//! the baker, the f64 reference and the commands.

mod bare;
mod description;
mod error;
mod file;
mod framing;
mod look;
mod mesh;
mod motion;
mod parts;
mod picture;
mod texture;

use std::path::Path;

pub use description::*;
pub use error::Error;
pub use look::*;
pub use motion::{Moment, Reach};
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
    let mut notes = Vec::new();
    let scene = if mesh::extension(path) == "toml" {
        let bytes = mesh::read(path).map_err(|what| Error::new(path, what))?;
        let text = std::str::from_utf8(&bytes).map_err(|error| {
            let line = mesh::line_of(&bytes, error.valid_up_to());
            Error::at_line(path, line, "not UTF-8; expected a TOML file in UTF-8")
        })?;
        file::parse(path, text, &mut notes)?
    } else {
        mesh::check_name(path).map_err(|_| {
            let meshes = mesh::EXTENSIONS.join(", .");
            let what = "is not a kind of file that can be read; expected one of .toml";
            Error::new(path, format!("{what}, .{meshes}"))
        })?;
        bare::scene(path, &mut notes)?
    };
    Ok((scene, notes))
}

/// Reads one mesh file, by its extension.
///
/// # Errors
/// As [`load`].
pub fn load_mesh(path: &Path) -> Result<Mesh, Error> {
    mesh::load(path).map(|loaded| loaded.mesh)
}
