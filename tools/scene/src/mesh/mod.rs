//! In: the bytes of a mesh file. Out: a [`Mesh`] that keeps all of
//! [`Mesh`]'s promises, or the first mistake. Used by the scene file's
//! actors and by bare meshes.

mod accessor;
mod crease;
mod finish;
mod gltf;
mod gltf_surface;
mod gltf_texture;
mod mtl;
mod obj;
mod obj_surface;
mod part;
mod ply;
mod polygon;
mod primitive;
mod stl;
mod surface;
#[cfg(test)]
pub(crate) mod tests;

use std::collections::HashSet;
use std::ops::Range;
use std::path::{Path, PathBuf};

use crate::description::{Mesh, Rgb};
use crate::error::Error;
use crate::files::Origin;
pub(crate) use finish::forget_texture_coordinates;
pub(crate) use surface::Surface;

pub(crate) use primitive::{polygon, rectangle, sphere};

/// More than this is a mistake, not a scene for a microcontroller.
const MAX_TRIANGLES: usize = 1_000_000;
/// The same of vertices, before those alike become one.
const MAX_VERTICES: usize = 3 * MAX_TRIANGLES;
/// Texture coordinates stay within this, either side of 0.
const MAX_TEXTURE_COORDINATE: f64 = 1e4;
/// Coordinates stay within this, either side of 0.
const MAX_COORDINATE: f64 = 1e9;

/// Extensions that [`parse`] reads.
pub(crate) const EXTENSIONS: &[&str] = &["obj", "glb", "gltf", "stl", "ply"];

/// A mesh and what else its file says.
#[derive(Debug)]
pub(crate) struct Loaded {
    pub mesh: Mesh,
    /// What the file says of its surfaces, if anything.
    pub surfaces: Vec<Surface>,
    /// The surface that each triangle belongs to.
    pub surface_of: Vec<u32>,
    /// What was left out, one line each.
    pub notes: Vec<String>,
}

/// What a loader finds in its file. Indices are within `positions`; all else
/// is checked by [`finish::finish`].
#[derive(Debug, Default)]
struct Soup {
    positions: Vec<[f64; 3]>,
    /// As many as positions.
    normals: Vec<Option<[f64; 3]>>,
    /// As many as positions, or none; display-encoded.
    colours: Vec<Rgb>,
    /// As many as positions, or none.
    texture_coordinates: Vec<[f64; 2]>,
    triangles: Vec<[u32; 3]>,
    /// Sides of triangles that are inside a polygon, the lower index first.
    diagonals: HashSet<[u32; 2]>,
    /// What the file says of its surfaces, if anything.
    surfaces: Vec<Surface>,
    /// The surface of each triangle, where there are any.
    surface_of: Vec<u32>,
    notes: Vec<String>,
}

impl Soup {
    /// Notes what was left out, once.
    fn note(&mut self, note: &str) {
        if !self.notes.iter().any(|other| other == note) {
            self.notes.push(note.to_owned());
        }
    }

    /// Multiplies the colours of some vertices, white ones if there are none yet.
    fn paint(&mut self, vertices: Range<usize>, colour: Rgb) {
        self.colours.resize(self.positions.len(), [1.0; 3]);
        for own in &mut self.colours[vertices] {
            *own = [0, 1, 2].map(|c| own[c] * colour[c]);
        }
    }
}

/// Why a file was refused: the line if it has one, and what is wrong.
#[derive(Debug)]
struct Refusal {
    /// The file that it is in, if it is not the mesh's own.
    file: Option<PathBuf>,
    line: Option<usize>,
    message: String,
}

impl Refusal {
    fn new(message: impl Into<String>) -> Self {
        Self {
            file: None,
            line: None,
            message: message.into(),
        }
    }

    fn at(line: usize, message: impl Into<String>) -> Self {
        Self {
            line: Some(line),
            ..Self::new(message)
        }
    }

    /// In another file than the mesh's.
    fn of(self, file: &Path) -> Self {
        Self {
            file: Some(file.to_owned()),
            ..self
        }
    }

    /// Too many vertices, normals or the like.
    fn too_many_of(what: &str) -> Self {
        Self::new(format!(
            "has too many of \"{what}\"; expected at most {MAX_VERTICES}"
        ))
    }

    /// Too many triangles.
    fn too_many() -> Self {
        Self::new(format!(
            "has too many triangles; expected at most {MAX_TRIANGLES}"
        ))
    }
}

/// A file's extension in lower case.
pub(crate) fn extension(path: &Path) -> String {
    let extension = path.extension().unwrap_or_default();
    extension.to_string_lossy().to_lowercase()
}

/// Whether the extension is one of a mesh.
pub(crate) fn check_name(path: &Path) -> Result<(), String> {
    if EXTENSIONS.contains(&extension(path).as_str()) {
        return Ok(());
    }
    Err(format!(
        "is not a kind of mesh file; expected one of .{}",
        EXTENSIONS.join(", .")
    ))
}

/// The line, from 1, of a byte offset.
pub(crate) fn line_of(bytes: &[u8], offset: usize) -> usize {
    let before = bytes.iter().take(offset);
    before.filter(|byte| **byte == b'\n').count() + 1
}

/// Reads one mesh file.
pub(crate) fn load(origin: Origin<'_>) -> Result<Loaded, Error> {
    let bytes = check_name(origin.path)
        .and_then(|()| origin.files.read(origin.path))
        .map_err(|what| Error::new(origin.path, what))?;
    parse(origin, &bytes)
}

/// Reads a mesh file's bytes; the path says which format, and is named in
/// errors.
pub(crate) fn parse(origin: Origin<'_>, bytes: &[u8]) -> Result<Loaded, Error> {
    let path = origin.path;
    let soup = match extension(path).as_str() {
        "obj" => obj::read(origin, bytes),
        "glb" | "gltf" => gltf::read(origin, bytes),
        "stl" => stl::read(bytes),
        "ply" => ply::read(bytes),
        _ => Err(Refusal::new("is not a kind of mesh file")),
    };
    let name = path.file_name().unwrap_or_default();
    soup.and_then(|soup| finish::finish(&name.to_string_lossy(), soup))
        .map_err(|refusal| {
            let path = refusal.file.as_deref().unwrap_or(path);
            match refusal.line {
                Some(line) => Error::at_line(path, line, refusal.message),
                None => Error::new(path, refusal.message),
            }
        })
}
