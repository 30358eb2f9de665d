//! `[lod]`.

use super::table::{Keys, Table};
use crate::description::Lod;
use crate::error::Error;

pub(super) const LOD: Keys = Keys {
    known: &["error"],
    later: &[],
};

/// Reads how much detail may be left out; the table's being there asks for it.
pub(super) fn lod(table: &Table<'_, '_>) -> Result<Lod, Error> {
    let error = table.number("error", 0.01..=8.0)?;
    Ok(error.map_or(Lod::default(), |error| Lod { error }))
}
