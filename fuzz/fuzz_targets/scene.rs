//! See `fixel_tests::fuzz::scene`.
#![no_main]

mod repeatable;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| fixel_tests::fuzz::scene(bytes));
