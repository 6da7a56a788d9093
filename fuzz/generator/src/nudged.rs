//! Two programs that differ by one increment of one coordinate.

use arbitrary::Unstructured;
use turnspec_oracle::vocabulary::TapeCode;

use crate::builder::Builder;
use crate::case::Case;
use crate::choices::Choices;
use crate::number::Number;
use crate::print;
use crate::profile::Profile;
use crate::program::{Item, Line, Program, Value};
use crate::setup;
use crate::state::{Axis, State};
use crate::tape;

/// A program, and the same one with one increment more in one X, Z or W word that is a plain number.
#[derive(Clone, PartialEq, Debug)]
pub struct Nudged {
    /// The program.
    pub before: Case,
    /// The program with the other word.
    pub after: Case,
    /// The address of the word.
    pub axis: &'static str,
}

impl Nudged {
    /// The pair that these bytes give; none when their program has no such word, or when it has no
    /// room for another digit.
    #[must_use]
    pub fn from_bytes(bytes: &[u8]) -> Option<Self> {
        let mut bytes = Unstructured::new(bytes);
        let choices = &mut Choices::new(&mut bytes);
        let mut setup = setup::setup(choices, &Profile::FULL);
        setup.tape.code = TapeCode::Ascii;
        let mut builder = Builder::new(choices, State::new(setup), Profile::FULL).straight_on();
        builder.build();
        let (mut program, state) = builder.finish();
        let case = |program: &Program| {
            let mut setup = state.setup.clone();
            setup.library = tape::library(print::plainest_library(program), TapeCode::Ascii);
            Case { setup, program: print::plainest(program) }
        };
        let before = case(&program);
        let mut words = coordinates(&mut program);
        let chosen = choices.below(words.len());
        let (axis, number) = words.get_mut(chosen)?;
        let axis = *axis;
        **number = one_more(**number, state.units.length_decimals())?;
        Some(Self { before, after: case(&program), axis })
    }
}

/// The plain numbers of X, Z and W words.
fn coordinates(program: &mut Program) -> Vec<(&'static str, &mut Number)> {
    let mut words = Vec::new();
    let mut slot = false;
    for line in &mut program.lines {
        let Line::Block(block) = line else { continue };
        let is = |codes: &[i64]| {
            let code = |item: &Item| matches!(item, Item::Word(word) if word.is_g(codes));
            block.items.iter().any(code)
        };
        slot = slot && !is(&[180]) || is(&[190]);
        // There W is an allowance, which tells how many passes there are.
        let axes: &[Axis] =
            if slot || is(&[72]) { &[Axis::X, Axis::Z] } else { &[Axis::X, Axis::Z, Axis::W] };
        for item in &mut block.items {
            let Item::Word(word) = item else { continue };
            let axis = axes.iter().find(|axis| axis.address() == word.address);
            if let (Some(axis), Value::Plain(number)) = (axis, &mut word.value) {
                words.push((axis.address(), number));
            }
        }
    }
    words
}

/// The number and one unit of its last decimal, which has at least this place; none when it has more than
/// eight digits then (E100L-TYPE-03).
fn one_more(number: Number, decimals: u8) -> Option<Number> {
    let finer = decimals.saturating_sub(number.decimals);
    let increment = 10_i64.saturating_pow(u32::from(number.decimals.saturating_sub(decimals)));
    let mantissa = number.mantissa * 10_i64.saturating_pow(u32::from(finer)) + increment;
    let decimals = number.decimals.max(decimals);
    let number = Number { mantissa, decimals, point: number.point || decimals > 0 };
    let (whole, fraction) = number.digits();
    (whole.len() + fraction.len() <= 8).then_some(number)
}

#[cfg(test)]
mod tests {
    use super::one_more;
    use crate::number::Number;

    #[test]
    fn an_increment_is_added_at_its_place() {
        assert_eq!(one_more(Number::decimal(125, 1), 3).map(Number::text).as_deref(), Some("12.501"));
        assert_eq!(one_more(Number::whole(-7), 3).map(Number::text).as_deref(), Some("-6.999"));
        assert_eq!(one_more(Number::whole(7), 0).map(Number::text).as_deref(), Some("8"));
        assert_eq!(one_more(Number::decimal(12_345, 4), 3).map(Number::text).as_deref(), Some("1.2355"));
        assert_eq!(one_more(Number::decimal(99_999_999, 3), 3), None);
    }
}
