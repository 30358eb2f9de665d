//! The smallest firmware: one frame of the scene linked in, in bands of 16
//! rows, to a panel that swallows it. Prints how deep the stack went.
#![no_std]
#![no_main]

use fixel_cortex_m as _;
use fixel_runner::{demo, firmware, scene};

static mut MEMORY: demo::Memory = demo::Memory::new();

#[cortex_m_rt::entry]
fn main() -> ! {
    let memory = &raw mut MEMORY;
    // SAFETY: the only use of MEMORY, and `main` runs once.
    let memory = unsafe { &mut *memory };
    // Hidden from the optimiser, which would otherwise build a firmware that
    // can draw this one scene only.
    let scene = core::hint::black_box(scene!());
    #[cfg(feature = "faulty")]
    firmware::misbehave(scene);
    firmware::demo(scene, memory)
}
