//! Changes of a program that change nothing, or translate and do nothing else.

#![no_main]

libfuzzer_sys::fuzz_target!(|input: &[u8]| turnspec_properties::assert_holds("metamorphic", input));
