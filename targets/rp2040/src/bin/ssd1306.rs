//! A black-and-white OLED of 128x64 with an SSD1306.
#![no_std]
#![no_main]

use cortex_m::singleton;
use embedded_hal::spi::MODE_0;
use fixel::display::{Ordered, Packed, Packing};
use fixel_demo::Memory;
use fixel_rp2040::board::Board;
use fixel_rp2040::ssd1306::{RATE, SIZE, Ssd1306};
use fixel_rp2040::{Waited, halt, run};
use fixel_runner::scene;

/// The whole screen is one band.
const PIXELS: usize = SIZE.0 as usize * SIZE.1 as usize;
const PAGE: usize = Packing::Pages.bytes(SIZE.0);

#[rp2040_hal::entry]
fn main() -> ! {
    let Some(mut board) = Board::start(RATE, MODE_0) else {
        halt()
    };
    let Some(memory) = singleton!(MEMORY: Memory<PIXELS> = Memory::new()) else {
        halt()
    };
    let waited = Waited::new();
    let panel = Ssd1306::new(board.link, &mut board.reset, &mut board.timer, &waited);
    let mut page = [0; PAGE];
    let mut display = Packed::new(
        Packing::Pages,
        SIZE.1,
        Ordered::BLUE_NOISE,
        &mut page,
        panel,
    );
    run(
        scene!(),
        SIZE,
        &mut board.console,
        memory,
        &waited,
        &mut display,
        |_| {},
    )
}
