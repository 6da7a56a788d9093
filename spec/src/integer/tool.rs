//! The parts of a T word (E100L-TOOL-02).

/// Nose radius, tool and offset number of a T word of at most six digits: two digits each.
#[must_use]
pub fn parts(number: i64) -> (u8, u8, u8) {
    let pair = |value: i64| u8::try_from(value % 100).unwrap_or_default();
    (pair(number / 10_000), pair(number / 100), pair(number))
}
