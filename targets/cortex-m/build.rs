//! Emits the memory map and the linker's arguments, so that no cargo
//! configuration is needed.

use std::{env, fs, path::Path};

/// A machine's memory. The upper part of the flash is kept for a scene, which
/// the emulator loads there.
struct Map {
    /// Where flash starts, and its size.
    flash: (u32, u32),
    /// How much of it is the program's.
    program: u32,
    /// The same of RAM.
    ram: (u32, u32),
}

/// mps2-an385, an386 and an500: 4 MB of SSRAM at 0, which stands for flash, and
/// 4 MB of RAM.
const MPS2: Map = Map {
    flash: (0, 4 << 20),
    program: 1 << 20,
    ram: (0x2000_0000, 4 << 20),
};
/// mps2-an505, in its secure state: SSRAM1, and SSRAM2.
const AN505: Map = Map {
    flash: (0x1000_0000, 4 << 20),
    program: 1 << 20,
    ram: (0x3800_0000, 2 << 20),
};
/// nRF51822.
const MICROBIT: Map = Map {
    flash: (0, 256 << 10),
    program: 128 << 10,
    ram: (0x2000_0000, 16 << 10),
};
/// STM32F103C8, whose firmware carries its scene.
const STM32F103: Map = Map {
    flash: (0x0800_0000, 64 << 10),
    program: 64 << 10,
    ram: (0x2000_0000, 20 << 10),
};

fn main() {
    let out = env::var("OUT_DIR").expect("cargo sets OUT_DIR");
    let target = env::var("TARGET").expect("cargo sets TARGET");
    let microbit = env::var_os("CARGO_FEATURE_MICROBIT").is_some();
    let stm32f103 = env::var_os("CARGO_FEATURE_STM32F103").is_some();
    let map = match target.as_str() {
        _ if microbit => MICROBIT,
        _ if stm32f103 => STM32F103,
        "thumbv8m.main-none-eabihf" => AN505,
        _ => MPS2,
    };
    let (flash, program) = (map.flash.0, map.program);
    let rest = map.flash.1 - program;
    let (ram, ram_bytes) = map.ram;
    let memory = format!(
        "MEMORY\n{{\n  \
           FLASH : ORIGIN = {flash:#010x}, LENGTH = {program:#x}\n  \
           RAM : ORIGIN = {ram:#010x}, LENGTH = {ram_bytes:#x}\n}}\n"
    );
    let scene = flash + program;
    let code = format!(
        "/// Where the emulator's loader puts a scene: the upper part of the flash.\n\
         pub const SCENE_ADDRESS: usize = {scene:#x};\n\
         /// Bytes from there to the end of the flash.\n\
         pub const SCENE_CAPACITY: usize = {rest:#x};\n"
    );
    let out = Path::new(&out);
    fs::write(out.join("memory.x"), memory).expect("OUT_DIR can be written");
    // Of a device crate, which would name the interrupts' handlers.
    fs::write(out.join("device.x"), "").expect("OUT_DIR can be written");
    fs::write(out.join("scene.rs"), code).expect("OUT_DIR can be written");
    println!("cargo:rustc-link-search={}", out.display());
    println!("cargo:rustc-link-arg-bins=--nmagic");
    println!("cargo:rustc-link-arg-bins=-Tlink.x");
    println!("cargo:rustc-check-cfg=cfg(thumbv6m)");
    println!("cargo:rustc-check-cfg=cfg(counted)");
    if target.starts_with("thumbv6m") {
        println!("cargo:rustc-cfg=thumbv6m");
    }
    if map.flash == MPS2.flash {
        println!("cargo:rustc-cfg=counted");
    }
    println!("cargo:rerun-if-changed=build.rs");
}
