//! Packages from Debian, when we are root on such a machine: a clean
//! continuous-integration container is one.

use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::Mutex;

use crate::child;

/// Whether packages can be installed here without asking anyone.
pub fn can_install() -> bool {
    let root = child::output(Command::new("id").arg("-u"));
    root.is_some_and(|id| id.trim() == "0")
        && Path::new("/etc/debian_version").exists()
        && which("apt-get").is_some()
}

/// Installs packages and shows apt's output.
pub fn install(packages: &[&str]) -> Result<(), String> {
    /// One apt runs at a time.
    static ALONE: Mutex<()> = Mutex::new(());
    let _alone = ALONE.lock().map_err(|error| error.to_string())?;
    update()?;
    let mut arguments = vec!["install", "-q", "-y", "--no-install-recommends"];
    arguments.extend(packages);
    apt(&arguments)
}

/// Fetches package lists, once.
fn update() -> Result<(), String> {
    static UPDATED: Mutex<bool> = Mutex::new(false);
    let mut updated = UPDATED.lock().map_err(|error| error.to_string())?;
    if !*updated {
        apt(&["update", "-q"])?;
        *updated = true;
    }
    Ok(())
}

fn apt(arguments: &[&str]) -> Result<(), String> {
    let mut command = Command::new("apt-get");
    command
        .args(arguments)
        .env("DEBIAN_FRONTEND", "noninteractive");
    eprintln!("$ {}", child::shown(&command));
    child::visibly(&mut command).map_err(|problem| problem.to_string())
}

/// Fetches packages' files into a folder, without installing anything. Needs no rights
/// but to fetch package lists, which is done as root alone.
pub fn download(packages: &[&str], to: &Path) -> Result<(), String> {
    let fetch = || {
        let mut command = Command::new("apt-get");
        command
            .args(["download", "-q"])
            .args(packages)
            .current_dir(to);
        eprintln!("$ {}", child::shown(&command));
        child::visibly(&mut command).map_err(|problem| problem.to_string())
    };
    let fetched = fetch();
    if fetched.is_err() && can_install() {
        update()?;
        return fetch();
    }
    fetched
}

/// The full path of a program, if it is on the search path.
pub fn which(program: &str) -> Option<PathBuf> {
    let path = std::env::var_os("PATH")?;
    std::env::split_paths(&path)
        .map(|folder| folder.join(program))
        .find(|file| file.is_file())
}
