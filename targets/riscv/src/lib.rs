//! What the binaries for RISC-V under QEMU share: an exact instruction
//! counter, and the end of a program that went wrong.
#![no_std]

use core::panic::PanicInfo;

use fixel_runner::firmware::Counter;
use riscv::register::{mepc, minstret};

/// Where the emulator's loader puts a scene.
pub const SCENE_ADDRESS: usize = 0x8080_0000;
/// Bytes kept for it there.
pub const SCENE_CAPACITY: usize = 0x0080_0000;

/// Counts executed instructions: `minstret`, which QEMU keeps exactly under
/// `-icount shift=0`.
#[derive(Debug)]
pub struct InstructionCounter(());

impl InstructionCounter {
    /// Counts from now on.
    pub fn start() -> Self {
        Self(())
    }
}

impl Counter for InstructionCounter {
    #[inline(never)]
    fn ticks(&mut self) -> u64 {
        minstret::read64()
    }

    fn between(&self, start: u64, end: u64) -> u64 {
        end.wrapping_sub(start)
    }
}

#[panic_handler]
fn panic(_: &PanicInfo<'_>) -> ! {
    fixel_runner::firmware::fail("panic")
}

#[unsafe(no_mangle)]
extern "C" fn ExceptionHandler() -> ! {
    fixel_runner::firmware::fault(mepc::read())
}
