//! Traces survive JSON, JSON Lines and compact notation; any bytes through the reader of events.

#![no_main]

libfuzzer_sys::fuzz_target!(|input: &[u8]| turnspec_properties::assert_holds("trace", input));
