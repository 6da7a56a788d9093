//! One increment more in one coordinate changes the shape of nothing and moves little.

#![no_main]

libfuzzer_sys::fuzz_target!(|input: &[u8]| turnspec_properties::assert_holds("perturbation", input));
