//! See `fixel_tests::fuzz::arithmetic`.
#![no_main]

mod repeatable;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| fixel_tests::fuzz::arithmetic(bytes));
