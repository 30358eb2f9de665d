//! `cargo fixel`: builds the command `fixel` and runs it.
//!
//! `cargo run` either talks on standard error each time or builds in silence. The first build
//! takes minutes, so cargo shows how it goes there, on a terminal; after that, and for scripts,
//! standard error has what the command itself says and nothing else. Takes no other crate, so
//! that it is built in a moment.

use std::env::{self, consts::EXE_SUFFIX};
use std::io::{self, IsTerminal};
use std::path::Path;
use std::process::{Command, ExitCode, ExitStatus};

const FIXEL: [&str; 5] = ["--release", "--package", "fixel-cli", "--bin", "fixel"];
/// What cargo says of this crate, and must not say of others: they would be built anew.
const OF_THIS: [&str; 4] = [
    "CARGO_PKG_",
    "CARGO_MANIFEST_",
    "CARGO_BIN_",
    "CARGO_CRATE_",
];

fn main() -> ExitCode {
    match start() {
        Ok(status) => ExitCode::from(code(status)),
        Err(error) => {
            eprintln!("fixel: cargo does not start: {error}; expected it on the path");
            ExitCode::FAILURE
        }
    }
}

fn start() -> io::Result<ExitStatus> {
    let own = env::current_exe()?;
    if io::stderr().is_terminal() && !is_built(&own) {
        eprintln!("building fixel, once; this takes a few minutes");
        let built = cargo("build").args(FIXEL).status()?;
        if !built.success() {
            return Ok(built);
        }
    }
    let mut run = cargo("run");
    run.arg("--quiet").args(FIXEL).arg("--");
    run.args(env::args_os().skip(1)).status()
}

/// Whether the command is there, perhaps of an earlier state: beside this program, which is in
/// the folder of unoptimised ones.
fn is_built(own: &Path) -> bool {
    let target = own.ancestors().nth(2);
    target.is_some_and(|target| {
        let command = target.join("release").join(format!("fixel{EXE_SUFFIX}"));
        command.exists()
    })
}

fn cargo(what: &str) -> Command {
    let program = env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let mut command = Command::new(program);
    command.arg(what);
    for (name, _) in env::vars_os() {
        let text = name.to_string_lossy();
        if OF_THIS.iter().any(|start| text.starts_with(start)) {
            command.env_remove(&name);
        }
    }
    command
}

/// The command's own; 1 if something ended it.
fn code(status: ExitStatus) -> u8 {
    status.code().map_or(1, |code| code as u8)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::fs;

    #[test]
    fn the_command_is_looked_for_where_cargo_puts_it() {
        let target = env::temp_dir().join(format!("fixel-start-{}", std::process::id()));
        let own = target.join("debug/fixel-start");
        let release = target.join("release");
        fs::create_dir_all(&release).expect("room");
        assert!(!is_built(&own));
        fs::write(release.join(format!("fixel{EXE_SUFFIX}")), "").expect("room");
        assert!(is_built(&own));
        fs::remove_dir_all(target).expect("ours");
    }

    /// The alias leads here.
    #[test]
    fn the_alias_is_this() {
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
        let config = fs::read_to_string(root.join(".cargo/config.toml")).expect("a file");
        let alias = "fixel = \"run --quiet --package fixel-start --\"\n";
        assert!(config.contains(alias), "{config}");
    }
}
