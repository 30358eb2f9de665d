//! Runs a firmware for the RP2040 in rp2040js, with a model of its panel.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::Duration;

use serde::Deserialize;

use crate::device::Device;
use crate::problem::{Problem, Result};
use crate::{child, debian, measure, paths};

/// A run that takes longer hangs.
const LIMIT: Duration = Duration::from_secs(300);
/// What names the emulator's version.
const PACKAGE: [&str; 2] = ["package.json", "package-lock.json"];

/// A frame that a panel has shown.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Shown {
    /// What the firmware says about it.
    pub report: Report,
    /// What the bus says.
    pub bus: Bus,
    /// The picture, [`Device::picture_bytes`].
    pub pixels: Vec<u8>,
    /// How deep the stack went for the first frame, in bytes.
    pub stack: u64,
}

/// A line of the firmware: `targets/demo` has what it means.
#[derive(Clone, Copy, Debug, Default, Deserialize, PartialEq, Eq)]
pub struct Report {
    /// The frame of the scene's animation.
    pub frame: u32,
    /// What buttons have turned the object, in 65536ths of a full turn.
    pub turn: u32,
    /// The processor's cycles of drawing.
    pub drawing: u64,
    /// The processor's cycles of waiting for the bus.
    pub waiting: u64,
}

/// A line of the emulator.
#[derive(Clone, Copy, Debug, Default, Deserialize, PartialEq, Eq)]
pub struct Bus {
    /// Bytes that the panel got for the frame.
    pub bytes: u64,
    /// The processor's cycles that the bus took for them.
    pub sending: u64,
}

/// Runs a firmware until its panel has shown so many frames. `presses` are buttons as the
/// emulator's script takes them.
pub fn run(device: &Device, elf: &Path, frames: u32, presses: &[&str]) -> Result<Vec<Shown>> {
    let modules = provide()?;
    let raw = paths::work("pictures")?.join(format!("{}.raw", device.name));
    let mut command = Command::new("node");
    command
        .arg(paths::target_crate(device.folder).join("emulator/run.mjs"))
        .arg(modules)
        .arg(elf)
        .args([device.panel, &frames.to_string()])
        .arg(&raw)
        .args(presses);
    let finished = child::bounded(&mut command, LIMIT)?;
    let fail = |reason: &str| format!("{}: {}", device.name, reason.trim());
    if !finished.success {
        return Err(fail(&format!("{}{}", finished.stdout, finished.stderr)).into());
    }
    let pictures = fs::read(&raw).map_err(|error| fail(&error.to_string()))?;
    joined(device, &finished.stdout, &pictures, frames).map_err(|error| fail(&error).into())
}

/// Lines of each kind and pictures are in the order of frames.
fn joined(
    device: &Device,
    text: &str,
    pictures: &[u8],
    frames: u32,
) -> std::result::Result<Vec<Shown>, String> {
    let reports: Vec<Report> = lines(text, "{\"frame\"")?;
    let buses: Vec<Bus> = lines(text, "{\"shown\"")?;
    let stack = measure::stack_bytes(text).ok_or("nothing is said of the stack")?;
    let pictures = pictures.chunks_exact(device.picture_bytes());
    let all = reports.into_iter().zip(buses).zip(pictures);
    let shown: Vec<_> = all
        .take(frames as usize)
        .map(|((report, bus), pixels)| Shown {
            report,
            bus,
            pixels: pixels.to_vec(),
            stack,
        })
        .collect();
    if shown.len() != frames as usize {
        return Err(format!("{} frames, not {frames}: {text}", shown.len()));
    }
    Ok(shown)
}

fn lines<T: for<'a> Deserialize<'a>>(
    text: &str,
    beginning: &str,
) -> std::result::Result<Vec<T>, String> {
    let lines = text.lines().filter(|line| line.starts_with(beginning));
    lines
        .map(|line| serde_json::from_str(line).map_err(|error| format!("{line}: {error}")))
        .collect()
}

/// Installs the emulator, in the version that the repository names, unless it is there;
/// gives the folder whose `node_modules` has it.
fn provide() -> Result<PathBuf> {
    let node = ["node", "npm"];
    let there = || node.iter().all(|program| debian::which(program).is_some());
    if !there() && debian::can_install() {
        debian::install(&["nodejs", "npm"])?;
    }
    if !there() {
        return Err(Problem::Missing(
            "no node and npm: `apt-get install nodejs npm` would bring them on Debian".into(),
        ));
    }
    let source = paths::target_crate("rp2040").join("emulator");
    let folder = paths::work("rp2040js")?;
    let fail = |error: std::io::Error| format!("{}: {error}", folder.display());
    let mut same = folder.join("node_modules/rp2040js/package.json").exists();
    for file in PACKAGE {
        let wanted = fs::read(source.join(file)).map_err(fail)?;
        let to = folder.join(file);
        if !fs::read(&to).is_ok_and(|old| old == wanted) {
            same = false;
            fixel_output::write(&to, &wanted)?;
        }
    }
    if !same {
        let mut command = Command::new("npm");
        command
            .args(["ci", "--no-audit", "--no-fund"])
            .current_dir(&folder);
        eprintln!("$ {}", child::shown(&command));
        child::visibly(&mut command)?;
    }
    Ok(folder)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::device::DEVICES;

    #[test]
    fn lines_and_pictures_belong_together() {
        let device = &DEVICES[2];
        let report = "{\"frame\":3,\"turn\":9,\"triangles\":4,\"drawing\":5,\"waiting\":6}\n";
        let text = format!("{{\"shown\":0,\"bytes\":7,\"sending\":8}}\n{report}{{\"stack\":10}}\n");
        let picture = vec![1; device.picture_bytes()];
        let shown = joined(device, &text, &picture, 1).unwrap_or_default();
        let expected = Shown {
            report: Report {
                frame: 3,
                turn: 9,
                drawing: 5,
                waiting: 6,
            },
            bus: Bus {
                bytes: 7,
                sending: 8,
            },
            pixels: picture.clone(),
            stack: 10,
        };
        assert_eq!(shown, [expected]);
        assert!(joined(device, report, &picture, 1).is_err());
        assert!(joined(device, &text, &[], 1).is_err());
    }
}
