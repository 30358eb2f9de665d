//! Cartridges for the Game Boy Advance.

use std::ffi::OsString;
use std::fs;
use std::path::{Path, PathBuf};

use fixel::math::Angle;
use fixel::palette::bgr555;
use serde::Deserialize;

use crate::problem::Result;
use crate::scene::Baked;
use crate::{elf, libretro, paths, picture};

/// The panel's columns and rows.
const WIDTH: u16 = 240;
const HEIGHT: u16 = 160;
/// Where its two pages are in memory, and a page's bytes.
const PAGES: [&str; 2] = ["0x06000000", "0x0600A000"];
const PAGE_BYTES: &str = "38400";

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
    fixel_output::write(&path, &rom)?;
    let text = player.run(&path, &["end".into()]);
    // One each of scenes, band heights and frames would be a lot.
    let _ = fs::remove_file(&path);
    text
}

/// The smallest cartridge: one that fits the console's RAM (256 KB) may be taken for a
/// program that came over the link cable, by its code's looks, and is then run from there.
const LEAST: usize = 512 << 10;

/// Writes the cartridge of a linked program beside it, as large as chips are, powers of
/// two; gives its path.
pub fn cartridge(program: &Path) -> Result<PathBuf> {
    let path = program.with_extension("gba");
    let mut rom = elf::flat(program, ROM)?;
    rom.resize(rom.len().next_power_of_two().max(LEAST), 0);
    fixel_output::write(&path, &rom)?;
    Ok(path)
}

/// What the emulated panel showed of a demo, and what the demo said about it.
pub struct Shown {
    /// The frame of the scene's animation.
    pub frame: u32,
    /// What the keys had turned the object, in 65536ths of a full turn.
    pub turn: u32,
    /// The processor's cycles for drawing it, wait states included.
    pub cycles: u32,
    /// The page of video memory that is shown: a palette index a pixel.
    pub indices: Vec<u8>,
    /// The panel's pixels.
    pub colours: Vec<[u8; 3]>,
}

/// Plays a demo: through `pictures` pictures, the keys named held from the picture of
/// that number on. Shows the last one.
pub fn play(rom: &Path, pictures: u32, (keys, from): (&str, u32)) -> Result<Shown> {
    let player = libretro::provide()?;
    let name = rom.file_stem().unwrap_or_default().to_string_lossy();
    let file = |kind| paths::work("pictures").map(|folder| folder.join(format!("{name}.{kind}")));
    let (screen, page) = (file("rgb")?, file("index")?);
    let address = if pictures % 2 == 1 {
        PAGES[0]
    } else {
        PAGES[1]
    };
    let mut steps: Vec<OsString> = Vec::new();
    if from > 1 {
        steps.extend(["pictures".into(), (from - 1).to_string().into()]);
    }
    steps.extend(["hold".into(), keys.into()]);
    steps.extend(["pictures".into(), pictures.to_string().into()]);
    // The page was turned to when the last frame of the panel ended.
    steps.extend([
        "frames".into(),
        "1".into(),
        "screen".into(),
        screen.clone().into(),
    ]);
    steps.extend([
        "memory".into(),
        address.into(),
        PAGE_BYTES.into(),
        page.clone().into(),
    ]);
    let text = player.run(rom, &steps)?;
    let read = |path: &Path| fs::read(path).map_err(|error| format!("{}: {error}", path.display()));
    let line = text.lines().last().unwrap_or_default();
    let line: Line = serde_json::from_str(line).map_err(|error| format!("{error}: {text}"))?;
    let colours = read(&screen)?;
    Ok(Shown {
        frame: line.frame,
        turn: line.turn,
        cycles: line.drawing,
        indices: read(&page)?,
        colours: colours.as_chunks().0.to_vec(),
    })
}

/// A demo's line about a picture.
#[derive(Deserialize)]
struct Line {
    frame: u32,
    turn: u32,
    drawing: u32,
}

