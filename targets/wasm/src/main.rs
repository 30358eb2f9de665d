//! The measuring loop as a WebAssembly module. Whoever runs it writes a scene to
//! [`scene`], calls [`render`], and is handed lines and bands through two
//! imports; `run.mjs` does so in Node.
#![no_std]
#![no_main]

use core::panic::PanicInfo;
use core::ptr;

use fixel_runner::{Job, Memory, Platform, measure};

/// The largest picture in one band.
const PIXELS: usize = 320 * 240;
/// The largest scene.
const SCENE_BYTES: usize = 4 << 20;

#[link(wasm_import_module = "host")]
unsafe extern "C" {
    /// Takes a text, which ends with a line break.
    fn print(text: *const u8, length: usize);
    /// Takes a finished band's RGB565 bytes.
    fn show(panel: *const u8, length: usize);
    /// The host's clock, in nanoseconds.
    safe fn now() -> f64;
}

/// Aligned as a scene needs it.
#[repr(C, align(4))]
struct Scene([u8; SCENE_BYTES]);

static mut SCENE: Scene = Scene([0; SCENE_BYTES]);
static mut MEMORY: Memory<PIXELS> = Memory::new();

/// What the imports offer.
struct Host;

impl Platform for Host {
    fn ticks(&mut self) -> u64 {
        now() as u64
    }
    fn between(&self, start: u64, end: u64) -> u64 {
        end.wrapping_sub(start)
    }
    fn print(&mut self, text: &[u8]) {
        // SAFETY: the host only reads the text, before this returns.
        unsafe { print(text.as_ptr(), text.len()) }
    }
    fn show(&mut self, panel: &[u8]) {
        // SAFETY: the host only reads the bytes, before this returns.
        unsafe { show(panel.as_ptr(), panel.len()) }
    }
}

/// Where the scene's bytes belong, if there is room for `length` of them; else 0.
#[unsafe(no_mangle)]
pub extern "C" fn scene(length: usize) -> *mut u8 {
    if length > SCENE_BYTES {
        return ptr::null_mut();
    }
    (&raw mut SCENE).cast()
}

/// Renders frames `from..to` of the scene of `length` bytes in bands of `band_rows`
/// rows. Gives 0, or 1 after a line that says what is wrong.
#[unsafe(no_mangle)]
pub extern "C" fn render(length: usize, from: u32, to: u32, band_rows: u32) -> u32 {
    let (scene, memory) = (&raw const SCENE, &raw mut MEMORY);
    // SAFETY: the module has one thread, the imports do not call back, and the host
    // writes to the scene only between calls.
    let (scene, memory) = unsafe { (&*scene, &mut *memory) };
    let job = Job {
        from,
        to,
        band_rows: band_rows as usize,
    };
    let blob = scene.0.get(..length).unwrap_or_default();
    match measure(&mut Host, blob, job, memory) {
        Ok(()) => 0,
        Err(error) => {
            Host.print(error.message().as_bytes());
            1
        }
    }
}

#[panic_handler]
fn panic(_: &PanicInfo<'_>) -> ! {
    Host.print(b"panic\n");
    core::arch::wasm32::unreachable()
}
