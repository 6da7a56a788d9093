//! The oracle and the engine agree: on programs of the generator, on any bytes.

use arbitrary::{Arbitrary, Unstructured};
use turnspec::differential::compare;
use turnspec_generator::Case;

use crate::Verdict;

/// On a program that the generator grows from the bytes, and on its set-up, the oracle and the engine give
/// the same events with the same coordinates, rules, readings and places, and the same alarm.
pub(crate) fn generated_programs_agree(input: &[u8]) -> Verdict {
    match Case::arbitrary(&mut Unstructured::new(input)) {
        Ok(case) => agree(&case),
        Err(_) => Ok(()),
    }
}

/// The same on any bytes: the first ones choose the set-up, the rest is the program.
pub(crate) fn any_bytes_agree(input: &[u8]) -> Verdict {
    agree(&Case::from_raw(input))
}

/// The oracle and the engine agree on a case.
pub(crate) fn agree(case: &Case) -> Verdict {
    compare(&case.program, &case.setup)
        .map(drop)
        .map_err(|disagreement| format!("{disagreement}\n{}", show(case)))
}

/// A case as text.
pub(crate) fn show(case: &Case) -> String {
    format!("{}\n{}", case.program.escape_ascii(), toml::to_string(&case.setup).unwrap_or_default())
}
