//! Expressions alone: the oracle and the engine agree on every value, bit by bit.

use arbitrary::{Arbitrary, Unstructured};
use turnspec_generator::{Case, Formulas};
use turnspec_oracle::vocabulary::{Setup, UnitSystem};

use crate::Verdict;
use crate::differential::agree;

/// The most bytes of a text that is taken as an expression.
const LONGEST: usize = 150;

/// An expression has the same value, bit by bit, or the same alarm in the oracle and in the engine: assigned
/// to a common variable, and as the value of words that are exact decimals afterwards. The expressions are
/// those of the generator, with all operators and functions, in all unit systems, on variables that hold any
/// binary64 numbers; each of them once more after one of its characters was changed; and the bytes as they
/// are.
///
/// Rules: E100L-AEXP-01, E100L-AEXP-05, E100L-AEXP-06, E100L-AEXP-07, E100L-TYPE-01, E100L-TYPE-08,
/// E100L-TYPE-10, E100L-TYPE-12, E100L-FUNC-01, E100L-FUNC-02, E100L-MATH-05, E100L-MATH-18, E100L-CVAR-04
pub(crate) fn expressions_agree(input: &[u8]) -> Verdict {
    raw(input)?;
    let mut bytes = Unstructured::new(input);
    let Ok(formulas) = Formulas::arbitrary(&mut bytes) else { return Ok(()) };
    for text in &formulas.texts {
        statement(text.as_bytes(), &formulas.setup)?;
        let place = bytes.choose_index(text.len().max(1)).unwrap_or_default();
        let byte = *bytes.choose(b"0159.+-*/[], $NV").unwrap_or(&b'1');
        let mut changed = text.clone().into_bytes();
        if let Some(old) = changed.get_mut(place) {
            *old = byte;
        }
        statement(&changed, &formulas.setup)?;
    }
    Ok(())
}

/// An assignment to V9, then its value as a length, an angle and a speed.
fn statement(assignment: &[u8], setup: &Setup) -> Verdict {
    for word in ["X=V9", "C=V9", "S=V9", "V10=ROUND[V9]"] {
        let program = [assignment, b"\n", word.as_bytes(), b"\nM02\n"].concat();
        agree(&Case { setup: setup.clone(), program })?;
    }
    Ok(())
}

/// The input as an expression in a unit system of each kind.
fn raw(input: &[u8]) -> Verdict {
    let text = input.get(..LONGEST).unwrap_or(input);
    let program = [b"V1=1.5 V2=-2\nV9=", text, b"\nX=V9\nM02\n"].concat();
    for unit_system in [UnitSystem::Millimetre, UnitSystem::Micrometre, UnitSystem::Inch] {
        let setup = Setup { unit_system, ..Setup::default() };
        agree(&Case { setup, program: program.clone() })?;
    }
    Ok(())
}
