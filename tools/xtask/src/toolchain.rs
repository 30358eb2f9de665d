//! A compiler for each target, a formatter and lints, got where need be.
//!
//! For a target: what is installed already; else `rustup target add` (or the source of
//! `core`, of targets for which rustup has nothing else); else Debian's compiler with its source, when we are root on Debian, which then
//! builds `core` itself. Each only for the child process: no cargo
//! configuration is written, and host builds see nothing of it.
//! `FIXEL_TOOLCHAIN=rustup` or `=debian` takes one way only.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::Mutex;
use std::time::Duration;

use crate::problem::{Problem, Result};
use crate::{child, debian, paths};

/// Debian's compiler, its cargo, the source of `core`, and a linker.
const DEBIAN_PACKAGES: [&str; 4] = ["rustc-web", "cargo-web", "rust-web-src", "lld-22"];
const DEBIAN_LINKER: &str = "ld.lld-22";
/// The same linker under the name by which it asks for the kind of output.
const DEBIAN_WASM_LINKER: &str = "lld-22";
const DEBIAN_CORE: &str = "/usr/lib/rustlib/src/rust/library/core/Cargo.toml";
/// Targets that rustup has no `core` for, only its source.
const FROM_SOURCE: [&str; 1] = ["thumbv4t-none-eabi"];
/// How long a download may take before the next way is tried.
const DOWNLOAD_LIMIT: Duration = Duration::from_secs(300);

/// Which compiler builds for a target.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Route {
    /// The one that built this program, with the target's `core` beside it.
    Installed,
    /// The same, which builds `core` from the source beside it.
    Source,
    /// Debian's, which builds `core` from source.
    Debian,
}

impl Route {
    /// Cargo for builds for `target`, in a clean environment.
    pub fn cargo(self, target: &str) -> Command {
        let mut command = match self {
            Self::Installed | Self::Source => Command::new("cargo"),
            Self::Debian => Command::new("/usr/bin/cargo"),
        };
        child::without_outer_cargo(&mut command);
        if self != Self::Installed {
            command
                .env("RUSTC_BOOTSTRAP", "1")
                .env("CARGO_UNSTABLE_BUILD_STD", "core");
        }
        if self == Self::Debian {
            let path = std::env::var_os("PATH").unwrap_or_default();
            let mut folders = vec![PathBuf::from("/usr/bin")];
            folders.extend(std::env::split_paths(&path));
            let linker = format!(
                "CARGO_TARGET_{}_LINKER",
                target.to_uppercase().replace(['-', '.'], "_")
            );
            let program = if target.starts_with("wasm") {
                DEBIAN_WASM_LINKER
            } else {
                DEBIAN_LINKER
            };
            command
                .env("PATH", std::env::join_paths(folders).unwrap_or(path))
                .env(linker, program)
                .env_remove("RUSTUP_TOOLCHAIN");
        }
        command
    }

    /// The compiler's version, because figures depend on it.
    pub fn version(self) -> String {
        let rustc = match self {
            Self::Installed | Self::Source => "rustc",
            Self::Debian => "/usr/bin/rustc",
        };
        let version = child::output(Command::new(rustc).arg("--version"));
        version.unwrap_or_default().trim().to_owned()
    }
}

/// Finds or installs a compiler for `target`.
pub fn provide(target: &str) -> Result<Route> {
    static KNOWN: Mutex<BTreeMap<String, Result<Route>>> = Mutex::new(BTreeMap::new());
    let mut known = KNOWN.lock().map_err(|error| error.to_string())?;
    if let Some(route) = known.get(target) {
        return route.clone();
    }
    let route = search(target);
    if let Ok(route) = &route {
        eprintln!("{target}: {}", route.version());
    }
    known.insert(target.to_owned(), route.clone());
    route
}

fn search(target: &str) -> Result<Route> {
    let wanted = std::env::var("FIXEL_TOOLCHAIN").unwrap_or_default();
    if !["", "rustup", "debian"].contains(&wanted.as_str()) {
        return Err("FIXEL_TOOLCHAIN is neither `rustup` nor `debian`".into());
    }
    // Rustup may say that a target is there whose files are not.
    let added = || rustup(&["target", "add", target]) && has_core(target);
    let from_source = FROM_SOURCE.contains(&target);
    if from_source && wanted != "debian" {
        let added = || rustup(&["component", "add", "rust-src"]) && has_source();
        if has_source() || added() {
            return Ok(Route::Source);
        }
    } else if wanted != "debian" && (has_core(target) || added()) {
        return Ok(Route::Installed);
    }
    if wanted != "rustup" {
        if debian_is_complete() {
            return Ok(Route::Debian);
        }
        if debian::can_install() {
            match debian::install(&DEBIAN_PACKAGES) {
                Ok(()) if debian_is_complete() => return Ok(Route::Debian),
                Ok(()) => eprintln!("Debian's compiler is incomplete here"),
                Err(error) => eprintln!("{error}"),
            }
        }
    }
    let with_rustup = if from_source {
        "rustup component add rust-src".to_owned()
    } else {
        format!("rustup target add {target}")
    };
    Err(Problem::Missing(format!(
        "no compiler for {target}: `{with_rustup}` would bring it, \
         or as root on Debian `apt-get install {}`",
        DEBIAN_PACKAGES.join(" ")
    )))
}

