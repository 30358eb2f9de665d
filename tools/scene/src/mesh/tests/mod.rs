//! Each format on a small sample, in all its variants.

mod colours;
mod damage;
mod edges;
mod formats;
mod normals;
pub(crate) mod samples;
mod textures;

use std::path::Path;

use super::{Loaded, parse};
use crate::description::Mesh;

fn load(name: &str, bytes: &[u8]) -> Result<Loaded, String> {
    parse(Path::new(name), bytes).map_err(|error| error.to_string())
}

fn mesh(name: &str, bytes: &[u8]) -> Mesh {
    load(name, bytes).unwrap().mesh
}

fn refused(name: &str, bytes: &[u8]) -> String {
    load(name, bytes).unwrap_err()
}
