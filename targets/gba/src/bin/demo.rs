//! A scene that the keys turn.
#![no_std]
#![no_main]

use fixel_demo::{Cost, Demo, DemoError, Memory};
use fixel_gba::cycles::CycleCounter;
use fixel_gba::display::{Mode4, SIZE};
use fixel_gba::{keys, report};
use fixel_runner::scene;

/// Pixels of a band, of 16 rows.
const PIXELS: usize = SIZE.0 as usize * 16;

static mut MEMORY: Memory<PIXELS> = Memory::new();

#[unsafe(no_mangle)]
extern "C" fn main() -> ! {
    report::begin();
    let memory = &raw mut MEMORY;
    // SAFETY: the only use of MEMORY, and `main` runs once.
    let memory = unsafe { &mut *memory };
    let mut panel = Mode4::new();
    let cycles = CycleCounter::start();
    let mut demo = match Demo::new(scene!(), SIZE) {
        Ok(demo) => demo,
        Err(error) => stop(error),
    };
    loop {
        let start = cycles.now();
        if let Err(error) = demo.frame(keys::pressed(), memory, &mut panel) {
            stop(error);
        }
        let drawn = cycles.now();
        panel.flip();
        let end = cycles.now();
        let cost = Cost {
            whole: end.wrapping_sub(start),
            waiting: end.wrapping_sub(drawn),
        };
        demo.report(cost).end(report::shown);
    }
}

fn stop(error: DemoError<core::convert::Infallible>) -> ! {
    report::fail(error.message())
}
