//! The examples, a workspace of their own: checked, held to their golden frames, and built
//! for a chip.

use std::path::{Path, PathBuf};
use std::process::Command;

use crate::problem::Result;
use crate::report::Tally;
use crate::{child, paths, test, toolchain};

/// What they are built for, as a library without the desktop's program.
const TARGET: &str = "thumbv6m-none-eabi";

/// Runs all checks.
pub fn run(tally: &mut Tally) {
    let format = child::visibly(&mut cargo(&["fmt", "--check"]));
    tally.check("format of the examples", format);
    let lints = ["clippy", "--quiet", "--all-targets", "--", "-D", "warnings"];
    tally.check("lints of the examples", child::visibly(&mut cargo(&lints)));
    test::cargo_tests(tally, "the examples", &mut cargo(&["test", "--quiet"]));
    tally.check("examples for a chip", firmware());
}

/// Cargo in their folder, on the host.
pub fn cargo(arguments: &[&str]) -> Command {
    let mut command = Command::new("cargo");
    child::without_outer_package(&mut command);
    command.args(arguments).current_dir(folder());
    command
}

fn folder() -> PathBuf {
    paths::root().join("examples")
}

fn firmware() -> Result<()> {
    let mut command = for_chip("build", &folder())?;
    command.args(["--lib", "--no-default-features"]);
    child::visibly(&mut command)
}

/// Cargo for a chip in a folder; firmware of one run shares what it has built.
pub fn for_chip(subcommand: &str, folder: &Path) -> Result<Command> {
    let route = toolchain::provide(TARGET)?;
    let mut command = route.cargo(TARGET);
    command
        .args([subcommand, "--quiet", "--release", "--target", TARGET])
        .arg("--target-dir")
        .arg(paths::work("examples")?)
        .current_dir(folder);
    Ok(command)
}
