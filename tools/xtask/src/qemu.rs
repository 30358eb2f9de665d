//! Runs firmware in QEMU and reads what it prints.

use std::path::Path;
use std::process::Command;
use std::time::Duration;

use crate::board::Qemu;
use crate::problem::{Problem, Result};
use crate::{child, debian};

/// A run that takes longer hangs.
const LIMIT: Duration = Duration::from_secs(300);

/// Finds or installs a board's emulator.
pub fn provide(machine: &Qemu) -> Result<()> {
    if debian::which(machine.program).is_some() {
        return Ok(());
    }
    if debian::can_install() {
        match debian::install(&[machine.package]) {
            Ok(()) if debian::which(machine.program).is_some() => return Ok(()),
            Ok(()) => eprintln!("{} is still not there", machine.program),
            Err(error) => eprintln!("{error}"),
        }
    }
    Err(Problem::Missing(format!(
        "no {}: `apt-get install {}` would bring it on Debian",
        machine.program, machine.package
    )))
}

/// Runs a firmware with semihosting arguments, and a scene in memory if one is
/// given. Gives its standard output; fails if the firmware says so.
pub fn run(
    name: &str,
    machine: &Qemu,
    elf: &Path,
    scene: Option<&Path>,
    arguments: &[String],
) -> Result<String> {
    let mut semihosting = String::from("enable=on,target=native");
    for argument in arguments {
        // A comma separates options; doubled it stands for itself.
        semihosting.push_str(",arg=");
        semihosting.push_str(&argument.replace(',', ",,"));
    }
    let mut command = Command::new(machine.program);
    command
        .args(machine.arguments)
        .args(["-display", "none", "-serial", "null", "-monitor", "none"])
        .args(["-semihosting-config", &semihosting])
        .arg("-kernel")
        .arg(elf);
    if let Some(scene) = scene {
        let file = scene.to_string_lossy().replace(',', ",,");
        let address = machine.scene_address;
        command
            .arg("-device")
            .arg(format!("loader,file={file},addr={address:#x},force-raw=on"));
    }
    let finished = child::bounded(&mut command, LIMIT)?;
    if finished.success {
        return Ok(finished.stdout);
    }
    Err(format!(
        "{name} firmware failed: {}",
        reason(&finished.stdout, &finished.stderr)
    )
    .into())
}

/// The firmware's own word, which is its last line, and the emulator's first,
/// after which come registers.
fn reason(stdout: &str, stderr: &str) -> String {
    let own = stdout.trim().lines().last().unwrap_or_default();
    let emulator = stderr.trim().lines().next().unwrap_or_default();
    format!("{own} {emulator}").trim().to_owned()
}

#[cfg(test)]
mod tests {
    #[test]
    fn a_reason_is_one_line() {
        let stdout = "{\"frame\":0}\n{\"error\":\"panic\"}\n";
        let reason = super::reason(stdout, "fatal: lockup\n\nR00=0\n");
        assert_eq!(reason, "{\"error\":\"panic\"} fatal: lockup");
    }
}
