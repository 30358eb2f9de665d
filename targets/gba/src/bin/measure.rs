//! Renders the scene that lies behind the program in the cartridge, and counts cycles.
//! `cargo xtask parity` puts it there, with what to do: four words, which are the
//! scene's length, the first frame, one past the last, and the rows of a band.
#![no_std]
#![no_main]

use fixel_gba::{cycles::CycleCounter, report};
use fixel_runner::line::Line;
use fixel_runner::stack::Stack;
use fixel_runner::{Job, Memory, Platform, measure};

/// Where the scene begins; what to do is right before it.
const SCENE: *const u8 = 0x0840_0000 as *const u8;
const TASK: *const [u32; 4] = 0x083F_FFF0 as *const [u32; 4];
/// Bytes from there to the end of a cartridge of 32 MB.
const SCENE_CAPACITY: usize = 28 << 20;

/// The largest band.
const PIXELS: usize = 320 * 64;

static mut MEMORY: Memory<PIXELS> = Memory::new();

unsafe extern "C" {
    /// From the linker script: one past the stack's highest address.
    static _stack_start: u32;
    /// From the linker script: the lowest address that the stack may reach.
    static __sheap: u32;
}

/// Its counter, and the report.
struct Console(CycleCounter);

impl Platform for Console {
    fn ticks(&mut self) -> u64 {
        self.0.now().into()
    }
    fn between(&self, start: u64, end: u64) -> u64 {
        (end as u32).wrapping_sub(start as u32).into()
    }
    fn print(&mut self, text: &[u8]) {
        report::print(text);
    }
}

#[unsafe(no_mangle)]
extern "C" fn main() -> ! {
    report::begin();
    let memory = &raw mut MEMORY;
    // SAFETY: the only use of MEMORY, and `main` runs once.
    let memory = unsafe { &mut *memory };
    // SAFETY: the cartridge has four words there, as said above, and never changes.
    let [length, from, to, rows] = unsafe { TASK.read_volatile() };
    let length = (length as usize).min(SCENE_CAPACITY);
    // SAFETY: the scene is in the cartridge, which never changes.
    let blob = unsafe { core::slice::from_raw_parts(SCENE, length) };
    let job = Job {
        from,
        to,
        band_rows: rows as usize,
    };
    let (bottom, top) = (
        (&raw const __sheap) as usize,
        (&raw const _stack_start) as usize,
    );
    // SAFETY: the linker script gives the stack all of this, and `main` runs on it.
    let stack = unsafe { Stack::paint(bottom, top) };
    if let Err(error) = measure(&mut Console(CycleCounter::start()), blob, job, memory) {
        report::fail(error.message());
    }
    match stack.used_bytes() {
        Some(used) => Line::new().small("stack", used as u32).end(report::print),
        None => report::fail("the stack is deeper than its paint"),
    }
    report::end(true)
}
