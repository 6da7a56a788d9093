//! Every program ends within a number of steps and events that its text tells.

#![no_main]

libfuzzer_sys::fuzz_target!(|input: &[u8]| turnspec_properties::assert_holds("termination", input));
