//! Tells the core whether the processor multiplies 32 by 32 bits to 64 and
//! divides. Either way the results are the same; see `math::wide`.

fn main() {
    println!("cargo::rustc-check-cfg=cfg(narrow_multiply)");
    println!("cargo::rerun-if-changed=build.rs");
    let target = std::env::var("TARGET").unwrap_or_default();
    // ARMv4T's Thumb, ARMv6-M and ARMv8-M Baseline: the product's low half only, and no
    // division but on the last.
    let narrow = ["thumbv4t", "thumbv6m", "thumbv8m.base"];
    if narrow.iter().any(|core| target.starts_with(core)) {
        println!("cargo::rustc-cfg=narrow_multiply");
    }
}
