//! Emits the linker's arguments, so that no cargo configuration is needed.

fn main() {
    let here = std::env::var("CARGO_MANIFEST_DIR").expect("cargo sets CARGO_MANIFEST_DIR");
    println!("cargo:rustc-link-arg-bins=--nmagic");
    println!("cargo:rustc-link-arg-bins=-T{here}/gba.x");
    println!("cargo:rerun-if-changed=gba.x");
    println!("cargo:rerun-if-changed=build.rs");
}
