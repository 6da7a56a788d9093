//! Two spellings of one program do the same; a syntax tree that is printed is read back.

#![no_main]

libfuzzer_sys::fuzz_target!(|input: &[u8]| turnspec_properties::assert_holds("round_trip", input));
