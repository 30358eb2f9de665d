//! The loop.

use core::cell::Cell;

use cortex_m::peripheral::SYST;
use fixel::Display;
use fixel_demo::{Cost, Demo, DemoError, Memory};
use fixel_runner::line::Line;
use fixel_runner::stack::Stack;

use crate::board::Console;
use crate::halt;
use crate::stopwatch::cycles_since;

/// Cycles that a panel's bus has kept the processor waiting for.
#[derive(Debug, Default)]
pub struct Waited(Cell<u32>);

impl Waited {
    /// None.
    pub const fn new() -> Self {
        Self(Cell::new(0))
    }

    /// Counts what `wait` takes, which is less than an eighth of a second.
    pub fn during<T>(&self, wait: impl FnOnce() -> T) -> T {
        let start = SYST::get_current();
        let result = wait();
        self.0.set(self.0.get().wrapping_add(cycles_since(start)));
        result
    }
}

/// Shows frame after frame of a scene on a panel of `size` columns and rows, `shown` being
/// called after each, and prints a line about each. Ends with a line about what went wrong.
pub fn run<D: Display, const PIXELS: usize>(
    scene: &[u8],
    size: (u16, u16),
    console: &mut Console,
    memory: &mut Memory<PIXELS>,
    waited: &Waited,
    display: &mut D,
    shown: impl FnMut(&mut D),
) -> ! {
    let Err(error) = frames(scene, size, console, memory, waited, display, shown);
    Line::new()
        .text("error", error.message())
        .end(|text| console.print(text));
    halt()
}

unsafe extern "C" {
    /// From the linker script: one past the stack's highest address.
    static _stack_start: u32;
    /// From the linker script: the lowest address that the stack may reach.
    static __sheap: u32;
}

fn paint_stack() -> Stack {
    let bottom = (&raw const __sheap) as usize;
    let top = (&raw const _stack_start) as usize;
    // SAFETY: the linker script gives the stack everything from the end of the static data
    // to its start, there is no heap, and this runs on it.
    unsafe { Stack::paint((bottom + 3) & !3, top) }
}

/// There is no end but an error.
enum Never {}

fn frames<D: Display, const PIXELS: usize>(
    scene: &[u8],
    size: (u16, u16),
    console: &mut Console,
    memory: &mut Memory<PIXELS>,
    waited: &Waited,
    display: &mut D,
    mut shown: impl FnMut(&mut D),
) -> Result<Never, DemoError<D::Error>> {
    let mut stack = Some(paint_stack());
    // Hidden from the optimiser, which would otherwise build a firmware that can draw this
    // one scene only.
    let mut demo = Demo::new(core::hint::black_box(scene), size)?;
    loop {
        waited.0.set(0);
        let start = console.stopwatch.now();
        demo.frame(console.buttons(), memory, display)?;
        let cost = Cost {
            whole: console.stopwatch.since(start),
            waiting: waited.0.get(),
        };
        shown(display);
        // Once: looking takes long.
        if let Some(used) = stack.take().and_then(|stack| stack.used_bytes()) {
            Line::new()
                .small("stack", used as u32)
                .end(|text| console.print(text));
        }
        demo.report(cost).end(|text| console.print(text));
    }
}
