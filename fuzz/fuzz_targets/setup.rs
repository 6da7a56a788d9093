//! Any text through the reader of set-up files: taken and valid, or refused with its place.

#![no_main]

libfuzzer_sys::fuzz_target!(|input: &[u8]| turnspec_properties::assert_holds("setup", input));
