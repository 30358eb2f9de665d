//! Loops of known length, to prove that the instruction counter is exact.

use core::arch::asm;
use core::hint::black_box;

use crate::line::Line;
use crate::measure::{Platform, count};

/// Loop lengths: small ones catch rounding, neighbours catch a counter that
/// ticks in steps, the last is longer than any frame.
const LENGTHS: [u32; 9] = [1, 2, 3, 10, 11, 1_000, 65_537, 3_000_001, 100_000_000];

/// A loop to count.
#[derive(Clone, Copy)]
struct Kind {
    name: &'static str,
    per_iteration: u64,
    run: fn(u32),
}

const KINDS: [Kind; 2] = [
    Kind {
        name: "straight",
        per_iteration: 2,
        run: straight,
    },
    Kind {
        name: "memory",
        per_iteration: 4,
        run: through_memory,
    },
];

/// Runs loops and prints, for each, `loop` (its kind), `length`, `expected` and
/// `count`. The straight loop takes 2 instructions an iteration, the one
/// through memory 4 (a load, a store, a decrement, a branch). What the first
/// iteration costs, with the call around it, is taken off.
pub fn run<P: Platform>(platform: &mut P) {
    for kind in KINDS {
        let first = spent(platform, kind, 1);
        for length in LENGTHS {
            let count = spent(platform, kind, length);
            Line::new()
                .text("loop", kind.name)
                .small("length", length)
                .number("expected", u64::from(length - 1) * kind.per_iteration)
                .number("count", count.wrapping_sub(first))
                .end(|text| platform.print(text));
        }
    }
}

/// Not inlined, so that the instructions around the loop are always the same.
#[inline(never)]
fn spent<P: Platform>(platform: &mut P, kind: Kind, length: u32) -> u64 {
    count(platform, || (kind.run)(black_box(length)))
}

/// `length` times two instructions, and a fixed number before and after.
#[inline(never)]
fn straight(length: u32) {
    // SAFETY: touches nothing but its own register and the flags.
    unsafe {
        #[cfg(target_arch = "arm")]
        asm!("2:", "subs {n}, {n}, #1", "bne 2b", n = inout(reg) length => _, options(nomem, nostack));
        #[cfg(target_arch = "riscv32")]
        asm!("2:", "addi {n}, {n}, -1", "bnez {n}, 2b", n = inout(reg) length => _, options(nomem, nostack));
    }
}

/// `length` times four instructions, two of which go to memory, and a fixed
/// number before and after.
#[inline(never)]
fn through_memory(length: u32) {
    let mut word = 0u32;
    let place = &raw mut word;
    // SAFETY: loads and stores `word` only, which outlives the block.
    unsafe {
        #[cfg(target_arch = "arm")]
        asm!("2:", "ldr {t}, [{p}]", "str {t}, [{p}]", "subs {n}, {n}, #1", "bne 2b",
            n = inout(reg) length => _, p = in(reg) place, t = out(reg) _, options(nostack));
        #[cfg(target_arch = "riscv32")]
        asm!("2:", "lw {t}, 0({p})", "sw {t}, 0({p})", "addi {n}, {n}, -1", "bnez {n}, 2b",
            n = inout(reg) length => _, p = in(reg) place, t = out(reg) _, options(nostack));
    }
}
