//! Programs of the generator: the oracle and the engine agree on them.

#![no_main]

libfuzzer_sys::fuzz_target!(|input: &[u8]| turnspec_properties::assert_holds("structured", input));
