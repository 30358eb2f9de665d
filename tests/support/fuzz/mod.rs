//! What the fuzzers run, so that tests run it as well: with the bytes that were found to
//! break something, and with some that are as good as any.
//!
//! In: any bytes. Out: nothing; what must not happen panics. Used by `fuzz/` and by
//! `tests/fuzzed.rs`.
#![allow(clippy::missing_panics_doc, reason = "a panic is what is looked for")]

mod arithmetic;
mod blob;
mod calls;
mod files;
mod numbers;
mod panels;
mod scene;

pub use arithmetic::arithmetic;
pub use blob::{blob, features, made_good};
pub use calls::calls;
pub use files::{mesh, picture, text};
pub use panels::panels;
pub use scene::scene;
