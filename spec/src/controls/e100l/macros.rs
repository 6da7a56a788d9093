//! Macro codes: G and M codes that the set-up gives a program to (E100L-MACRO-01, E100L-MACRO-02).

/// What a macro code acts as.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Macro {
    /// CALL.
    Call,
    /// MODIN.
    Modal,
}

/// What the code of this letter acts as, if it is a macro code.
pub fn kind(letter: u8, code: u16) -> Option<Macro> {
    match (letter, code) {
        (b'G', 161..=170) => Some(Macro::Modal),
        (b'G', 171 | 205..=214) | (b'M', 321..=325 | 341..=360) => Some(Macro::Call),
        _ => None,
    }
}
