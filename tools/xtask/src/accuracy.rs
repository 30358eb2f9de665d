//! `compare` over every scene.

use serde_json::{Value, json};

use crate::problem::Result;
use crate::report::Tally;

/// Compares every scene in `scenes/` with the f64 reference. The renderer is
/// not there yet: one skipped check says so.
pub fn run(tally: &mut Tally) -> Result<Value> {
    tally.skip("accuracy", "the renderer is not in the core yet");
    Ok(json!({}))
}
