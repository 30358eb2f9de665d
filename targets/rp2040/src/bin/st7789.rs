//! A colour panel with an ST7789, 320x240 or 240x240: one band is sent by DMA while the next
//! is drawn.
#![no_std]
#![no_main]

use cortex_m::singleton;
use embedded_hal::digital::OutputPin;
use embedded_hal::spi::MODE_3;
use fixel::display::DoubleBuffered;
use fixel_demo::Memory;
use fixel_rp2040::board::Board;
use fixel_rp2040::st7789::{RATE, St7789};
use fixel_rp2040::{Waited, halt, run};
use fixel_runner::scene;

const SIZE: (u16, u16) = if cfg!(feature = "square") {
    (240, 240)
} else {
    (320, 240)
};
const BAND_ROWS: usize = 60;
const PIXELS: usize = SIZE.0 as usize * BAND_ROWS;

#[rp2040_hal::entry]
fn main() -> ! {
    // Words follow each other without a gap in this mode alone.
    let Some(mut board) = Board::start(RATE, MODE_3) else {
        halt()
    };
    let (Some(memory), Some(first), Some(second)) = (
        singleton!(MEMORY: Memory<PIXELS> = Memory::new()),
        singleton!(FIRST: [u16; PIXELS] = [0; PIXELS]),
        singleton!(SECOND: [u16; PIXELS] = [0; PIXELS]),
    ) else {
        halt()
    };
    let waited = Waited::new();
    let panel = St7789::new(
        board.link,
        board.channel,
        &mut board.reset,
        &mut board.timer,
        SIZE,
        &waited,
    );
    let mut display = DoubleBuffered::new(panel, [&mut first[..], &mut second[..]]);
    let Ok(()) = board.light.set_high();
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
