//! Programs of the generator: the oracle and the engine agree on them.

#![no_main]

use libfuzzer_sys::fuzz_target;
use turnspec::differential::compare;
use turnspec_generator::Case;

fuzz_target!(|case: Case| {
    if let Err(disagreement) = compare(&case.program, &case.setup) {
        panic!("{disagreement}\n{}\n{:?}", String::from_utf8_lossy(&case.program), case.setup);
    }
});
