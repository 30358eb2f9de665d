//! Renders the scene that the emulator has loaded, and counts instructions:
//! `fixel_runner::firmware::main` says how it is told what to do.
#![no_std]
#![no_main]

use fixel_cortex_m::{InstructionCounter, SCENE_ADDRESS, SCENE_CAPACITY};
use fixel_runner::Memory;

/// The largest picture in one band; a part of it where RAM is short.
const PIXELS: usize = if cfg!(feature = "microbit") {
    128 * 4
} else {
    320 * 240
};

static mut MEMORY: Memory<PIXELS> = Memory::new();

#[cortex_m_rt::entry]
fn main() -> ! {
    let memory = &raw mut MEMORY;
    // SAFETY: the only use of MEMORY, and `main` runs once.
    let memory = unsafe { &mut *memory };
    // SAFETY: the emulator has filled this part of the flash, which no
    // section of the program lies in, before the program started.
    unsafe {
        fixel_runner::firmware::main(
            InstructionCounter::start(),
            memory,
            SCENE_ADDRESS,
            SCENE_CAPACITY,
        )
    }
}
