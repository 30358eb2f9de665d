//! When a scene's files change.

use std::fs;
use std::path::{Path, PathBuf};
use std::time::SystemTime;

/// What tells one content of a file from another.
type Stamp = Option<(SystemTime, u64)>;

/// The files of a scene, looked at now and then.
#[derive(Debug)]
pub struct Watch {
    path: PathBuf,
    files: Vec<(PathBuf, Stamp)>,
    changed: bool,
}

impl Watch {
    /// A scene file, mesh or blob, and what it names.
    pub fn new(path: &Path) -> Self {
        let mut watch = Self {
            path: path.to_owned(),
            files: Vec::new(),
            changed: false,
        };
        watch.find();
        watch
    }

    /// Whether a file changed and has come to rest: editors and exporters take their time.
    pub fn poll(&mut self) -> bool {
        let mut moved = false;
        for (path, stamp) in &mut self.files {
            let now = self::stamp(path);
            moved |= now != *stamp;
            *stamp = now;
        }
        let rests = self.changed && !moved;
        self.changed = moved;
        if rests {
            self.find();
        }
        rests
    }

    fn find(&mut self) {
        let mut files = vec![self.path.clone()];
        let mut next = 0;
        while let Some(path) = files.get(next).cloned() {
            for named in named(&path) {
                if !files.contains(&named) {
                    files.push(named);
                }
            }
            next += 1;
        }
        let stamped = files.into_iter().map(|path| (path.clone(), stamp(&path)));
        self.files = stamped.collect();
    }
}

fn stamp(path: &Path) -> Stamp {
    let data = fs::metadata(path).ok()?;
    Some((data.modified().ok()?, data.len()))
}

/// Files that a text file of a scene names, whatever for: what stands in quotes, or after a
/// line's first word, and is there.
fn named(path: &Path) -> Vec<PathBuf> {
    const TEXTS: [&str; 4] = ["toml", "obj", "mtl", "gltf"];
    let kind = path.extension().map(|kind| kind.to_ascii_lowercase());
    let is_text = kind.is_some_and(|kind| TEXTS.iter().any(|text| kind == *text));
    let Some(text) = is_text.then(|| fs::read_to_string(path).ok()).flatten() else {
        return Vec::new();
    };
    let folder = path.parent().unwrap_or(Path::new(""));
    let quoted = text.split(['"', '\'']).skip(1).step_by(2);
    // Vertices and faces are lines too, and many.
    let lines = text
        .lines()
        .filter(|line| line.contains('.') && line.contains(char::is_alphabetic));
    let rests = lines.filter_map(|line| line.trim().split_once(char::is_whitespace));
    let names = quoted.chain(rests.map(|(_, rest)| rest.trim()));
    let names = names.filter(|name| name.len() < 256 && name.contains('.') && !is_numbers(name));
    let files = names.map(|name| folder.join(name));
    files.filter(|file| file.is_file()).collect()
}

fn is_numbers(text: &str) -> bool {
    text.chars()
        .all(|c| c.is_ascii_digit() || " .-+eE/\t".contains(c))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn files_are_found_through_files() {
        let folder = tempfile::tempdir().expect("a folder");
        let path = |name: &str| folder.path().join(name);
        let write = |name: &str, text: &str| fs::write(path(name), text).expect("room");
        write(
            "a.toml",
            "[[actor]]\nmesh = \"my cube.obj\"\n# x = \"none.png\"\n",
        );
        write("my cube.obj", "mtllib b.mtl\nv 0 0 0.5\nf 1 1 1\n");
        write("b.mtl", "newmtl x\nmap_Kd c.png\n");
        write("c.png", "");
        let mut watch = Watch::new(&path("a.toml"));
        let names: Vec<_> = watch.files.iter().map(|(file, _)| file.clone()).collect();
        assert_eq!(names, ["a.toml", "my cube.obj", "b.mtl", "c.png"].map(path));
        assert!(!watch.poll());
        write("c.png", "changed");
        // It moves; it rests; it has been told.
        assert!(!watch.poll());
        assert!(watch.poll());
        assert!(!watch.poll());
        fs::remove_file(path("a.toml")).expect("it is there");
        assert!(!watch.poll());
        assert!(watch.poll());
        write("a.toml", "new");
        assert!(!watch.poll());
        assert!(watch.poll());
        assert_eq!(watch.files.len(), 1);
    }
}