/// Holds what the panel shows of a scene against what this machine draws of it: indices
/// byte for byte, and colours as 5 bits a channel, each rounded to nearest.
pub fn check(baked: &Baked, shown: &Shown) -> Result<()> {
    let expected = expected(baked, shown.frame, shown.turn)?;
    let differ = differing(&expected.indices, &shown.indices);
    if differ > 0 {
        return Err(format!("{differ} palette indices differ from this machine's").into());
    }
    let differ = differing(&expected.colours, &shown.colours);
    if differ > 0 {
        return Err(format!("{differ} pixels have another colour than their index's").into());
    }
    Ok(())
}

/// Holds what the panel shows against this machine's picture, and fails unless the keys
/// have changed it.
pub fn check_turned(baked: &Baked, shown: &Shown) -> Result<()> {
    check(baked, shown)?;
    let unturned = expected(baked, shown.frame, 0)?;
    if shown.turn == 0 || differing(&unturned.indices, &shown.indices) == 0 {
        return Err("the keys did not turn the object".into());
    }
    Ok(())
}

/// What is to be seen: indices and colours.
struct Expected {
    indices: Vec<u8>,
    colours: Vec<[u8; 3]>,
}

fn expected(baked: &Baked, frame: u32, turn: u32) -> Result<Expected> {
    let blob = fs::read(&baked.path).map_err(|error| error.to_string())?;
    let blob = fixel_bake::Baked::from_bytes(&blob).map_err(|error| error.to_string())?;
    let scene = blob.scene().map_err(|error| error.to_string())?;
    let options = fixel_host::Options {
        width: WIDTH,
        height: HEIGHT,
        frame,
        band_rows: None,
        camera: None,
    };
    let planes = fixel_host::render_turned(&scene, &options, Angle::from_bits(turn << 16));
    let pose = scene.pose(frame);
    let palette = fixel::render::palette(&scene, &pose);
    let colour = |index: &u8| {
        let bits = bgr555(palette.rgb888(*index));
        [0, 5, 10].map(|shift| ((u32::from(bits >> shift & 31) * 255 + 15) / 31) as u8)
    };
    Ok(Expected {
        colours: planes.index.iter().map(colour).collect(),
        indices: planes.index,
    })
}

/// How many differ, or are missing.
fn differing<T: PartialEq>(one: &[T], other: &[T]) -> usize {
    let pairs = one.iter().zip(other);
    pairs.filter(|(a, b)| a != b).count() + one.len().abs_diff(other.len())
}

/// Writes the panel's picture as PNG.
pub fn write_png(to: &Path, shown: &Shown) -> Result<()> {
    picture::write_png(
        to,
        WIDTH.into(),
        HEIGHT.into(),
        shown.colours.as_flattened(),
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene;

    fn seen(turn: u32) -> Result<(Baked, Shown)> {
        let baked = scene::bake("teapot")?;
        let Expected { indices, colours } = expected(&baked, 0, turn)?;
        let shown = Shown {
            frame: 0,
            turn,
            cycles: 0,
            indices,
            colours,
        };
        Ok((baked, shown))
    }

    #[test]
    fn one_wrong_pixel_is_found() {
        let (baked, mut shown) = seen(4096).expect("the scene is there");
        assert!(check_turned(&baked, &shown).is_ok());
        shown.colours[70 * 240 + 120][0] ^= 8;
        assert!(check(&baked, &shown).is_err());
        let (_, mut shown) = seen(4096).expect("the scene is there");
        shown.indices[70 * 240 + 120] ^= 1;
        assert!(check(&baked, &shown).is_err());
        shown.indices.pop();
        assert!(check(&baked, &shown).is_err());
    }

    #[test]
    fn keys_that_do_nothing_are_found() {
        let (baked, shown) = seen(0).expect("the scene is there");
        assert!(check(&baked, &shown).is_ok());
        assert!(check_turned(&baked, &shown).is_err());
    }
}
