//! `firmware` and `run`: one board, one scene, one picture.

use std::fs;
use std::path::{Path, PathBuf};

use crate::board::{Board, Machine};
use crate::firmware::Parts;
use crate::measure::Target;
use crate::problem::Result;
use crate::{elf, firmware, gba, paths, scene};

/// Builds the demo firmware with a scene linked in; gives the file that goes to the
/// board: an ELF file, or a cartridge. WebAssembly takes its scene at run time.
pub fn build(board: &Board, scene_name: &str) -> Result<PathBuf> {
    if !board.is_elf() {
        return firmware::measuring(board);
    }
    let baked = scene::bake(scene_name)?;
    let demo = firmware::demo(board, &baked, Parts::All)?;
    say_size(board.name, &demo.image);
    match board.machine {
        Machine::Mgba => gba::cartridge(&demo.path),
        Machine::Qemu(_) | Machine::Node(_) => Ok(demo.path),
    }
}

/// Says what a firmware takes.
pub fn say_size(name: &str, image: &elf::Image) {
    eprintln!(
        "{name}: {} bytes of code, {} of scene, {} of static RAM",
        image.code_bytes(),
        image.scene_bytes,
        image.static_ram_bytes
    );
}

/// Renders one frame of a scene on a board in its emulator, and writes what a
/// panel would show as PNG.
pub fn run(
    board: &'static Board,
    scene_name: &str,
    frame: u32,
    band_rows: u32,
    to: &Path,
) -> Result<()> {
    if matches!(board.machine, Machine::Mgba) {
        let rom = build(board, scene_name)?;
        let shown = gba::play(&rom, frame + 1, ("none", 1))?;
        gba::write_png(to, &shown)?;
        let (cycles, to) = (shown.cycles, to.display());
        eprintln!("{}: frame {frame}, {cycles} cycles, {to}", board.name);
        return gba::check(&scene::bake(scene_name)?, &shown);
    }
    let ready = Target::Board(board).prepare()?;
    let baked = scene::bake(scene_name)?;
    let raw = paths::work("pictures")?.join(format!("{}.rgb565", board.name));
    let lines = ready.frames(&baked, frame..frame + 1, band_rows, Some(&raw))?;
    let line = lines.first().ok_or("no frame")?;
    let panel = fs::read(&raw).map_err(|error| format!("{}: {error}", raw.display()))?;
    write_png(to, line.width, line.height, &rgb888(&panel))?;
    let counted = match line.count {
        0 => "not counted".into(),
        count if board.is_elf() => format!("{count} instructions"),
        count => format!("{count} ns"),
    };
    eprintln!(
        "{}: frame {}, {} pixels covered, {counted}, {}",
        board.name,
        line.frame,
        line.covered,
        to.display()
    );
    Ok(())
}

/// Writes a picture of three bytes a pixel.
pub fn write_png(to: &Path, width: u32, height: u32, rgb: &[u8]) -> Result<()> {
    let fail = |error: &dyn std::fmt::Display| format!("{}: {error}", to.display());
    if rgb.len() as u64 != u64::from(width) * u64::from(height) * 3 {
        return Err(fail(&"the panel's bytes are not one frame").into());
    }
    let file = fixel_output::png_rgb(width, height, rgb.as_chunks().0);
    Ok(fixel_output::write(
        to,
        &file.map_err(|error| fail(&error))?,
    )?)
}

/// RGB565, high byte first, to 8 bits a channel, rounded to the nearest.
pub fn rgb888(panel: &[u8]) -> Vec<u8> {
    let channel = |value: u16, most: u16| {
        ((u32::from(value) * 255 + u32::from(most) / 2) / u32::from(most)) as u8
    };
    panel
        .chunks_exact(2)
        .flat_map(|bytes| {
            let pixel = u16::from_be_bytes([bytes[0], bytes[1]]);
            [
                channel(pixel >> 11, 31),
                channel(pixel >> 5 & 63, 63),
                channel(pixel & 31, 31),
            ]
        })
        .collect()
}

#[cfg(test)]
mod tests {
    #[test]
    fn panel_bytes_to_colours() {
        let panel = [0xFF, 0xFF, 0xF8, 0x00, 0x07, 0xE0, 0x00, 0x1F, 0x00, 0x00];
        let expected = [
            [255, 255, 255],
            [255, 0, 0],
            [0, 255, 0],
            [0, 0, 255],
            [0, 0, 0],
        ];
        assert_eq!(super::rgb888(&panel), expected.concat());
    }
}
