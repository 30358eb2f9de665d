//! E-paper of 296x128 with an SSD1680: only what changed is sent, and only that changes.
#![no_std]
#![no_main]

use cortex_m::singleton;
use embedded_hal::spi::MODE_0;
use fixel::display::{Changed, Ordered, Packed, Packing};
use fixel_demo::Memory;
use fixel_rp2040::board::{Board, Busy};
use fixel_rp2040::ssd1680::{PAGE, RATE, SIZE, Ssd1680};
use fixel_rp2040::{Waited, halt, run};
use fixel_runner::scene;

const BAND_ROWS: usize = 64;
const PIXELS: usize = SIZE.0 as usize * BAND_ROWS;
/// Columns that are sent or not as one.
const TILE: usize = 37;
const SUMS: usize = Changed::<Ssd1680<'static, Busy>>::sums(PAGE, TILE, 8, SIZE.1);

#[rp2040_hal::entry]
fn main() -> ! {
    let Some(mut board) = Board::start(RATE, MODE_0) else {
        halt()
    };
    let (Some(memory), Some(shown)) = (
        singleton!(MEMORY: Memory<PIXELS> = Memory::new()),
        singleton!(SHOWN: [[u8; PAGE]; 16] = [[0; PAGE]; 16]),
    ) else {
        halt()
    };
    let waited = Waited::new();
    let panel = Ssd1680::new(
        board.link,
        &mut board.reset,
        board.busy,
        board.timer,
        shown,
        &waited,
    );
    let (mut sums, mut page) = ([None; SUMS], [0; PAGE]);
    let changed = Changed::new(panel, PAGE, TILE, 8, &mut sums);
    let mut display = Packed::new(
        Packing::Pages,
        SIZE.1,
        Ordered::BLUE_NOISE,
        &mut page,
        changed,
    );
    run(
        scene!(),
        SIZE,
        &mut board.console,
        memory,
        &waited,
        &mut display,
        |display| {
            let changed = display.rows();
            changed.panel().update();
            if changed.panel().is_whole_next() {
                changed.forget();
            }
        },
    )
}
