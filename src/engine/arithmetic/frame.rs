//! Program and machine coordinates of one axis (E100L-COORD-03, E100L-G50-02).
//!
//! Amounts are nanometres, X as a diameter, or micro-degrees. Every amount of a set-up, a variable or a word
//! is below 2^38, sums of them below 2^60; within that range nothing saturates.

/// Machine coordinate less program coordinate. The tool offset comes with the sign of its reading.
#[inline]
#[must_use]
pub fn between(zero_offset: i64, zero_shift: i64, tool_offset: i64) -> i64 {
    zero_offset.saturating_add(zero_shift).saturating_add(tool_offset)
}

/// The program coordinate of a machine coordinate.
#[inline]
#[must_use]
pub fn to_program(machine: i64, between: i64) -> i64 {
    machine.saturating_sub(between)
}

/// The machine coordinate of a program coordinate.
#[inline]
#[must_use]
pub fn to_machine(program: i64, between: i64) -> i64 {
    program.saturating_add(between)
}

/// The zero shift after which the present program coordinate is that of a G50 word.
#[inline]
#[must_use]
pub fn shift_to(zero_shift: i64, program: i64, word: i64) -> i64 {
    zero_shift.saturating_add(program.saturating_sub(word))
}

/// The coordinate that a word means: counted from a reference point, or as it is.
#[inline]
#[must_use]
pub fn coordinate(reference: i64, word: i64, incremental: bool) -> i64 {
    if incremental { reference.saturating_add(word) } else { word }
}
