//! Cartridges for the Game Boy Advance.

use std::ffi::OsStr;
use std::fs;
use std::path::Path;

use crate::problem::Result;
use crate::scene::Baked;
use crate::{elf, libretro, paths};

/// Where a cartridge begins in memory.
const ROM: u32 = 0x0800_0000;
/// Where the measuring firmware looks for a scene, counted from there, and for what to
/// do, right before it.
const SCENE: usize = 4 << 20;

/// Renders a scene with the measuring firmware; `arguments` are the first frame, one
/// past the last, and a band's rows. Gives what the firmware prints.
pub fn render(program: &Path, scene: &Baked, arguments: &[String]) -> Result<String> {
    let player = libretro::provide()?;
    let blob = fs::read(&scene.path);
    let blob = blob.map_err(|error| format!("{}: {error}", scene.path.display()))?;
    let mut task = vec![blob.len() as u32];
    for argument in arguments {
        let number = argument.parse();
        task.push(number.map_err(|error| format!("{argument}: {error}"))?);
    }
    let task: Vec<u8> = task.iter().flat_map(|word| word.to_le_bytes()).collect();
    let mut rom = elf::flat(program, ROM)?;
    if rom.len() > SCENE - task.len() {
        return Err("the program reaches into the place kept for its scene".into());
    }
    rom.resize(SCENE - task.len(), 0);
    rom.extend(task);
    rom.extend(blob);
    let name = scene.path.file_stem().unwrap_or_default().to_string_lossy();
    let name = format!("measure-{name}-{}.gba", arguments.join("-"));
    let path = paths::work("firmware")?.join(name);
    write(&path, &rom)?;
    let text = player.run(&path, &[OsStr::new("end")]);
    // One each of scenes, band heights and frames would be a lot.
    let _ = fs::remove_file(&path);
    text
}

fn write(path: &Path, bytes: &[u8]) -> Result<()> {
    fs::write(path, bytes).map_err(|error| format!("{}: {error}", path.display()).into())
}
