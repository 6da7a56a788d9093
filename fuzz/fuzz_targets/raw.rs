//! Any bytes: the first ones choose the set-up, the rest is the program. Neither implementation panics, and
//! they agree.

#![no_main]

use libfuzzer_sys::fuzz_target;
use turnspec::differential::compare;
use turnspec_generator::Case;

fuzz_target!(|bytes: &[u8]| {
    let case = Case::from_raw(bytes);
    if let Err(disagreement) = compare(&case.program, &case.setup) {
        panic!("{disagreement}\n{}\n{:?}", case.program.escape_ascii(), case.setup);
    }
});
