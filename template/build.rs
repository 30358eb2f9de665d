fn main() {
    // scene.toml and the files that it names become OUT_DIR/scene.fxl.
    fixel_bake::scene("scene.toml");
    // memory.x is in this folder; link.x is cortex-m-rt's.
    println!("cargo::rustc-link-search={}", env!("CARGO_MANIFEST_DIR"));
    println!("cargo::rustc-link-arg-bins=--nmagic");
    println!("cargo::rustc-link-arg-bins=-Tlink.x");
    println!("cargo::rerun-if-changed=memory.x");
}
