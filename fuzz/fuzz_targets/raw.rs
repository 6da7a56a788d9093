//! Any bytes: the first ones choose the set-up, the rest is the program. Neither implementation panics, and
//! they agree.

#![no_main]

libfuzzer_sys::fuzz_target!(|input: &[u8]| turnspec_properties::assert_holds("raw", input));
