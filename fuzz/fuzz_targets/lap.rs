//! Rough turning cycles: what is cut, what is left, how many passes.

#![no_main]

libfuzzer_sys::fuzz_target!(|input: &[u8]| turnspec_properties::assert_holds("lap", input));
