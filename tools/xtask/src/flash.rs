//! Writes firmware to a real RP2040: as a UF2 file onto the drive that its boot ROM shows, or
//! by probe-rs and a debug probe.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use crate::firmware::Demo;
use crate::problem::Result;
use crate::{child, debian, uf2};

/// The drive has this file, which names the chip.
const INFO: &str = "INFO_UF2.TXT";
const CHIP: &str = "RPI-RP2";

/// Writes the UF2 file beside an ELF file; gives its path.
pub fn write_uf2(elf: &Path) -> Result<PathBuf> {
    let fail = |error: String| format!("{}: {error}", elf.display());
    let bytes = fs::read(elf).map_err(|error| fail(error.to_string()))?;
    let to = elf.with_extension("uf2");
    let uf2 = uf2::from_elf(&bytes).map_err(fail)?;
    fixel_output::write(&to, &uf2)?;
    Ok(to)
}

/// Writes a firmware to the board that is connected.
pub fn run(firmware: &Demo) -> Result<()> {
    let uf2 = write_uf2(&firmware.path)?;
    if let Some(drive) = mounts().into_iter().find(|folder| is_drive(folder)) {
        let to = drive.join("fixel.uf2");
        fs::copy(&uf2, &to).map_err(|error| format!("{}: {error}", to.display()))?;
        eprintln!(
            "{} is on {}: the board restarts",
            uf2.display(),
            drive.display()
        );
        return Ok(());
    }
    if debian::which("probe-rs").is_some() {
        let mut download = probe("download");
        child::visibly(download.arg(&firmware.path))?;
        return child::visibly(&mut probe("reset"));
    }
    Err(format!(
        "no RP2040 is connected: hold its BOOTSEL button while you plug it in, so that the \
         drive {CHIP} appears (or copy {} there yourself); with a debug probe, install probe-rs",
        uf2.display()
    )
    .into())
}

fn probe(subcommand: &str) -> Command {
    let mut command = Command::new("probe-rs");
    command.args([subcommand, "--chip", "RP2040"]);
    command
}

/// Where drives may be: what Linux says is mounted, macOS's volumes, Windows' letters.
fn mounts() -> Vec<PathBuf> {
    let mounted = fs::read_to_string("/proc/mounts").unwrap_or_default();
    let on_linux = mounted.lines().filter_map(mount_point);
    let on_mac = [PathBuf::from("/Volumes").join(CHIP)];
    let letters = ('D'..='Z').map(|letter| PathBuf::from(format!("{letter}:\\")));
    let on_windows = letters.filter(|_| cfg!(windows));
    on_linux.chain(on_mac).chain(on_windows).collect()
}

/// The folder in a line of `/proc/mounts`, where a space is written as a number.
fn mount_point(line: &str) -> Option<PathBuf> {
    let folder = line.split(' ').nth(1)?;
    Some(folder.replace("\\040", " ").into())
}

fn is_drive(folder: &Path) -> bool {
    fs::read_to_string(folder.join(INFO)).is_ok_and(|info| info.contains(CHIP))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_drive_is_known_by_its_file() {
        let folder = std::env::temp_dir().join(format!("fixel-drive-{}", std::process::id()));
        assert!(!is_drive(&folder));
        fs::create_dir_all(&folder).expect("a folder");
        fs::write(
            folder.join(INFO),
            "UF2 Bootloader v3.0\nBoard-ID: RPI-RP2\n",
        )
        .expect("a file");
        assert!(is_drive(&folder));
        fs::write(folder.join(INFO), "Board-ID: SAMD21\n").expect("a file");
        assert!(!is_drive(&folder));
        fs::remove_dir_all(&folder).expect("it is there");
    }

    #[test]
    fn spaces_in_mount_points() {
        let line = "/dev/sda1 /media/a\\040b/RPI-RP2 vfat rw 0 0";
        assert_eq!(mount_point(line), Some("/media/a b/RPI-RP2".into()));
        assert_eq!(mount_point(""), None);
    }
}
