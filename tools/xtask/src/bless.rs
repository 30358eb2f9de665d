//! Rewrites golden frames, after a person has looked at them.

use std::process::Command;

use crate::problem::Result;
use crate::{child, paths};

/// Runs the golden frames' test so that it writes `tests/golden` anew.
pub fn run() -> Result<()> {
    let mut command = Command::new("cargo");
    command
        .args(["test", "--quiet", "--package", "fixel-tests"])
        .args(["--test", "frames", "golden_frames"])
        .env("FIXEL_BLESS", "1")
        .current_dir(paths::root());
    child::visibly(&mut command)?;
    eprintln!("tests/golden is written anew: look at each changed picture beside the reference");
    Ok(())
}
