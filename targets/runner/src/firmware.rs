//! What a firmware under an emulator needs besides its counter: arguments,
//! console and exit through semihosting, and the stack's bounds, which
//! `cortex-m-rt` and `riscv-rt` name alike.

use core::ptr;

use semihosting::{experimental::env, io::Write, process};

use crate::line::Line;
use crate::measure::{Job, Memory, Platform, measure};
use crate::stack::Stack;

/// Bytes of command line that are read.
const COMMAND_BYTES: usize = 512;

unsafe extern "C" {
    /// From the linker script: one past the stack's highest address.
    static _stack_start: u32;
    /// From the linker script: one past the highest static address, where a
    /// heap would start, and the lowest that the stack may reach.
    static __sheap: u32;
}

/// The counter of a target; the rest of [`Platform`] is semihosting.
pub trait Counter {
    /// A running counter, which may wrap.
    fn ticks(&mut self) -> u64;
    /// Instructions executed between two readings.
    fn between(&self, start: u64, end: u64) -> u64;
}

/// A counter and the semihosting console.
#[derive(Debug)]
struct Emulated<C> {
    counter: C,
    /// Where finished bands are written, when asked for.
    picture: Option<semihosting::fs::File>,
}

impl<C: Counter> Platform for Emulated<C> {
    fn ticks(&mut self) -> u64 {
        self.counter.ticks()
    }
    fn between(&self, start: u64, end: u64) -> u64 {
        self.counter.between(start, end)
    }
    fn print(&mut self, text: &[u8]) {
        print(text);
    }
    fn show(&mut self, panel: &[u8]) {
        if let Some(file) = &mut self.picture
            && file.write_all(panel).is_err()
        {
            fail("the picture cannot be written");
        }
    }
}

/// Prints to the emulator's standard output.
pub fn print(text: &[u8]) {
    if let Ok(mut out) = semihosting::io::stdout() {
        let _ = out.write_all(text);
    }
}

/// Ends the emulator: exit code 0 if all went well, else 1.
pub fn exit(success: bool) -> ! {
    process::exit(if success { 0 } else { 1 })
}

/// Prints why nothing more can be done, as a line with `error`, and ends.
pub fn fail(message: &str) -> ! {
    Line::new().text("error", message).end(print);
    exit(false)
}

/// Paints the unused stack.
pub fn paint_stack() -> Stack {
    let bottom = (&raw const __sheap) as usize;
    let top = (&raw const _stack_start) as usize;
    // SAFETY: the linker script gives the stack everything from the end of
    // the static data to its start, there is no heap, and this runs on it.
    unsafe { Stack::paint((bottom + 3) & !3, top) }
}

/// Prints the stack's high-water mark, in bytes, as a line with `stack`.
pub fn print_stack(stack: &Stack) {
    match stack.used_bytes() {
        Some(used) => Line::new().small("stack", used as u32).end(print),
        None => fail("the stack is deeper than its paint"),
    }
}

/// The scene that the emulator's loader has put into memory.
///
/// # Safety
/// `address` is a multiple of 4, and the `length` bytes from there are mapped,
/// initialised, and never written while the program runs.
unsafe fn loaded(address: usize, length: usize) -> &'static [u8] {
    // SAFETY: by the caller's promise.
    unsafe { core::slice::from_raw_parts(ptr::with_exposed_provenance(address), length) }
}

/// The measuring firmware's main function. Its command line is one of
///
/// - `selftest`: counts loops of known length;
/// - `render LENGTH FROM TO BAND_ROWS [FILE]`: renders frames `FROM..TO` of the
///   scene of `LENGTH` bytes at `scene_address`; the RGB565 bytes go to `FILE`.
///
/// # Safety
/// `scene_address` is where the emulator loads a scene, as [`loaded`] needs it,
/// with at least `scene_capacity` bytes mapped.
pub unsafe fn main<C: Counter, const PIXELS: usize>(
    counter: C,
    memory: &mut Memory<PIXELS>,
    scene_address: usize,
    scene_capacity: usize,
) -> ! {
    let Ok(arguments) = env::args::<COMMAND_BYTES>() else {
        fail("no command line");
    };
    let mut arguments = (&arguments).map(|argument| argument.unwrap_or(""));
    let mut platform = Emulated {
        counter,
        picture: None,
    };
    match arguments.next() {
        #[cfg(any(target_arch = "arm", target_arch = "riscv32"))]
        Some("selftest") => crate::selftest::run(&mut platform),
        Some("render") => {
            let mut number = || arguments.next().and_then(|text| text.parse::<u32>().ok());
            let (Some(length), Some(from), Some(to), Some(rows)) =
                (number(), number(), number(), number())
            else {
                fail("usage: render LENGTH FROM TO BAND_ROWS [FILE]");
            };
            if length as usize > scene_capacity {
                fail("the scene is larger than the flash kept for it");
            }
            if let Some(path) = arguments.next() {
                platform.picture = create(path);
            }
            // SAFETY: the caller's promise, and the length was checked.
            let blob = unsafe { loaded(scene_address, length as usize) };
            let job = Job {
                from,
                to,
                band_rows: rows as usize,
            };
            let stack = paint_stack();
            if let Err(error) = measure(&mut platform, blob, job, memory) {
                fail(error.message());
            }
            print_stack(&stack);
        }
        _ => fail("usage: selftest | render LENGTH FROM TO BAND_ROWS [FILE]"),
    }
    exit(true)
}

/// Opens a file on the host for writing.
fn create(path: &str) -> Option<semihosting::fs::File> {
    let mut name = [0; COMMAND_BYTES];
    let place = name.get_mut(..path.len())?;
    #[expect(clippy::disallowed_methods, reason = "it has as many bytes")]
    place.copy_from_slice(path.as_bytes());
    let name = core::ffi::CStr::from_bytes_until_nul(&name).ok()?;
    let file = semihosting::fs::File::create(name);
    if file.is_err() {
        fail("the picture's file cannot be created");
    }
    file.ok()
}

/// Prints where an exception struck, and ends.
pub fn fault(address: usize) -> ! {
    Line::new()
        .text("error", "fault")
        .small("at", address as u32)
        .end(print);
    exit(false)
}

/// Floats, and panics on an empty scene: what the check of the linked firmware
/// must find in a demo that calls it.
#[inline(never)]
pub fn misbehave(blob: &[u8]) {
    let last = blob[core::hint::black_box(blob.len()) - 1];
    core::hint::black_box(f32::from(last) * core::hint::black_box(0.1));
}

/// The demo firmware's main function: draws one frame into a panel that
/// swallows it, and prints how deep the stack went; if it tells, also the hash of what the panel
/// got, as the measuring firmware has it.
pub fn demo(blob: &[u8], memory: &mut crate::demo::Memory) -> ! {
    let stack = paint_stack();
    #[cfg(feature = "tells")]
    let mut hash = crate::hash::Fnv64::new();
    let drawn = crate::demo::draw(blob, 0, memory, |row| {
        #[cfg(feature = "tells")]
        hash.bytes(row);
        for byte in row {
            let mut panel = 0u8;
            // SAFETY: a local; volatile, as a panel's data register would be.
            unsafe { ptr::write_volatile(&raw mut panel, *byte) };
        }
    });
    if let Err(error) = drawn {
        fail(error.message());
    }
    #[cfg(feature = "tells")]
    Line::new().hex("panel", hash.value()).end(print);
    print_stack(&stack);
    exit(true)
}
