//! Temporary files that are being written, so that who stops the program leaves none.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};

struct Begun {
    files: Vec<PathBuf>,
    stopped: bool,
}

static BEGUN: Mutex<Begun> = Mutex::new(Begun {
    files: Vec::new(),
    stopped: false,
});

fn begun() -> MutexGuard<'static, Begun> {
    BEGUN.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Takes away what is half written; nothing can be written afterwards. For whoever is told to
/// end the program, and then does.
pub fn stop() {
    let mut begun = begun();
    begun.stopped = true;
    for file in begun.files.drain(..) {
        // It may be whole, and renamed, by now.
        let _ = fs::remove_file(file);
    }
}

/// A temporary file that is about to be made.
pub(crate) fn begin(file: &Path) -> io::Result<()> {
    let mut begun = begun();
    if begun.stopped {
        return Err(io::ErrorKind::Interrupted.into());
    }
    begun.files.push(file.to_owned());
    Ok(())
}

/// The file has its name, or is gone.
pub(crate) fn end(file: &Path) {
    begun().files.retain(|begun| begun != file);
}
