//! Pecks make the depth and no more, and every hole ends where it has to.

#![no_main]

libfuzzer_sys::fuzz_target!(|input: &[u8]| turnspec_properties::assert_holds("cycles", input));
