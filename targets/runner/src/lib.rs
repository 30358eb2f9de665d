//! What every target shares.
//!
//! In: a baked scene as bytes, and which frames to render in bands of how many
//! rows. Out: one JSON line a frame, with a hash of everything that was drawn,
//! the covered pixels, and the instructions that it took. The host runs this
//! same crate (`targets/host`), so that equal hashes mean equal bytes.
//!
//! [`engine`] is the only module that knows the renderer. No module formats
//! with `core::fmt` or can panic by itself, so that a firmware which links
//! this crate shows the renderer's own needs.
#![no_std]

pub mod demo;
pub mod engine;
#[cfg(feature = "firmware")]
pub mod firmware;
pub mod hash;
pub mod line;
pub mod measure;
#[cfg(any(target_arch = "arm", target_arch = "riscv32"))]
pub mod selftest;
pub mod stack;

pub use measure::{Job, Memory, Platform, measure};

#[doc(hidden)]
pub use fixel::Aligned;

/// The scene linked in, whose file `FIXEL_SCENE` names at build time. Its name is how the
/// footprint finds its size.
#[macro_export]
macro_rules! scene {
    () => {{
        const BYTES: &[u8] = include_bytes!(env!("FIXEL_SCENE"));
        #[unsafe(no_mangle)]
        static FIXEL_SCENE: $crate::Aligned<[u8; BYTES.len()]> =
            $crate::Aligned(*include_bytes!(env!("FIXEL_SCENE")));
        &FIXEL_SCENE.0
    }};
}
