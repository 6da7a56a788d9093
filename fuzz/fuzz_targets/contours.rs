//! Motions of contours with the C axis: on their lines and circles, seen under the travel of C.

#![no_main]

libfuzzer_sys::fuzz_target!(|input: &[u8]| turnspec_properties::assert_holds("contours", input));
