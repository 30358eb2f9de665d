//! The libretro interface (libretro.h, version 1), as much of it as is used.

use std::ffi::{c_char, c_uint, c_void};
use std::sync::Mutex;

use libloading::Library;

const API_VERSION: c_uint = 1;
const SET_PIXEL_FORMAT: c_uint = 10;
/// With the bit of what is experimental.
const SET_MEMORY_MAPS: c_uint = 36 | 0x1_0000;
const DEVICE_JOYPAD: c_uint = 1;

/// A joypad's buttons, in the order of their numbers.
const BUTTONS: [&str; 12] = [
    "b", "y", "select", "start", "up", "down", "left", "right", "a", "x", "l", "r",
];

#[repr(C)]
struct GameInfo {
    path: *const c_char,
    data: *const c_void,
    size: usize,
    meta: *const c_char,
}

/// `struct retro_memory_descriptor`.
#[repr(C)]
struct Descriptor {
    flags: u64,
    pointer: *const u8,
    offset: usize,
    start: usize,
    select: usize,
    disconnect: usize,
    length: usize,
    space: *const c_char,
}

/// `struct retro_memory_map`.
#[repr(C)]
struct MemoryMap {
    descriptors: *const Descriptor,
    count: c_uint,
}

/// Some of the machine's memory.
struct Region {
    /// Its first address in the machine.
    start: usize,
    length: usize,
    /// Where it is in this process.
    here: usize,
}

impl Region {
    fn place(&self, address: usize, length: usize) -> Option<usize> {
        let at = address.checked_sub(self.start)?;
        (at + length <= self.length).then_some(self.here + at)
    }
}

/// How the core's pixels are laid out.
#[derive(Clone, Copy)]
enum Format {
    Rgb1555,
    Xrgb8888,
    Rgb565,
}

/// What the core's call-backs see, which bring no context of their own.
struct Panel {
    format: Format,
    /// Three bytes a pixel.
    pixels: Vec<u8>,
    /// A bit a button.
    held: u32,
    regions: Vec<Region>,
}

static PANEL: Mutex<Panel> = Mutex::new(Panel {
    format: Format::Rgb1555,
    pixels: Vec::new(),
    held: 0,
    regions: Vec::new(),
});

fn panel<T>(with: impl FnOnce(&mut Panel) -> T) -> T {
    with(&mut PANEL.lock().unwrap_or_else(|error| error.into_inner()))
}

/// Holds the buttons named, and no others.
pub fn hold(names: &str) -> Result<(), String> {
    let mut held = 0;
    for name in names.split(',').filter(|name| *name != "none") {
        let number = BUTTONS.iter().position(|button| *button == name);
        held |= 1 << number.ok_or(format!("no button is called {name}"))?;
    }
    panel(|panel| panel.held = held);
    Ok(())
}

/// The last frame's pixels, three bytes each.
pub fn screen() -> Result<Vec<u8>, String> {
    let pixels = panel(|panel| panel.pixels.clone());
    if pixels.is_empty() {
        return Err("nothing was shown yet".into());
    }
    Ok(pixels)
}

/// A core with a cartridge in it.
pub struct Core {
    object: Library,
    /// The core may read it in place.
    _rom: Vec<u8>,
}

impl Core {
    /// Loads a core and starts a cartridge.
    pub fn load(path: &str, rom: Vec<u8>) -> Result<Self, String> {
        let fail = |error: libloading::Error| format!("{path}: {error}");
        // SAFETY: a core's library runs no code of note when it is loaded.
        let object = unsafe { Library::new(path) }.map_err(fail)?;
        let core = Self { object, _rom: rom };
        let set = |name, callback: *const c_void| {
            // SAFETY: the libretro interface gives these functions one pointer to a
            // function, and each is given the one whose signature it names.
            unsafe {
                let set = core
                    .object
                    .get::<unsafe extern "C" fn(*const c_void)>(name)?;
                set(callback);
            }
            Ok(())
        };
        let game = GameInfo {
            path: std::ptr::null(),
            data: core._rom.as_ptr().cast(),
            size: core._rom.len(),
            meta: std::ptr::null(),
        };
        let start = || -> Result<(c_uint, bool), libloading::Error> {
            // SAFETY: the signature is libretro's, as those below are.
            let version = unsafe {
                let version = core
                    .object
                    .get::<unsafe extern "C" fn() -> c_uint>(b"retro_api_version\0")?;
                version()
            };
            set(b"retro_set_environment\0", environment as *const c_void)?;
            // SAFETY: the environment is set, as it must be.
            unsafe { core.object.get::<unsafe extern "C" fn()>(b"retro_init\0")?() };
            set(b"retro_set_video_refresh\0", video as *const c_void)?;
            set(b"retro_set_audio_sample\0", audio_sample as *const c_void)?;
            set(b"retro_set_audio_sample_batch\0", audio as *const c_void)?;
            set(b"retro_set_input_poll\0", input_poll as *const c_void)?;
            set(b"retro_set_input_state\0", input_state as *const c_void)?;
            // SAFETY: the cartridge lives as long as the core.
            let loaded = unsafe {
                let load = core
                    .object
                    .get::<unsafe extern "C" fn(*const GameInfo) -> bool>(b"retro_load_game\0")?;
                load(&raw const game)
            };
            Ok((version, loaded))
        };
        match start().map_err(fail)? {
            (API_VERSION, true) => Ok(core),
            (API_VERSION, false) => Err("the core takes no such cartridge".into()),
            (version, _) => Err(format!("{path}: version {version} of libretro")),
        }
    }

