//! Any bytes through the readers of text: places lie in the text and in order, the readers agree.

#![no_main]

libfuzzer_sys::fuzz_target!(|input: &[u8]| turnspec_properties::assert_holds("parse", input));
