//! Each format on a small sample, in all its variants.

mod colours;
mod damage;
mod edges;
mod formats;
mod materials;
mod normals;
pub(crate) mod samples;
mod textures;

use std::path::Path;

use super::{Loaded, parse};
use crate::description::Mesh;
use crate::files::{Disk, Origin};

/// A file of this machine.
fn on_disk(name: &str) -> Origin<'_> {
    Origin {
        path: Path::new(name),
        files: &Disk,
    }
}

fn load(name: &str, bytes: &[u8]) -> Result<Loaded, String> {
    parse(on_disk(name), bytes).map_err(|error| error.to_string())
}

fn mesh(name: &str, bytes: &[u8]) -> Mesh {
    load(name, bytes).unwrap().mesh
}

fn refused(name: &str, bytes: &[u8]) -> String {
    load(name, bytes).unwrap_err()
}
