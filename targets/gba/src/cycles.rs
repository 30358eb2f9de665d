//! The processor's cycles, wait states included.

use core::ptr;

/// Counter and control of timers 0 and 1.
const TM0_COUNT: *mut u16 = 0x0400_0100 as *mut u16;
const TM0_CONTROL: *mut u16 = 0x0400_0102 as *mut u16;
const TM1_COUNT: *mut u16 = 0x0400_0104 as *mut u16;
const TM1_CONTROL: *mut u16 = 0x0400_0106 as *mut u16;
const ENABLE: u16 = 1 << 7;
/// Counts how often the timer before runs over.
const CASCADE: u16 = 1 << 2;

/// A counter of cycles of 16.78 MHz; it runs over after 256 seconds.
#[derive(Debug)]
pub struct CycleCounter(());

impl CycleCounter {
    /// Counts from now on, with timers 0 and 1.
    pub fn start() -> Self {
        // SAFETY: registers of this machine, aligned; nothing else uses them.
        unsafe {
            ptr::write_volatile(TM0_CONTROL, 0);
            ptr::write_volatile(TM1_CONTROL, 0);
            ptr::write_volatile(TM0_COUNT, 0);
            ptr::write_volatile(TM1_COUNT, 0);
            ptr::write_volatile(TM1_CONTROL, ENABLE | CASCADE);
            ptr::write_volatile(TM0_CONTROL, ENABLE);
        }
        Self(())
    }

    /// Cycles up to now.
    #[inline(never)]
    pub fn now(&self) -> u32 {
        loop {
            // SAFETY: reading has no side effect.
            let (high, low, again) = unsafe {
                (
                    ptr::read_volatile(TM1_COUNT),
                    ptr::read_volatile(TM0_COUNT),
                    ptr::read_volatile(TM1_COUNT),
                )
            };
            if high == again {
                return u32::from(high) << 16 | u32::from(low);
            }
        }
    }
}
