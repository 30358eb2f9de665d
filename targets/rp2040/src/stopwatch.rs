//! Counts the processor's cycles.

use cortex_m::peripheral::SYST;
use cortex_m::peripheral::syst::SystClkSource;
use rp2040_hal::Timer;

use crate::board::SYSTEM_MHZ;

/// The counter of the core has 24 bits; the timer of 1 MHz tells how often it went round.
pub struct Stopwatch {
    timer: Timer,
}

/// A moment.
#[derive(Clone, Copy)]
pub struct Moment {
    cycle: u32,
    microsecond: u32,
}

/// Bits of the core's counter.
const BITS: u32 = 24;

impl Stopwatch {
    /// Starts the counter.
    pub fn new(mut counter: SYST, timer: Timer) -> Self {
        counter.set_clock_source(SystClkSource::Core);
        counter.set_reload((1 << BITS) - 1);
        counter.clear_current();
        counter.enable_counter();
        Self { timer }
    }

    /// Now.
    pub fn now(&self) -> Moment {
        Moment {
            cycle: SYST::get_current(),
            microsecond: self.timer.get_counter_low(),
        }
    }

    /// Cycles since a moment, at most 2^32 of them: half a minute.
    pub fn since(&self, start: Moment) -> u32 {
        let now = self.now();
        // It counts down.
        let cycles = start.cycle.wrapping_sub(now.cycle) & ((1 << BITS) - 1);
        let microseconds = now.microsecond.wrapping_sub(start.microsecond);
        let about = microseconds.wrapping_mul(SYSTEM_MHZ);
        let rounds = about.wrapping_sub(cycles).wrapping_add(1 << (BITS - 1)) >> BITS;
        cycles.wrapping_add(rounds << BITS)
    }
}

/// Cycles since a moment that was less than an eighth of a second ago.
pub fn cycles_since(start: u32) -> u32 {
    start.wrapping_sub(SYST::get_current()) & ((1 << BITS) - 1)
}
