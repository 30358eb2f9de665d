//! A scene file, or a bare mesh, becomes a [`Scene`]: plain data with every
//! default filled in. In: TOML, OBJ, glTF, STL, PLY. Out: [`Scene`], read by
//! the baker, the f64 reference and the commands.

mod description;

pub use description::*;
