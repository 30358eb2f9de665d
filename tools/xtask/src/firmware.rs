//! Builds the crates in `targets/`.

use std::path::{Path, PathBuf};
use std::process::Command;

use crate::board::{Board, Machine};
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
            Self::Triangles => "everything but rays",
            Self::Rays => "rays alone",
            Self::All => "everything",
        }
    }

    fn features(self) -> &'static str {
        match self {
            Self::Flat => "demo",
            Self::Gouraud => "demo,gouraud",
            Self::Triangles => "demo,triangles",
            Self::Rays => "demo,rays-alone",
            Self::All => "demo,whole",
        }
    }
}

/// Builds the demo firmware of a board with a scene linked in.
pub fn demo(board: &Board, scene: &scene::Baked, parts: Parts) -> Result<Demo> {
    build_demo(board, scene, parts.features())
}

/// Builds a demo that breaks the promises which are checked on every demo.
pub fn faulty_demo(board: &Board, scene: &scene::Baked) -> Result<Demo> {
    build_demo(board, scene, "faulty,gouraud")
}

fn build_demo(board: &Board, scene: &scene::Baked, features: &str) -> Result<Demo> {
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
        .env("FIXEL_SCENE", &scene.path);
    child::visibly(&mut command)?;
    let stem = scene.path.file_stem().unwrap_or_default().to_string_lossy();
    let features = features.replace(',', "-");
    let name = format!("{}-{stem}-{features}.elf", board.name);
    let path = paths::work("firmware")?.join(name);
    std::fs::copy(built(board, "demo"), &path)
        .map_err(|error| format!("{}: {error}", path.display()))?;
    let image = elf::Image::read(&path)?;
    Ok(Demo { path, image })
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

/// Clippy over a board's crate. Debian's compiler comes without clippy.
pub fn clippy(board: &Board, scene: &scene::Baked) -> Result<()> {
    toolchain::component("clippy", "clippy")?;
    let route = toolchain::provide(board.target)?;
    if route == Route::Debian {
        return Err(Problem::Missing(format!(
            "clippy for {0} needs the target in rustup: `rustup target add {0}`",
            board.target
        )));
    }
    let mut command = cargo(route, board, "clippy");
    command
        .args(["--features", "demo"])
        .env("FIXEL_SCENE", &scene.path)
        .args(["--", "-D", "warnings"]);
    child::visibly(&mut command)
}

/// A crate's manifest in `targets/`.
pub fn manifest(folder: &str) -> PathBuf {
    paths::target_crate(folder).join("Cargo.toml")
}

fn cargo(route: Route, board: &Board, subcommand: &str) -> Command {
    let mut command = route.cargo(board.target);
    command
        .args([subcommand, "--quiet", "--release"])
        .args(["--target", board.target])
        .arg("--manifest-path")
        .arg(manifest(board.folder))
        .arg("--target-dir")
        .arg(target_folder(board))
        .current_dir(paths::root());
    command
}

fn cargo_build(route: Route, board: &Board) -> Command {
    cargo(route, board, "build")
}

/// Boards whose firmware differs in its features alone do not overwrite each
/// other's.
fn target_folder(board: &Board) -> PathBuf {
    let folder = paths::target_crate(board.folder).join("target");
    match board.features {
        Some(_) => folder.join(board.name),
        None => folder,
    }
}

fn built(board: &Board, binary: &str) -> PathBuf {
    let folder = target_folder(board).join(board.target);
    let name = match board.machine {
        Machine::Qemu(_) | Machine::Mgba => binary.to_owned(),
        Machine::Node(_) => format!("{binary}.wasm"),
    };
    folder.join("release").join(Path::new(&name))
}
