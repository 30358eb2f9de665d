//! What the binaries for Cortex-M under QEMU share: an exact instruction
//! counter where the board's timer allows one, and the end of a program that went wrong.
#![no_std]

use core::panic::PanicInfo;
#[cfg(any(counted, thumbv6m))]
use core::ptr;

use fixel_runner::firmware::Counter;

include!(concat!(env!("OUT_DIR"), "/scene.rs"));

#[cfg(not(counted))]
pub use uncounted::InstructionCounter;

#[cfg(counted)]
pub use counted::InstructionCounter;

/// Configuration and Control Register of the system control block.
#[cfg(thumbv6m)]
const SCB_CCR: *mut u32 = 0xE000_ED14 as *mut u32;
#[cfg(thumbv6m)]
const CCR_UNALIGN_TRP: u32 = 1 << 3;

/// Makes unaligned access a fault in thumbv6m code, as it is on the Cortex-M0
/// and M0+, because the emulated core may be a larger one.
fn be_strict() {
    #[cfg(thumbv6m)]
    // SAFETY: a register of every Cortex-M, aligned and mapped; nothing else
    // uses it.
    unsafe {
        ptr::write_volatile(SCB_CCR, ptr::read_volatile(SCB_CCR) | CCR_UNALIGN_TRP);
    }
}

#[cfg(counted)]
mod counted {
    use super::{Counter, be_strict, ptr};

    /// The first CMSDK APB timer of the mps2 boards: 32 bits, counts down at 25 MHz
    /// (Arm DDI 0479, chapter 4).
    const TIMER: usize = 0x4000_0000;
    const TIMER_CTRL: *mut u32 = TIMER as *mut u32;
    const TIMER_VALUE: *mut u32 = (TIMER + 4) as *mut u32;
    const TIMER_RELOAD: *mut u32 = (TIMER + 8) as *mut u32;

    /// `-icount shift=7`: an instruction takes 128 ns of virtual time, which is
    /// 3.2 timer ticks of 40 ns. Two readings are off by less than a tick, 0.3
    /// instructions, so the nearest integer is the exact count. The timer wraps
    /// after 1.3e9 instructions, which bounds one stretch of counting.
    const NS_PER_INSTRUCTION: u64 = 128;
    const NS_PER_TICK: u64 = 40;

    /// Counts executed instructions, exactly, under `-icount shift=7`.
    #[derive(Debug)]
    pub struct InstructionCounter(());

    impl InstructionCounter {
        /// Starts the timer. In thumbv6m code, also makes unaligned access a fault,
        /// as it is on the Cortex-M0+, because the emulated core is a larger one.
        pub fn start() -> Self {
            // SAFETY: registers of the mps2 boards, aligned and mapped; nothing else
            // uses them.
            unsafe {
                ptr::write_volatile(TIMER_RELOAD, u32::MAX);
                ptr::write_volatile(TIMER_VALUE, u32::MAX);
                ptr::write_volatile(TIMER_CTRL, 1);
            }
            be_strict();
            Self(())
        }
    }

    impl Counter for InstructionCounter {
        #[inline(never)]
        fn ticks(&mut self) -> u64 {
            // SAFETY: reading the timer's value has no side effect.
            u64::from(!unsafe { ptr::read_volatile(TIMER_VALUE) })
        }

        fn between(&self, start: u64, end: u64) -> u64 {
            let ticks = (end as u32).wrapping_sub(start as u32);
            (u64::from(ticks) * NS_PER_TICK + NS_PER_INSTRUCTION / 2) / NS_PER_INSTRUCTION
        }
    }
}

/// Boards that are there for their bytes alone.
#[cfg(not(counted))]
mod uncounted {
    use super::{Counter, be_strict};

    /// Counts nothing: every count is 0.
    #[derive(Debug)]
    pub struct InstructionCounter(());

    impl InstructionCounter {
        /// Makes unaligned access in thumbv6m code a fault.
        pub fn start() -> Self {
            be_strict();
            Self(())
        }
    }

    impl Counter for InstructionCounter {
        fn ticks(&mut self) -> u64 {
            0
        }

        fn between(&self, _: u64, _: u64) -> u64 {
            0
        }
    }
}

/// The vectors of an STM32F103's 60 interrupts, none of which is enabled.
#[cfg(feature = "stm32f103")]
mod vectors {
    unsafe extern "C" {
        /// Of `cortex-m-rt`.
        fn DefaultHandler();
    }

    #[unsafe(link_section = ".vector_table.interrupts")]
    #[unsafe(no_mangle)]
    static __INTERRUPTS: [unsafe extern "C" fn(); 60] = [DefaultHandler; 60];
}

#[panic_handler]
fn panic(_: &PanicInfo<'_>) -> ! {
    fixel_runner::firmware::fail("panic")
}

#[cortex_m_rt::exception]
unsafe fn HardFault(frame: &cortex_m_rt::ExceptionFrame) -> ! {
    fixel_runner::firmware::fault(frame.pc() as usize)
}