    /// Runs until the panel has its next frame.
    pub fn frame(&mut self) {
        // SAFETY: a cartridge is loaded, and all call-backs are set.
        unsafe {
            if let Ok(run) = self.object.get::<unsafe extern "C" fn()>(b"retro_run\0") {
                run();
            }
        }
    }

    /// The `length` bytes from an address of the machine on.
    pub fn memory(&self, address: usize, length: usize) -> Result<&[u8], String> {
        let place = panel(|panel| {
            let mut regions = panel.regions.iter();
            regions.find_map(|region| region.place(address, length))
        });
        let place = place.ok_or(format!("the core shows no memory at {address:#x}"))?;
        // SAFETY: the core keeps the region there for as long as the cartridge is
        // loaded, and writes to it in `frame` only, which needs `&mut`.
        Ok(unsafe { std::slice::from_raw_parts(place as *const u8, length) })
    }
}

impl Drop for Core {
    fn drop(&mut self) {
        for name in [&b"retro_unload_game\0"[..], b"retro_deinit\0"] {
            // SAFETY: the signature is libretro's, in the order that it asks for.
            unsafe {
                if let Ok(end) = self.object.get::<unsafe extern "C" fn()>(name) {
                    end();
                }
            }
        }
    }
}

extern "C" fn environment(command: c_uint, data: *mut c_void) -> bool {
    match command {
        SET_PIXEL_FORMAT => {
            // SAFETY: with this command comes an `enum retro_pixel_format`.
            let format = match unsafe { *data.cast::<c_uint>() } {
                0 => Format::Rgb1555,
                1 => Format::Xrgb8888,
                2 => Format::Rgb565,
                _ => return false,
            };
            panel(|panel| panel.format = format);
        }
        SET_MEMORY_MAPS => {
            // SAFETY: with this command comes a `struct retro_memory_map`, whose
            // pointer leads to as many descriptors as it says.
            let map = unsafe {
                let map = &*data.cast::<MemoryMap>();
                std::slice::from_raw_parts(map.descriptors, map.count as usize)
            };
            let regions = map.iter().map(|descriptor| Region {
                start: descriptor.start,
                length: descriptor.length,
                here: descriptor.pointer as usize + descriptor.offset,
            });
            panel(|panel| panel.regions = regions.collect());
        }
        _ => return false,
    }
    true
}

extern "C" fn video(data: *const c_void, width: c_uint, height: c_uint, pitch: usize) {
    // The same frame again.
    if data.is_null() {
        return;
    }
    panel(|panel| {
        panel.pixels.clear();
        for y in 0..height as usize {
            for x in 0..width as usize {
                // SAFETY: the core lends `height` rows, `pitch` bytes apart, of `width`
                // pixels in the format that it has set.
                let pixel = unsafe {
                    let row = data.cast::<u8>().add(y * pitch);
                    match panel.format {
                        Format::Xrgb8888 => row.cast::<u32>().add(x).read_unaligned(),
                        _ => row.cast::<u16>().add(x).read_unaligned().into(),
                    }
                };
                panel.pixels.extend(rgb(panel.format, pixel));
            }
        }
    });
}

/// A pixel as 8 bits a channel, rounded to the nearest.
fn rgb(format: Format, pixel: u32) -> [u8; 3] {
    let channel = |shift: u32, bits: u32| {
        let most = (1 << bits) - 1;
        (((pixel >> shift & most) * 255 + most / 2) / most) as u8
    };
    match format {
        Format::Rgb1555 => [channel(10, 5), channel(5, 5), channel(0, 5)],
        Format::Xrgb8888 => [channel(16, 8), channel(8, 8), channel(0, 8)],
        // Five bits of the machine's, and the uppermost of them once more or 0.
        Format::Rgb565 => [channel(11, 5), channel(6, 5), channel(0, 5)],
    }
}

extern "C" fn audio_sample(_: i16, _: i16) {}

extern "C" fn audio(_: *const i16, frames: usize) -> usize {
    frames
}

extern "C" fn input_poll() {}

extern "C" fn input_state(port: c_uint, device: c_uint, _: c_uint, button: c_uint) -> i16 {
    let held = panel(|panel| panel.held);
    (port == 0 && device == DEVICE_JOYPAD && held >> button.min(31) & 1 == 1).into()
}
