//! Where a scene's files are: on disk, or in memory, as in a browser.

use std::collections::BTreeMap;
use std::fmt::Debug;
use std::path::{Component, Path, PathBuf};

/// A text file of as many triangles as there may be stays below this.
const MAX_BYTES: u64 = 1 << 30;

/// Files by their paths. A scene's own path is one of them; those that it names are
/// looked up relative to its folder.
pub trait Files: Debug {
    /// A whole file.
    ///
    /// # Errors
    /// Why it cannot be had, as what follows its name in a message, such as `does not
    /// exist`.
    fn read(&self, path: &Path) -> Result<Vec<u8>, String>;
}

/// The files of this machine.
#[derive(Clone, Copy, Debug, Default)]
pub struct Disk;

impl Files for Disk {
    fn read(&self, path: &Path) -> Result<Vec<u8>, String> {
        let cannot = |error: std::io::Error| match error.kind() {
            std::io::ErrorKind::NotFound => "does not exist".to_owned(),
            _ => format!("cannot be read: {error}"),
        };
        let about = std::fs::metadata(path).map_err(cannot)?;
        if !about.is_file() {
            return Err("is no file".to_owned());
        }
        let bytes = about.len();
        if bytes > MAX_BYTES {
            return Err(format!("has {bytes} bytes; expected at most {MAX_BYTES}"));
        }
        std::fs::read(path).map_err(cannot)
    }
}

/// Files in memory. Who hands over single files has not always their folders: one that
/// is not at its place is taken from anywhere, if one file alone has its name (letters'
/// case does not count then).
///
/// ```
/// use std::path::Path;
/// use fixel_scene::{Files, InMemory};
///
/// let mut files = InMemory::default();
/// files.insert(Path::new("Wood.PNG"), vec![1, 2, 3]);
/// assert_eq!(files.read(Path::new("scene/../textures/wood.png")), Ok(vec![1, 2, 3]));
/// assert!(files.read(Path::new("stone.png")).is_err());
/// ```
#[derive(Clone, Debug, Default)]
pub struct InMemory {
    files: BTreeMap<PathBuf, Vec<u8>>,
}

impl InMemory {
    /// Puts a file in its place.
    pub fn insert(&mut self, path: &Path, bytes: Vec<u8>) {
        self.files.insert(plain(path), bytes);
    }

    /// The paths of all files.
    pub fn paths(&self) -> impl Iterator<Item = &Path> {
        self.files.keys().map(PathBuf::as_path)
    }
}

impl Files for InMemory {
    fn read(&self, path: &Path) -> Result<Vec<u8>, String> {
        let path = plain(path);
        if let Some(bytes) = self.files.get(&path) {
            return Ok(bytes.clone());
        }
        let name = |path: &Path| path.file_name().map(|name| name.to_ascii_lowercase());
        let mut same = self.files.iter().filter(|(p, _)| name(p) == name(&path));
        match (same.next(), same.next()) {
            (Some((_, bytes)), None) => Ok(bytes.clone()),
            (Some(_), Some(_)) => {
                Err("is there several times; expected it where the scene names it".to_owned())
            }
            _ => Err("is not among the files; expected it together with them".to_owned()),
        }
    }
}

/// Without `.` and `..`, which stay within the outermost folder.
fn plain(path: &Path) -> PathBuf {
    let mut plain = PathBuf::new();
    for part in path.components() {
        match part {
            Component::Normal(name) => plain.push(name),
            Component::ParentDir => {
                plain.pop();
            }
            _ => {}
        }
    }
    plain
}

/// A file that names others, and where they are.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Origin<'a> {
    /// Its path.
    pub path: &'a Path,
    pub files: &'a dyn Files,
}

impl Origin<'_> {
    /// The path of a file that this one names, beside which it is.
    pub fn beside(&self, name: &str) -> PathBuf {
        self.path.parent().unwrap_or(Path::new("")).join(name)
    }

    /// A file that this one names.
    pub fn read(&self, name: &str) -> Result<Vec<u8>, String> {
        self.files.read(&self.beside(name))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_at_its_place_comes_first() {
        let mut files = InMemory::default();
        for (path, byte) in [("a/x.obj", 1), ("b/x.obj", 2), ("c/Y.obj", 3)] {
            files.insert(Path::new(path), vec![byte]);
        }
        let read = |path: &str| files.read(Path::new(path));
        assert_eq!(read("b/x.obj"), Ok(vec![2]));
        assert_eq!(read("./a/../b/./x.obj"), Ok(vec![2]));
        assert_eq!(read("meshes/y.obj"), Ok(vec![3]));
        assert_eq!(read("../../../c/Y.obj"), Ok(vec![3]));
        let several = read("x.obj").unwrap_err();
        assert!(several.starts_with("is there several times"), "{several}");
        let none = read("z.obj").unwrap_err();
        assert!(none.starts_with("is not among the files"), "{none}");
    }
}
