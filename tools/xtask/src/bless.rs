//! Rewrites golden frames, after a person has looked at them.

use std::process::Command;

use crate::problem::Result;
use crate::{child, examples, paths};

/// Runs the golden frames' tests so that they write `tests/golden` and `examples/golden` anew.
pub fn run() -> Result<()> {
    let mut frames = Command::new("cargo");
    frames
        .args(["test", "--quiet", "--package", "fixel-tests"])
        .args(["--test", "frames", "golden_frames"])
        .current_dir(paths::root());
    let mut examples = examples::cargo(&["test", "--quiet", "--test", "golden", "golden_frames"]);
    for command in [&mut frames, &mut examples] {
        child::visibly(command.env("FIXEL_BLESS", "1"))?;
    }
    eprintln!("golden frames are written anew: look at each changed picture beside the reference");
    Ok(())
}
