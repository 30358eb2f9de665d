//! How the host programs write files: whole or not at all. In: a path and bytes, or
//! pixels. Out: a file under that name, or one line that says why not. Used by the
//! `fixel` command, its window and `cargo xtask`.

mod picture;
mod stop;

use std::ffi::OsString;
use std::fmt;
use std::fs::{self, File};
use std::io::{self, Write};
use std::path::{Path, PathBuf};

pub use picture::{png_grey16, png_rgb};
pub use stop::stop;

/// Why a file could not be written.
#[derive(Debug)]
pub struct Error {
    /// The file.
    pub path: PathBuf,
    /// What the system says.
    pub cause: io::Error,
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "cannot write {}: {}", self.path.display(), self.cause)
    }
}

impl std::error::Error for Error {}

impl From<Error> for String {
    fn from(error: Error) -> Self {
        error.to_string()
    }
}

/// Writes a file by way of a temporary one in the same folder, so that no one ever sees
/// a part of it, whatever ends the program ([`stop()`] takes the temporary one away). What is there and no plain file (such as
/// `/dev/null`) is written to as it is; a link keeps pointing at its target, and a file
/// that is replaced keeps its permissions.
///
/// # Errors
/// As the system has them: no such folder, no room, no permission. What was there before
/// is then there still.
pub fn write(path: &Path, bytes: &[u8]) -> Result<(), Error> {
    write_whole(path, bytes).map_err(|cause| Error {
        path: path.to_owned(),
        cause,
    })
}

fn write_whole(path: &Path, bytes: &[u8]) -> io::Result<()> {
    let there = fs::metadata(path).ok();
    let target = match &there {
        // A folder refuses.
        Some(there) if !there.is_file() => return fs::write(path, bytes),
        Some(_) => fs::canonicalize(path)?,
        None => path.to_owned(),
    };
    let temporary = temporary(&target).ok_or(io::ErrorKind::InvalidInput)?;
    stop::begin(&temporary)?;
    let written = File::create(&temporary)
        .and_then(|mut file| file.write_all(bytes).and_then(|()| file.sync_all()))
        .and_then(|()| match there {
            Some(there) => fs::set_permissions(&temporary, there.permissions()),
            None => Ok(()),
        })
        .and_then(|()| fs::rename(&temporary, &target));
    if written.is_err() {
        // The first error is the one to tell.
        let _ = fs::remove_file(&temporary);
    }
    stop::end(&temporary);
    written
}

/// A hidden name beside the file's own that no other process takes.
fn temporary(target: &Path) -> Option<PathBuf> {
    let mut name = OsString::from(".");
    name.push(target.file_name()?);
    name.push(format!(".{}.tmp", std::process::id()));
    Some(target.with_file_name(name))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn names(folder: &Path) -> Vec<OsString> {
        let entries = fs::read_dir(folder).expect("a folder");
        entries.map(|e| e.expect("an entry").file_name()).collect()
    }

    #[test]
    fn a_file_is_written_and_replaced() {
        let folder = tempfile::tempdir().expect("a folder");
        let path = folder.path().join("a.txt");
        for text in ["one", "two, longer", ""] {
            write(&path, text.as_bytes()).expect("room");
            assert_eq!(fs::read(&path).expect("a file"), text.as_bytes());
        }
        assert_eq!(names(folder.path()), ["a.txt"]);
    }

    #[test]
    fn what_cannot_be_written_is_named_and_leaves_nothing() {
        let folder = tempfile::tempdir().expect("a folder");
        for path in [folder.path().to_owned(), folder.path().join("no/such")] {
            let error = write(&path, b"x").expect_err("not a file's place");
            let start = format!("cannot write {}: ", path.display());
            assert!(error.to_string().starts_with(&start), "{error}");
        }
        assert!(write(Path::new(""), b"x").is_err());
        assert!(names(folder.path()).is_empty());
    }

    #[cfg(unix)]
    #[test]
    fn permissions_and_links_stay_and_devices_are_no_files() {
        use std::os::unix::fs::{PermissionsExt, symlink};
        let folder = tempfile::tempdir().expect("a folder");
        let (path, link) = (folder.path().join("a"), folder.path().join("link"));
        write(&path, b"old").expect("room");
        let mode = |mode| fs::Permissions::from_mode(mode);
        fs::set_permissions(&path, mode(0o640)).expect("ours");
        symlink("a", &link).expect("room");
        write(&link, b"new").expect("room");
        assert!(link.is_symlink());
        assert_eq!(fs::read(&path).expect("a file"), b"new");
        let now = fs::metadata(&path).expect("a file").permissions();
        assert_eq!(now.mode() & 0o777, 0o640);
        write(Path::new("/dev/null"), b"x").expect("a device");
        if Path::new("/dev/full").exists() {
            assert!(write(Path::new("/dev/full"), b"x").is_err());
        }
    }
}
