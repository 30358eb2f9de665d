//! See `fixel_tests::fuzz::picture`.
#![no_main]

mod repeatable;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| fixel_tests::fuzz::picture(bytes));
