//! Scene files: what is read, what is refused, and what the documentation says of it.

mod documentation;
mod messages;
mod readings;

use std::path::PathBuf;

use super::parse;
use crate::description::Scene;

/// A scene file that is not there, among the repository's scenes.
fn path() -> PathBuf {
    PathBuf::from(concat!(env!("CARGO_MANIFEST_DIR"), "/../../scenes/t.toml"))
}

fn read(text: &str) -> Result<Scene, String> {
    parse(&path(), text, &mut Vec::new()).map_err(|error| {
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
