//! The steps of a run (E100L-GOTO-03). Any numbers.

/// The number of the next step; none if the most have been made.
#[must_use]
pub fn next(made: u64, most: u64) -> Option<u64> {
    if made >= most { None } else { Some(made + 1) }
}
