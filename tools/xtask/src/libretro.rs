//! Runs firmware in an emulator that is a libretro core: mGBA. `targets/libretro` is
//! its front end, which takes steps and writes pictures.

use std::ffi::{OsStr, OsString};
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::Mutex;
use std::time::Duration;

use crate::problem::{Problem, Result};
use crate::{child, debian, firmware, paths};

/// Debian's package of the core, and the library that it needs. They are unpacked, not
/// installed: the core's package asks for a front end with a window.
const PACKAGES: [&str; 2] = ["libretro-mgba", "libinih1"];
const CORE: &str = "mgba_libretro.so";
/// A run that takes longer hangs.
const LIMIT: Duration = Duration::from_secs(300);

/// What runs cartridges.
#[derive(Clone, Debug)]
pub struct Player {
    /// The front end.
    program: PathBuf,
    core: PathBuf,
    /// The folder of the core's libraries, if they are not the system's.
    libraries: Option<PathBuf>,
}

/// Finds the core or unpacks Debian's package of it, and builds the front end.
pub fn provide() -> Result<Player> {
    static KNOWN: Mutex<Option<Player>> = Mutex::new(None);
    let mut known = KNOWN.lock().map_err(|error| error.to_string())?;
    if let Some(player) = known.as_ref() {
        return Ok(player.clone());
    }
    let unpacked = paths::work("mgba")?;
    let (core, libraries) = match (find(Path::new("/")), find(&unpacked)) {
        (Some(core), _) => (core, None),
        (None, Some(core)) => (core, libraries(&unpacked)),
        (None, None) => {
            unpack(&unpacked)?;
            let core = find(&unpacked).ok_or(format!("{} has no {CORE}", PACKAGES[0]))?;
            (core, libraries(&unpacked))
        }
    };
    let player = Player {
        program: firmware::host_program("libretro", "libretro", "release", None)?,
        core,
        libraries,
    };
    *known = Some(player.clone());
    Ok(player)
}

/// The core below a file system's root.
fn find(root: &Path) -> Option<PathBuf> {
    let folder = libraries(root)?.join("libretro");
    Some(folder.join(CORE)).filter(|core| core.is_file())
}

/// The folder of the processor's libraries: `usr/lib/x86_64-linux-gnu` or the like.
fn libraries(root: &Path) -> Option<PathBuf> {
    let machine = format!("{}-linux-gnu", std::env::consts::ARCH);
    Some(root.join("usr/lib").join(machine)).filter(|folder| folder.is_dir())
}

fn unpack(to: &Path) -> Result<()> {
    let missing = || {
        Problem::Missing(format!(
            "no {CORE}: on Debian `apt-get download {0}` in {1}, and `dpkg -x` of both there, \
             would bring it",
            PACKAGES.join(" "),
            to.display()
        ))
    };
    let there = ["apt-get", "dpkg"].map(debian::which);
    if there.iter().any(Option::is_none) {
        return Err(missing());
    }
    if debian::download(&PACKAGES, to).is_err() {
        return Err(missing());
    }
    for entry in std::fs::read_dir(to).map_err(|error| format!("{}: {error}", to.display()))? {
        let file = entry.map_err(|error| error.to_string())?.path();
        if file.extension() == Some(OsStr::new("deb")) {
            child::visibly(Command::new("dpkg").arg("-x").arg(&file).arg(to))?;
        }
    }
    Ok(())
}

impl Player {
    /// Runs a cartridge through the front end's steps; gives its standard output.
    pub fn run(&self, rom: &Path, steps: &[OsString]) -> Result<String> {
        let mut command = Command::new(&self.program);
        command.arg(&self.core).arg(rom).args(steps);
        if let Some(libraries) = &self.libraries {
            command.env("LD_LIBRARY_PATH", libraries);
        }
        let finished = child::bounded(&mut command, LIMIT)?;
        if finished.success {
            return Ok(finished.stdout);
        }
        let reason = format!("{} {}", finished.stdout.trim(), finished.stderr.trim());
        Err(format!("{}: {}", rom.display(), reason.trim()).into())
    }
}
