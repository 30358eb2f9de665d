//! Scene files: what is read, what is refused, and what the documentation says of it.

mod documentation;
mod messages;
mod panels;
mod readings;

use std::path::{Path, PathBuf};

use super::parse;
use crate::description::Scene;
use crate::error::Error;
use crate::files::{Disk, Origin};
use crate::panel::Screen;

/// A scene file that is not there, among the repository's scenes.
fn path() -> PathBuf {
    PathBuf::from(concat!(env!("CARGO_MANIFEST_DIR"), "/../../scenes/t.toml"))
}

/// What a file of this machine says, for a panel if there is one.
fn parse_at(path: &Path, text: &str, screen: Option<Screen>) -> Result<Scene, Error> {
    let origin = Origin { path, files: &Disk };
    parse(origin, text, screen, &mut Vec::new())
}

fn read(text: &str) -> Result<Scene, String> {
    parse_at(&path(), text, None).map_err(|error| {
        let folder = format!("{}/", path().parent().unwrap().display());
        let line = error.to_string();
        assert!(!line.contains('\n'), "{line}");
        line.replace(&folder, "")
    })
}

const ACTOR: &str = "[[actor]]\nmesh = \"meshes/cube.obj\"\n";

/// The message for `text` before an actor that is in order.
fn refused(text: &str) -> String {
    read(&format!("{text}\n{ACTOR}")).unwrap_err()
}
