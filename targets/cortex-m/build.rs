//! Emits the memory map and the linker's arguments, so that no cargo
//! configuration is needed.

use std::{env, fs, path::Path};

/// mps2-an385 and mps2-an386: 4 MB of SSRAM at 0, which stands for flash, and
/// 4 MB of RAM. The upper half of the flash is kept for a scene, which the
/// emulator loads there (`SCENE_ADDRESS` in `src/lib.rs`).
const MEMORY: &str = "\
MEMORY
{
  FLASH : ORIGIN = 0x00000000, LENGTH = 2M
  RAM : ORIGIN = 0x20000000, LENGTH = 4M
}
";

fn main() {
    let out = env::var("OUT_DIR").expect("cargo sets OUT_DIR");
    fs::write(Path::new(&out).join("memory.x"), MEMORY).expect("OUT_DIR can be written");
    println!("cargo:rustc-link-search={out}");
    println!("cargo:rustc-link-arg-bins=--nmagic");
    println!("cargo:rustc-link-arg-bins=-Tlink.x");
    println!("cargo:rustc-check-cfg=cfg(thumbv6m)");
    if env::var("TARGET").is_ok_and(|target| target.starts_with("thumbv6m")) {
        println!("cargo:rustc-cfg=thumbv6m");
    }
    println!("cargo:rerun-if-changed=build.rs");
}
