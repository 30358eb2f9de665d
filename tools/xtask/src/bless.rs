//! Rewrites golden frames, after a person has looked at them.

use crate::problem::Result;

/// Golden frames are not there yet.
pub fn run() -> Result<()> {
    Err("there are no golden frames yet".into())
}
