//! Expressions alone: the oracle and the engine agree on every value, bit by bit.

#![no_main]

libfuzzer_sys::fuzz_target!(|input: &[u8]| turnspec_properties::assert_holds("expression", input));