/// Whether the compiler at hand has the target's `core`.
fn has_core(target: &str) -> bool {
    rustlib().is_some_and(|folder| folder.join(target).join("lib").is_dir())
}

/// Whether it has the source of `core`.
fn has_source() -> bool {
    rustlib().is_some_and(|folder| folder.join("src/rust/library/core/Cargo.toml").is_file())
}

/// Where the compiler at hand keeps libraries.
fn rustlib() -> Option<PathBuf> {
    let mut command = Command::new("rustc");
    command
        .args(["--print", "sysroot"])
        .current_dir(paths::root());
    let sysroot = child::output(&mut command)?;
    Some(Path::new(sysroot.trim()).join("lib/rustlib"))
}

fn debian_is_complete() -> bool {
    let files = ["/usr/bin/cargo", "/usr/bin/rustc", DEBIAN_CORE];
    files.iter().all(|file| Path::new(file).exists()) && debian::which(DEBIAN_LINKER).is_some()
}

/// Asks rustup for something; whether it came.
fn rustup(arguments: &[&str]) -> bool {
    if debian::which("rustup").is_none() {
        return false;
    }
    let mut command = Command::new("rustup");
    command.args(arguments).current_dir(paths::root());
    eprintln!("$ {}", child::shown(&command));
    match child::bounded(&mut command, DOWNLOAD_LIMIT) {
        Ok(finished) => {
            eprint!("{}", finished.stderr);
            finished.success
        }
        Err(problem) => {
            eprintln!("{problem}");
            false
        }
    }
}

/// Makes sure that `cargo NAME` works, for a component of that name in rustup
/// (`clippy`, or `rustfmt` for `cargo fmt`).
pub fn component(subcommand: &str, component: &str) -> Result<()> {
    /// One rustup runs at a time.
    static ALONE: Mutex<()> = Mutex::new(());
    let _alone = ALONE.lock().map_err(|error| error.to_string())?;
    let works = || {
        let mut command = Command::new("cargo");
        command
            .args([subcommand, "--version"])
            .current_dir(paths::root());
        child::output(&mut command).is_some()
    };
    if works() || (rustup(&["component", "add", component]) && works()) {
        return Ok(());
    }
    Err(Problem::Missing(format!(
        "no `cargo {subcommand}`: `rustup component add {component}` would bring it"
    )))
}

/// The host's compiler in an older version, by `rustup run`.
pub fn version(version: &str) -> Result<()> {
    let works = || {
        let mut command = Command::new("rustup");
        command.args(["run", version, "cargo", "--version"]);
        child::output(&mut command).is_some()
    };
    let install = ["toolchain", "install", version, "--profile", "minimal"];
    if works() || (rustup(&install) && works()) {
        return Ok(());
    }
    Err(Problem::Missing(format!(
        "no Rust {version}: `rustup {}` would bring it",
        install.join(" ")
    )))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn variable(command: &Command, name: &str) -> Option<String> {
        let mut variables = command.get_envs();
        let (_, value) = variables.find(|(key, _)| *key == name)?;
        Some(value?.to_string_lossy().into_owned())
    }

    #[test]
    fn debian_is_environment_only() {
        let command = Route::Debian.cargo("thumbv6m-none-eabi");
        let linker = variable(&command, "CARGO_TARGET_THUMBV6M_NONE_EABI_LINKER");
        assert_eq!(linker.as_deref(), Some(DEBIAN_LINKER));
        assert_eq!(
            variable(&command, "CARGO_UNSTABLE_BUILD_STD").as_deref(),
            Some("core")
        );
        assert!(command.get_args().next().is_none());
    }

    #[test]
    fn an_installed_compiler_needs_nothing_special() {
        let command = Route::Installed.cargo("thumbv6m-none-eabi");
        assert!(command.get_envs().all(|(_, value)| value.is_none()));
    }

    #[test]
    fn core_from_source_takes_the_usual_linker() {
        let command = Route::Source.cargo("thumbv4t-none-eabi");
        let std = variable(&command, "CARGO_UNSTABLE_BUILD_STD");
        assert_eq!(std.as_deref(), Some("core"));
        let linker = variable(&command, "CARGO_TARGET_THUMBV4T_NONE_EABI_LINKER");
        assert_eq!(linker, None);
    }
}
