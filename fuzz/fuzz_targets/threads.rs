//! Passes of threads are whole, and as many and as deep as the patterns say.

#![no_main]

libfuzzer_sys::fuzz_target!(|input: &[u8]| turnspec_properties::assert_holds("threads", input));
