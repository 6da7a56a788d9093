//! Addresses, and the words that are no addresses.

/// Address letters of E100L-ADDR-01 that carry a value.
pub const LETTERS: &[u8] = b"ABCDEFGHIJKLMPQRSTUWXYZ";

/// Extended addresses that are modelled (E100L-FMT-03).
pub const EXTENDED: &[&str] = &["SB", "SA", "QA", "PZ", "PW", "DA", "DB", "FA", "FB", "XA", "XB", "ZA", "ZB"];

/// The other extended addresses.
pub const EXTENDED_LATER: &[&str] =
    &["AA", "AB", "IA", "IB", "KA", "KB", "LA", "LB", "RA", "RB", "TA", "TB", "UA", "UB", "WA", "WB", "BC"];

/// Statements that stand at the beginning of a block (E100L-GCODE-03).
pub const STATEMENTS: &[&str] = &[
    "GOTO", "IF", "CALL", "RTS", "MODIN", "MODOUT", "READ", "WRITE", "GET", "PUT", "NOEX", "PSELECT", "VSET",
    "END",
];

/// Binary operators that are words (E100L-MATH-02 to -04, E100L-AEXP-03).
pub const OPERATOR_WORDS: &[&str] = &["EOR", "OR", "AND", "LT", "LE", "EQ", "NE", "GT", "GE"];

/// Statements of schedule programs alone (E100L-SDF-02).
pub const OF_SCHEDULES: &[&str] = &["PSELECT", "VSET", "END"];

/// Statements that a longer run of letters and digits may begin with: a blank is missing (E100L-CTL-03).
pub const DELIMITED: &[&str] =
    &["GOTO", "IF", "CALL", "RTS", "MODIN", "MODOUT", "READ", "WRITE", "GET", "PUT", "NOEX"];
