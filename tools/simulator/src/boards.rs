//! Boards that panels hang on: those that there are estimates for, whatever panel these
//! name.

use fixel_estimate::{BOARDS, Board, Estimate, Layout, Model};
use fixel_scene::Panel;
use serde_json::{Value, json};

/// Name of an estimate's board, what people call it, and its processor.
const OFFERED: [[&str; 3]; 8] = [
    ["rp2040-st7789", "Raspberry Pi Pico", "RP2040, Cortex-M0+"],
    ["microbit", "micro:bit", "nRF51822, Cortex-M0"],
    ["stm32f103c8", "Blue Pill", "STM32F103C8, Cortex-M3"],
    ["stm32l4", "STM32L476", "Cortex-M4F"],
    ["stm32f405", "STM32F405", "Cortex-M4F"],
    ["nrf52840", "nRF52840", "Cortex-M4F"],
    ["esp32c3", "ESP32-C3", "RISC-V"],
    [GBA, "Game Boy Advance", "ARM7TDMI"],
];

/// The one whose panel hangs on nothing else.
pub(crate) const GBA: &str = "gba";

/// All of them, for the catalogue.
pub(crate) fn boards() -> Vec<Value> {
    let entry = |[name, title, core]: &[&str; 3]| {
        let board = BOARDS.iter().find(|board| board.name == *name)?;
        let bus_hz = board.panel.bits_a_second;
        let mhz = |hz: u32| (f64::from(hz) / 1e5).round() / 10.0;
        let bus = if bus_hz > 0 {
            format!(", SPI at {} MHz", mhz(bus_hz))
        } else {
            String::new()
        };
        Some(json!({
            "name": name,
            "title": title,
            "chip": format!("{core} at {} MHz{bus}", mhz(board.clock_hz)),
            "ram_bytes": board.ram_bytes,
            "flash_bytes": board.flash_bytes,
            "bus_hz": bus_hz,
        }))
    };
    OFFERED.iter().filter_map(entry).collect()
}

/// What a frame of a scene takes on a board with a panel, of its number and in bands of so
/// many rows. Nothing of a scene that is baked for rays.
pub(crate) fn estimate(
    scene: &fixel::Scene<'_>,
    scene_bytes: usize,
    panel: &Panel,
    name: &str,
    (number, band_rows): (u32, u16),
) -> Result<Value, String> {
    let board = Board::find(name)?.showing(panel);
    let model = Model::fitted().map_err(|error| error.to_string())?;
    let pose = scene.pose(number);
    // As the snippet has it.
    let layout = Layout {
        band_rows,
        ..Layout::ROOMY
    };
    let asked = (&pose, layout);
    let estimate = Estimate::new(&model, &board, scene, asked, scene_bytes as u64);
    let Some(e) = estimate.filter(|_| !scene.has_rays()) else {
        return Ok(Value::Null);
    };
    Ok(json!({
        "code_bytes": e.code_bytes,
        "flash_bytes": e.flash_bytes(),
        "ram_bytes": e.ram_bytes(),
        "band_bytes": e.ram.band,
        "bus_bytes": e.ram.bus,
        "scratch_bytes": e.ram.scratch,
        "stack_bytes": e.ram.stack,
        "instructions": e.instructions,
        "drawing_s": e.drawing_s,
        "frames_a_second": e.frames_a_second.min(1.0 / panel.frame_seconds()),
    }))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn all_that_is_offered_is_there() {
        assert_eq!(boards().len(), OFFERED.len());
    }
}
