//! Which of this machine's files a scene may name: one from somebody else shall not read what
//! it has no business with.

use std::path::{Path, PathBuf};

use crate::files::{Disk, Files};

/// The files of this machine that are below some folders, symbolic links followed: the
/// scene's own, the current one, those of the project that holds the scene (the nearest
/// with a `.git`), and what the user allows.
#[derive(Clone, Debug)]
pub struct Fenced {
    roots: Vec<PathBuf>,
}

impl Fenced {
    /// For a scene's path, and folders that the user allows.
    ///
    /// # Errors
    /// If one of these is no folder: which.
    pub fn around(scene: &Path, allowed: &[PathBuf]) -> Result<Self, String> {
        let mut roots = Vec::new();
        for folder in allowed {
            let whole = folder.canonicalize().ok().filter(|path| path.is_dir());
            let missing = || format!("{}: no folder; expected one to read from", folder.display());
            roots.push(whole.ok_or_else(missing)?);
        }
        // A scene that is not there is an error of its own.
        let own = match scene.parent() {
            Some(folder) if folder != Path::new("") => folder.canonicalize().ok(),
            _ => Path::new(".").canonicalize().ok(),
        };
        let mut above = own.iter().flat_map(|own| own.ancestors());
        let project = above.find(|folder| folder.join(".git").exists());
        roots.extend(project.map(Path::to_owned));
        roots.extend(Path::new(".").canonicalize());
        roots.extend(own);
        Ok(Self { roots })
    }
}

impl Files for Fenced {
    fn read(&self, path: &Path) -> Result<Vec<u8>, String> {
        if let Ok(real) = path.canonicalize()
            && !self.roots.iter().any(|root| real.starts_with(root))
        {
            return Err(
                "is outside of the folders of scene, project and user; expected it below \
                 one of them, or its folder allowed (--allow FOLDER)"
                    .to_owned(),
            );
        }
        Disk.read(path)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::fs;

    #[test]
    fn files_elsewhere_are_read_if_they_are_allowed() {
        let folder = tempfile::tempdir().expect("a folder");
        let path = |name: &str| folder.path().join(name);
        for name in ["scenes/meshes", "other", "project/.git", "project/scenes"] {
            fs::create_dir_all(path(name)).expect("room");
        }
        for name in ["scenes/meshes/a.obj", "other/b.obj", "project/c.obj"] {
            fs::write(path(name), name).expect("room");
        }
        let read = |scene: &str, allowed: &[PathBuf], name: &str| {
            let files = Fenced::around(&path(scene), allowed).expect("folders");
            files.read(&path(name)).map(|bytes| bytes.len())
        };
        let scene = "scenes/s.toml";
        assert_eq!(read(scene, &[], "scenes/meshes/../meshes/a.obj"), Ok(19));
        let refused = read(scene, &[], "scenes/../other/b.obj").unwrap_err();
        assert!(
            refused.starts_with("is outside of the folders"),
            "{refused}"
        );
        assert!(read(scene, &[], "other/b.obj").is_err());
        assert_eq!(read(scene, &[path("other")], "other/b.obj"), Ok(11));
        // The project of the scene, but not that of what it names.
        let inside = "project/scenes/s.toml";
        assert_eq!(read(inside, &[], "project/scenes/../c.obj"), Ok(13));
        assert!(read(scene, &[], "project/c.obj").is_err());
        assert_eq!(
            read(scene, &[], "scenes/none.obj"),
            Err("does not exist".to_owned())
        );
        assert!(Fenced::around(&path(scene), &[path("none")]).is_err());
    }

    #[cfg(unix)]
    #[test]
    fn links_lead_nowhere_else() {
        let folder = tempfile::tempdir().expect("a folder");
        let path = |name: &str| folder.path().join(name);
        fs::create_dir(path("scenes")).expect("room");
        fs::write(path("secret.obj"), "v").expect("room");
        std::os::unix::fs::symlink(path("secret.obj"), path("scenes/a.obj")).expect("a link");
        let files = Fenced::around(&path("scenes/s.toml"), &[]).expect("folders");
        assert!(files.read(&path("scenes/a.obj")).is_err());
    }
}
