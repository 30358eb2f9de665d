//! Builds the crates in `targets/`.

use std::path::{Path, PathBuf};
use std::process::Command;

use crate::board::{Board, Machine};
use crate::device::Device;
use crate::problem::{Problem, Result};
use crate::toolchain::{self, Route};
use crate::{child, elf, paths, scene};

/// How the host's measuring program is built.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum HostProfile {
    /// As firmware is.
    Release,
    /// Arithmetic that overflows stops it, and the renderer has the smallest
    /// working memory.
    Checked,
}

/// Builds the measuring firmware of a board; it reads its scene from memory.
pub fn measuring(board: &Board) -> Result<PathBuf> {
    let route = toolchain::provide(board.target)?;
    let mut command = cargo_build(route, board);
    command.args(["--bin", "measure"]);
    if let Some(features) = board.features {
        command.args(["--no-default-features", "--features", features]);
    }
    child::visibly(&mut command)?;
    Ok(built(board, "measure"))
}

/// A demo firmware with its scene linked in.
#[derive(Clone, Debug)]
pub struct Demo {
    /// The ELF file.
    pub path: PathBuf,
    /// What it holds.
    pub image: elf::Image,
}

/// What of the renderer a demo links.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Parts {
    /// Flat shading in grey light from infinitely far.
    Flat,
    /// Gouraud shading as well.
    Gouraud,
    /// The same with the lists and bands of chips with 20 KB of RAM.
    Compact,
    /// Everything but rays.
    Triangles,
    /// Rays alone, with everything that they show.
    Rays,
    /// Everything.
    All,
}

impl Parts {
    /// In a table.
    pub fn name(self) -> &'static str {
        match self {
            Self::Flat => "flat shading alone",
            Self::Gouraud => "flat and Gouraud",
            Self::Compact => "flat and Gouraud, bands of 8 rows",
            Self::Triangles => "everything but rays",
            Self::Rays => "rays alone",
            Self::All => "everything",
        }
    }

    fn features(self) -> &'static str {
        match self {
            Self::Flat => "demo",
            Self::Gouraud => "demo,gouraud",
            Self::Compact => "demo,gouraud,compact",
            Self::Triangles => "demo,triangles",
            Self::Rays => "demo,rays-alone",
            Self::All => "demo,whole",
        }
    }
}

/// Builds the demo firmware of a board with a scene linked in. A board with features of
/// its own links those parts.
pub fn demo(board: &Board, scene: &scene::Baked, parts: Parts) -> Result<Demo> {
    build_demo(board, scene, &demo_features(board, parts), &[])
}

/// Builds the demo firmware of a board with little flash, with a scene linked in: loops are not
/// unrolled for speed. Optimised for size, a check for a divisor of 0 would stay in it.
pub fn small_demo(board: &Board, scene: &scene::Baked) -> Result<Demo> {
    let level = [("CARGO_PROFILE_RELEASE_OPT_LEVEL", "2")];
    build_demo(board, scene, &demo_features(board, Parts::Compact), &level)
}

fn demo_features(board: &Board, parts: Parts) -> String {
    match board.features {
        Some(own) => format!("demo,{own}"),
        None => parts.features().to_owned(),
    }
}

/// Builds a demo that breaks the promises which are checked on every demo.
pub fn faulty_demo(board: &Board, scene: &scene::Baked) -> Result<Demo> {
    build_demo(board, scene, "faulty,gouraud", &[])
}

fn build_demo(
    board: &Board,
    scene: &scene::Baked,
    features: &str,
    environment: &[(&str, &str)],
) -> Result<Demo> {
    let route = toolchain::provide(board.target)?;
    let mut command = cargo_build(route, board);
    command
        .args([
            "--bin",
            "demo",
            "--no-default-features",
            "--features",
            features,
        ])
        .envs(environment.iter().copied())
        .env("FIXEL_SCENE", &scene.path);
    child::visibly(&mut command)?;
    let more = format!("-{}", features.replace(',', "-"));
    kept(&built(board, "demo"), board.name, scene, &more)
}

/// Builds the host's measuring program.
pub fn host(profile: HostProfile) -> Result<PathBuf> {
    match profile {
        HostProfile::Release => host_program("host", "measure", "release", None),
        HostProfile::Checked => host_program("host", "measure", "checked", Some("small")),
    }
}

