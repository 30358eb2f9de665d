//! Boards that panels hang on: what memory they have, and how fast their bus is.

use serde_json::{Value, json};

/// A board, by its data sheet.
struct Board {
    name: &'static str,
    title: &'static str,
    chip: &'static str,
    ram_kb: u32,
    flash_kb: u32,
    /// The fastest clock of its serial bus in Hz; 0: its panel reads memory.
    bus_hz: u32,
}

const MHZ: u32 = 1_000_000;

const fn board(
    name: &'static str,
    [title, chip]: [&'static str; 2],
    [ram_kb, flash_kb]: [u32; 2],
    bus_hz: u32,
) -> Board {
    Board {
        name,
        title,
        chip,
        ram_kb,
        flash_kb,
        bus_hz,
    }
}

const BOARDS: [Board; 8] = [
    board(
        "rp2040",
        [
            "Raspberry Pi Pico",
            "RP2040: Cortex-M0+ at 125 MHz, SPI at 62.5 MHz",
        ],
        [264, 2048],
        62_500_000,
    ),
    board(
        "microbit",
        ["micro:bit", "nRF51822: Cortex-M0 at 16 MHz, SPI at 4 MHz"],
        [16, 256],
        4 * MHZ,
    ),
    board(
        "stm32f103c8",
        [
            "Blue Pill",
            "STM32F103C8: Cortex-M3 at 72 MHz, SPI at 18 MHz",
        ],
        [20, 64],
        18 * MHZ,
    ),
    board(
        "stm32l476",
        ["STM32L476", "Cortex-M4F at 80 MHz, SPI at 40 MHz"],
        [128, 1024],
        40 * MHZ,
    ),
    board(
        "stm32f405",
        ["STM32F405", "Cortex-M4F at 168 MHz, SPI at 42 MHz"],
        [192, 1024],
        42 * MHZ,
    ),
    board(
        "nrf52840",
        ["nRF52840", "Cortex-M4F at 64 MHz, SPI at 32 MHz"],
        [256, 1024],
        32 * MHZ,
    ),
    board(
        "esp32c3",
        ["ESP32-C3", "RISC-V (RV32IMC) at 160 MHz, SPI at 80 MHz"],
        [400, 4096],
        80 * MHZ,
    ),
    board(
        GBA,
        ["Game Boy Advance", "ARM7TDMI at 16.8 MHz"],
        [288, 32768],
        0,
    ),
];

/// The one whose panel hangs on nothing else.
pub(crate) const GBA: &str = "gba";

/// All of them, for the catalogue.
pub(crate) fn boards() -> Vec<Value> {
    let entry = |board: &Board| {
        json!({
            "name": board.name,
            "title": board.title,
            "chip": board.chip,
            "ram_bytes": board.ram_kb * 1024,
            "flash_bytes": board.flash_kb * 1024,
            "bus_hz": board.bus_hz,
        })
    };
    BOARDS.iter().map(entry).collect()
}
