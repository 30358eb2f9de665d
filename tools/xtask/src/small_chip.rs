//! A whole demo in a small chip, scene, lists, bands, wire buffers and stack: the linker holds it
//! to the chip's memory, and its panel gets what this machine draws.

use serde_json::Value;

use crate::board::SMALL_CHIP;
use crate::firmware::HostProfile;
use crate::measure::Target;
use crate::problem::Result;
use crate::{emulator, firmware, footprint, scene};

/// Builds it, runs it, and compares its first frame.
pub fn run() -> Result<()> {
    let board = &SMALL_CHIP;
    let baked = scene::bake(board.scene)?;
    let demo = firmware::small_demo(board, &baked)?;
    footprint::promises(&demo.image)?;
    emulator::provide(board)?;
    let text = emulator::run(board, &demo.path, &[])?;
    let said = |name: &str| {
        let mut lines = text
            .lines()
            .filter_map(|line| serde_json::from_str(line).ok());
        let found: Option<Value> = lines.find(|line: &Value| line[name] != Value::Null);
        found.map(|line| line[name].clone()).unwrap_or_default()
    };
    let host = Target::Host(HostProfile::Release).prepare()?;
    let frames = host.frames(&baked, 0..1, 16, None)?;
    let wanted = frames.first().map(|frame| frame.panel.as_str());
    if said("panel").as_str() != wanted {
        let panel = said("panel");
        return Err(format!("the panel got {panel}, not {wanted:?}: {text}").into());
    }
    let image = &demo.image;
    eprintln!(
        "      {}: {} bytes of code, {} of the scene, {} of RAM, {} of stack",
        board.what,
        image.code_bytes(),
        image.scene_bytes,
        image.static_ram_bytes,
        said("stack")
    );
    Ok(())
}