/// Builds a program for this machine that is in `targets/`.
pub fn host_program(
    folder: &str,
    name: &str,
    profile: &str,
    features: Option<&str>,
) -> Result<PathBuf> {
    let target_folder = paths::target_crate(folder).join("target");
    let mut command = Command::new("cargo");
    child::without_outer_cargo(&mut command);
    command
        .args(["build", "--quiet", "--profile", profile])
        .arg("--manifest-path")
        .arg(manifest(folder))
        .arg("--target-dir")
        .arg(&target_folder)
        .current_dir(paths::root());
    if let Some(features) = features {
        command.args(["--features", features]);
    }
    child::visibly(&mut command)?;
    let name = format!("{name}{}", std::env::consts::EXE_SUFFIX);
    Ok(target_folder.join(profile).join(name))
}

/// Clippy over a board's crate.
pub fn clippy(board: &Board, scene: &scene::Baked) -> Result<()> {
    let route = with_clippy(board.target)?;
    let mut command = cargo(route, board, "clippy");
    if board.is_elf() {
        let features = demo_features(board, Parts::All);
        command.args(["--no-default-features", "--features", &features]);
    }
    command
        .env("FIXEL_SCENE", &scene.path)
        .args(["--", "-D", "warnings"]);
    child::visibly(&mut command)
}

/// Clippy over a device's crate.
pub fn clippy_device(device: &Device, scene: &scene::Baked) -> Result<()> {
    let route = with_clippy(device.target)?;
    let mut command = cargo_for(route, device.folder, device.target, "clippy");
    command
        .arg("--target-dir")
        .arg(paths::target_crate(device.folder).join("target"))
        .args(["--features", device.features])
        .env("FIXEL_SCENE", &scene.path)
        .args(["--", "-D", "warnings"]);
    child::visibly(&mut command)
}

/// A compiler for a target that comes with clippy, which Debian's does not.
fn with_clippy(target: &str) -> Result<Route> {
    toolchain::component("clippy", "clippy")?;
    let route = toolchain::provide(target)?;
    if route == Route::Debian {
        return Err(Problem::Missing(format!(
            "clippy for {target} needs the target in rustup: `rustup target add {target}`"
        )));
    }
    Ok(route)
}

/// A crate's manifest in `targets/`.
pub fn manifest(folder: &str) -> PathBuf {
    paths::target_crate(folder).join("Cargo.toml")
}

fn cargo(route: Route, board: &Board, subcommand: &str) -> Command {
    let mut command = cargo_for(route, board.folder, board.target, subcommand);
    command.arg("--target-dir").arg(target_folder(board));
    command
}

/// Cargo for a crate in `targets/`.
pub fn cargo_for(route: Route, folder: &str, target: &str, subcommand: &str) -> Command {
    let mut command = route.cargo(target);
    command
        .args([subcommand, "--quiet", "--release"])
        .args(["--target", target])
        .arg("--manifest-path")
        .arg(manifest(folder))
        .current_dir(paths::root());
    command
}

fn cargo_build(route: Route, board: &Board) -> Command {
    cargo(route, board, "build")
}

/// Builds the firmware of a board with a panel, with a scene linked in.
pub fn device(device: &Device, scene: &scene::Baked) -> Result<Demo> {
    let route = toolchain::provide(device.target)?;
    let folder = paths::target_crate(device.folder).join("target");
    let mut command = cargo_for(route, device.folder, device.target, "build");
    command
        .arg("--target-dir")
        .arg(&folder)
        .args(["--bin", device.binary, "--features", device.features])
        .env("FIXEL_SCENE", &scene.path);
    child::visibly(&mut command)?;
    let built = folder.join(device.target).join("release");
    kept(&built.join(device.binary), device.name, scene, "")
}

/// Copies a firmware to where the next one does not overwrite it.
fn kept(built: &Path, board: &str, scene: &scene::Baked, more: &str) -> Result<Demo> {
    let stem = scene.path.file_stem().unwrap_or_default().to_string_lossy();
    let path = paths::work("firmware")?.join(format!("{board}-{stem}{more}.elf"));
    std::fs::copy(built, &path).map_err(|error| format!("{}: {error}", path.display()))?;
    let image = elf::Image::read(&path)?;
    Ok(Demo { path, image })
}

/// Boards whose firmware differs in its features alone do not overwrite each other's, and those
/// for other targets can be built meanwhile.
fn target_folder(board: &Board) -> PathBuf {
    let own = board.features.map_or(board.target, |_| board.name);
    paths::target_crate(board.folder).join("target").join(own)
}

fn built(board: &Board, binary: &str) -> PathBuf {
    let folder = target_folder(board).join(board.target);
    let name = match board.machine {
        Machine::Qemu(_) | Machine::Mgba => binary.to_owned(),
        Machine::Node(_) => format!("{binary}.wasm"),
    };
    folder.join("release").join(Path::new(&name))
}
