//! What the binaries for the Game Boy Advance share: how the processor gets to `main`,
//! a counter of cycles, and a report in RAM, which an emulator's front end reads.
#![no_std]

pub mod cycles;
pub mod display;
pub mod keys;
pub mod report;
mod start;

use core::panic::PanicInfo;

#[panic_handler]
fn panic(_: &PanicInfo<'_>) -> ! {
    report::fail("panic")
}

/// The compiler asks for this where code says that memory accesses keep their order.
/// This processor keeps it.
#[unsafe(no_mangle)]
extern "C" fn __sync_synchronize() {}
