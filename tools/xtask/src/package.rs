//! The crates that are published: packaged without a warning, each built from its package,
//! small, and built with the oldest compiler that they promise to take.

use std::fs;
use std::path::PathBuf;
use std::process::Command;
use std::time::Duration;

use crate::problem::Result;
use crate::report::Tally;
use crate::{child, paths, test, toolchain};

/// Those of the workspace that are for this repository alone.
const PRIVATE: [&str; 4] = ["fixel-simulator", "fixel-start", "fixel-tests", "xtask"];
/// The least version of the compiler, as the manifests say.
const OLDEST: &str = concat!(env!("CARGO_PKG_RUST_VERSION"), ".0");
/// Largest package, in bytes: one that takes scenes or pictures along is larger.
const MOST_BYTES: u64 = 400_000;
/// A build that takes longer hangs.
const LIMIT: Duration = Duration::from_secs(1800);

/// Packages them in the order in which they need each other.
pub fn run(tally: &mut Tally) {
    if tally
        .check("packages of the published crates", package())
        .is_some()
    {
        tally.check("packages are small", sizes());
    }
    let name = format!("the published crates with Rust {OLDEST}");
    tally.check(&name, with_oldest());
}

/// Where cargo puts packages.
fn folder() -> PathBuf {
    let target = std::env::var_os("CARGO_TARGET_DIR").map(PathBuf::from);
    let target = target.unwrap_or_else(|| paths::root().join("target"));
    target.join("package")
}

/// What the compiler's own lint does not see: the language, and what others' crates need.
fn with_oldest() -> Result<()> {
    toolchain::version(OLDEST)?;
    let mut command = Command::new("rustup");
    child::without_outer_cargo(&mut command);
    command
        .args(["run", OLDEST, "cargo", "check", "--quiet", "--workspace"])
        .args(PRIVATE.map(|private| format!("--exclude={private}")))
        .arg("--target-dir")
        .arg(paths::work("oldest")?)
        .current_dir(paths::root());
    child::visibly(&mut command)
}

fn package() -> Result<()> {
    // Those of an earlier version would be measured too.
    let _ = fs::remove_dir_all(folder());
    let mut command = test::cargo(&["package", "--workspace", "--allow-dirty"]);
    for private in PRIVATE {
        command.args(["--exclude", private]);
    }
    let packaged = child::bounded(&mut command, LIMIT)?;
    eprint!("{}", packaged.stderr);
    if !packaged.success {
        return Err("cargo package failed".into());
    }
    let mut lines = packaged.stderr.lines();
    // Tests have scenes of the repository.
    let harmless = |line: &str| line.starts_with("warning: ignoring test");
    match lines.find(|line| line.starts_with("warning") && !harmless(line)) {
        Some(warning) => Err(warning.into()),
        None => Ok(()),
    }
}

fn sizes() -> Result<()> {
    let folder = folder();
    let fail = |error| format!("{}: {error}", folder.display());
    let mut packages = 0;
    for entry in fs::read_dir(&folder).map_err(fail)? {
        let path = entry.map_err(fail)?.path();
        if path.extension().is_none_or(|kind| kind != "crate") {
            continue;
        }
        packages += 1;
        let bytes = fs::metadata(&path).map_err(fail)?.len();
        let name = path.file_name().unwrap_or_default().display();
        eprintln!("      {name}: {bytes} bytes");
        if bytes > MOST_BYTES {
            return Err(format!("{name} has {bytes} bytes, more than {MOST_BYTES}").into());
        }
    }
    match packages {
        0 => Err("there are no packages".into()),
        _ => Ok(()),
    }
}
