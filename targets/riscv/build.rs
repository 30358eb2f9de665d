//! Emits the memory map and the linker's arguments, so that no cargo
//! configuration is needed.

use std::{env, fs, path::Path};

/// QEMU's virt machine has RAM from 0x8000_0000. The first 16 MB stand for
/// flash: the program, then a scene, which the emulator loads at the upper half
/// (`SCENE_ADDRESS` in `src/lib.rs`). Nothing unwinds, so unwind tables go.
const MEMORY: &str = "\
MEMORY
{
  FLASH : ORIGIN = 0x80000000, LENGTH = 8M
  RAM : ORIGIN = 0x81000000, LENGTH = 4M
}
REGION_ALIAS(\"REGION_TEXT\", FLASH);
REGION_ALIAS(\"REGION_RODATA\", FLASH);
REGION_ALIAS(\"REGION_DATA\", RAM);
REGION_ALIAS(\"REGION_BSS\", RAM);
REGION_ALIAS(\"REGION_HEAP\", RAM);
REGION_ALIAS(\"REGION_STACK\", RAM);
SECTIONS { /DISCARD/ : { *(.eh_frame .eh_frame.* .eh_frame_hdr) } }
";

fn main() {
    let out = env::var("OUT_DIR").expect("cargo sets OUT_DIR");
    fs::write(Path::new(&out).join("memory.x"), MEMORY).expect("OUT_DIR can be written");
    println!("cargo:rustc-link-search={out}");
    println!("cargo:rustc-link-arg-bins=-Tmemory.x");
    println!("cargo:rustc-link-arg-bins=-Tlink.x");
    println!("cargo:rerun-if-changed=build.rs");
}
