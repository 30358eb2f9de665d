//! Runs a board's firmware in what the board says: QEMU, Node or mGBA.

use std::path::Path;
use std::process::Command;
use std::time::Duration;

use crate::board::{Board, Machine};
use crate::problem::{Problem, Result};
use crate::scene::Baked;
use crate::{child, debian, gba, libretro, paths, qemu};

/// A run in Node that takes longer hangs.
const LIMIT: Duration = Duration::from_secs(120);

/// Finds or installs a board's emulator.
pub fn provide(board: &Board) -> Result<()> {
    match &board.machine {
        Machine::Qemu(machine) => qemu::provide(machine),
        Machine::Node(_) => node(),
        Machine::Mgba => libretro::provide().map(|_| ()),
    }
}

fn node() -> Result<()> {
    let there = || debian::which("node").is_some();
    if there() || (debian::can_install() && debian::install(&["nodejs"]).is_ok() && there()) {
        return Ok(());
    }
    Err(Problem::Missing(
        "no node: `apt-get install nodejs` would bring it on Debian".into(),
    ))
}

/// Renders a scene with the measuring firmware; the arguments are those of the
/// host's program after the scene. Gives its standard output.
pub fn render(
    board: &Board,
    program: &Path,
    scene: &Baked,
    arguments: &[String],
) -> Result<String> {
    match &board.machine {
        Machine::Qemu(machine) => {
            let mut all = vec!["render".to_owned(), scene.bytes.to_string()];
            all.extend_from_slice(arguments);
            qemu::run(board.name, machine, program, Some(&scene.path), &all)
        }
        Machine::Node(script) => {
            let mut command = Command::new("node");
            command
                .arg(paths::target_crate(board.folder).join(script))
                .arg(program)
                .arg(&scene.path)
                .args(arguments);
            let finished = child::bounded(&mut command, LIMIT)?;
            if finished.success {
                return Ok(finished.stdout);
            }
            let reason = format!("{} {}", finished.stdout, finished.stderr);
            Err(format!("{}: {}", child::shown(&command), reason.trim()).into())
        }
        Machine::Mgba => gba::render(program, scene, arguments),
    }
}

/// Runs a firmware that needs no scene in memory, with its command line.
pub fn run(board: &Board, program: &Path, arguments: &[String]) -> Result<String> {
    match &board.machine {
        Machine::Qemu(machine) => qemu::run(board.name, machine, program, None, arguments),
        Machine::Node(_) | Machine::Mgba => {
            Err(format!("{} has no firmware but the measuring one", board.name).into())
        }
    }
}
