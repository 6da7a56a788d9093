//! Spelling does not matter: two texts of one program do the same, and a tree that is printed is read back.

use arbitrary::{Arbitrary, Unstructured};
use turnspec_generator::{Case, Respelled};
use turnspec_oracle::syntax::{Body, Source, Statement, parse};
use turnspec_oracle::vocabulary::{Event, Label, Setup, TapeCode};

use crate::differential::show;
use crate::shape::{is_alarm, trace, without_place};
use crate::tree_text::block;
use crate::{Verdict, require};

/// The longest block, in characters (E100L-FMT-05).
const LONGEST: usize = 158;

/// Two spellings of a program of the generator (blanks, tabs, comments, signs, leading and trailing zeros,
/// equal signs, superfluous brackets, continuation lines, CR, tape codes) have the same trace but for the
/// places in the text. When words of a block stand in another order too (codes among themselves excepted, and
/// blocks with an assignment), the events are the same up to an alarm; which fault of a block is found first
/// is the only thing that may differ.
///
/// The syntax tree of every block without fault, of that program and of the bytes as they are, printed in one
/// plain spelling parses to the same tree (spans aside). A tree whose plain spelling is longer than a block
/// may be is left out.
///
/// Rules: E100L-FMT-01, E100L-FMT-02, E100L-FMT-03, E100L-FMT-07, E100L-CMT-01, E100L-AEXP-04, E100L-AEXP-05,
/// E100L-AEXP-06, E100L-AEXP-07, E100L-AEXP-12, E100L-TAPE-01, E100L-TAPE-02, E100L-DEC-02, E100L-CVAR-01
pub(crate) fn spelling_does_not_matter(input: &[u8]) -> Verdict {
    trees(&Case::from_raw(input))?;
    let Ok(pair) = Respelled::arbitrary(&mut Unstructured::new(input)) else { return Ok(()) };
    trees(&pair.one)?;
    spellings(&pair).map_err(|message| format!("{message}\n{}\n{}", show(&pair.one), show(&pair.other)))
}

fn spellings(pair: &Respelled) -> Verdict {
    let (one, other) = (trace(&pair.one), trace(&pair.other));
    let alarms = [&one, &other].map(|trace| trace.last().is_some_and(is_alarm));
    let faulty = pair.reordered && alarms == [true, true];
    let comparable = |trace: &[Event]| -> Vec<Event> {
        trace.iter().filter(|event| !faulty || !is_alarm(event)).map(without_place).collect()
    };
    let (one, other) = (comparable(&one), comparable(&other));
    let unlike = one.iter().zip(&other).find(|(a, b)| a != b);
    require(unlike.is_none(), || format!("{unlike:?}"))?;
    require(one.len() == other.len(), || format!("{} and {} events", one.len(), other.len()))
}

fn trees(case: &Case) -> Verdict {
    let plain_code = Setup { tape: Setup::default().tape, ..case.setup.clone() };
    let mut source = Source::new(&case.program, case.setup.tape.code);
    loop {
        match source.next_line() {
            Ok(Some(line)) => {
                let mut sequence = Label::default();
                if let Ok(tree) = parse(&line, &case.setup, &mut sequence) {
                    reads_back(sequence, &tree.body, &plain_code)
                        .map_err(|text| format!("{text}\n{}", show(case)))?;
                }
            }
            Ok(None) => return Ok(()),
            Err(_) => {}
        }
    }
}

fn reads_back(sequence: Label, body: &Body, setup: &Setup) -> Verdict {
    let text = block(sequence.as_str(), body);
    if text.len() > LONGEST {
        return Ok(());
    }
    let mut source = Source::new(text.as_bytes(), TapeCode::Ascii);
    let line = match source.next_line() {
        Ok(line) => line,
        Err(fault) => return Err(format!("{text}: {fault:?}")),
    };
    let Some(line) = line else {
        return require(*body == Body::Empty, || format!("{body:?} is printed as nothing"));
    };
    let mut name = Label::default();
    let again = parse(&line, setup, &mut name).map_err(|fault| format!("{text}: {fault:?}"))?;
    require(name == sequence && kinds(&again.body) == kinds(body), || {
        format!("{body:?} is printed as {text}")
    })
}

/// A body without the spans of its items.
fn kinds(body: &Body) -> Body {
    let mut body = body.clone();
    if let Body::Items(items)
    | Body::Noex(items)
    | Body::ContourCall(_, items)
    | Body::Statement(Statement::Call(_, items) | Statement::Modin(_, items)) = &mut body
    {
        for item in items {
            item.span = 0..0;
        }
    }
    body
}

#[cfg(test)]
mod tests {
    use super::{reads_back, spellings, trees};
    use turnspec_generator::{Case, Respelled};
    use turnspec_oracle::syntax::Body;
    use turnspec_oracle::vocabulary::{Label, Setup};

    fn verdict(one: &str, other: &str, reordered: bool) -> Result<(), String> {
        let case = |text: &str| Case { setup: Setup::default(), program: text.as_bytes().to_vec() };
        spellings(&Respelled { one: case(one), other: case(other), reordered })
    }

    #[test]
    fn other_programs_are_no_other_spellings() {
        assert_eq!(verdict("G00 X5\nM02", "G0X+5.0 (A)\r\nM2", false), Ok(()));
        assert!(verdict("G00 X5\nM02", "G00 X6\nM02", false).is_err());
        assert!(verdict("M08\nM02", "M08\nM09\nM02", false).is_err());
        assert_eq!(verdict("M08\nX999999 S70000", "M08\nS70000 X999999", true), Ok(()));
        assert!(verdict("M08\nX999999 S70000", "M08\nS70000 X999999", false).is_err());
        assert!(verdict("M08\nJ1", "M08\nM02", true).is_err());
    }

    #[test]
    fn calls_of_contours_read_back_whatever_their_blanks() {
        let program = b"N1 G85  NAT1   D4F0.3 G84  XA=30\nM02".to_vec();
        assert_eq!(trees(&Case { setup: Setup::default(), program }), Ok(()));
    }

    #[test]
    fn a_tree_that_is_printed_as_another_is_noticed() {
        let wrong = Body::ProgramName(Label::new("X5"));
        assert!(reads_back(Label::default(), &wrong, &Setup::default()).is_err());
    }
}
