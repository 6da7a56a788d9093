//! What a block begins with, found without parsing it (execution, chapter 9, "Where a name stands").

use std::iter::Peekable;

use turnspec_oracle::vocabulary::Label;

use crate::engine::arithmetic::sequence_name;
use crate::engine::parse::is_name;
use crate::engine::planted::{self, Bug};
use crate::engine::text::{Class, Lenient, class};

/// The beginning of a block.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Head {
    /// A program name; none if it is not well formed.
    Program(Option<Label>),
    /// The number of a sequence name without fault.
    Sequence(u32),
    /// Anything else.
    Other,
}

/// Names are no longer than five characters: a run is looked at to its sixth.
const LOOKED_AT: usize = 6;

impl Head {
    /// The beginning of the block with these characters.
    /// `O` or `:` in front makes it a name block (E100L-TAPE-03), which a slash before it does not (E100L-CALL-06). A
    /// sequence name behind a slash is found whatever the switch says (E100L-DEL-04).
    pub fn of(characters: Lenient, block_delete: bool) -> Self {
        let mut rest = characters.peekable();
        skip_blanks(&mut rest);
        match rest.peek() {
            Some(b'O' | b':') => {
                rest.next();
                let run = Run::take(&mut rest);
                let mut label = Label::new("O");
                run.bytes().iter().for_each(|byte| label.push(*byte));
                return Self::Program(is_name(run.bytes(), 4).then_some(label));
            }
            Some(b'/') => {
                rest.next();
                if block_delete && planted::is(Bug::SkippedNoTarget) {
                    return Self::Other;
                }
                if block_delete {
                    while rest.next_if(|byte| matches!(class(*byte), Class::Ignored | Class::Tab)).is_some() {
                    }
                } else {
                    skip_blanks(&mut rest);
                }
            }
            _ => {}
        }
        if rest.next_if_eq(&b'N').is_none() {
            return Self::Other;
        }
        let run = Run::take(&mut rest);
        if run.is_sequence_name(rest.peek()) { Self::Sequence(number(run.bytes())) } else { Self::Other }
    }
}

/// Whether END stands first in a block, behind sequence name and slash (E100L-SDF-20).
pub fn is_end(characters: Lenient) -> bool {
    let mut rest = characters.peekable();
    skip_blanks(&mut rest);
    let slash = skip_slash(&mut rest);
    if rest.next_if_eq(&b'N').is_some() {
        let run = Run::take(&mut rest);
        if !run.is_sequence_name(rest.peek()) {
            return false;
        }
        skip_blanks(&mut rest);
        if !slash {
            skip_slash(&mut rest);
        }
    }
    Run::take(&mut rest).bytes() == b"END"
}

/// Skips a slash and the blanks behind it.
fn skip_slash(rest: &mut Peekable<Lenient>) -> bool {
    let slash = rest.next_if_eq(&b'/').is_some();
    skip_blanks(rest);
    slash
}

/// The number of a valid sequence name without its `N`.
pub fn number(name: &[u8]) -> u32 {
    u32::try_from(sequence_name::index(name)).unwrap_or(u32::MAX)
}

/// The first characters of a run of letters and digits.
struct Run {
    bytes: [u8; LOOKED_AT],
    length: usize,
}

impl Run {
    fn take(rest: &mut Peekable<Lenient>) -> Self {
        let mut run = Self { bytes: [0; LOOKED_AT], length: 0 };
        for slot in &mut run.bytes {
            let alphanumeric = |byte: &u8| matches!(class(*byte), Class::Letter | Class::Digit);
            let Some(byte) = rest.next_if(alphanumeric) else { break };
            *slot = byte;
            run.length += 1;
        }
        run
    }

    /// Whether it is a sequence name behind its `N`, with what stands behind it.
    fn is_sequence_name(&self, next: Option<&u8>) -> bool {
        let delimited = next.is_none_or(|byte| {
            *byte == b'/' || matches!(class(*byte), Class::Ignored | Class::Tab | Class::Open)
        });
        delimited && is_name(self.bytes(), 5) && self.bytes() != b"OEX"
    }

    fn bytes(&self) -> &[u8] {
        self.bytes.get(..self.length).unwrap_or_default()
    }
}

/// Skips ignored characters, TAB and comments; one that is not closed reaches to the end.
fn skip_blanks(rest: &mut Peekable<Lenient>) {
    while let Some(byte) = rest.peek() {
        match class(*byte) {
            Class::Ignored | Class::Tab => {
                rest.next();
            }
            Class::Open => {
                rest.find(|byte| *byte == b')');
            }
            _ => break,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Head, is_end, number};
    use crate::engine::text::Reader;
    use turnspec_oracle::vocabulary::{Label, TapeCode};

    fn head(text: &str, block_delete: bool) -> Head {
        let mut reader = Reader::new(text.as_bytes(), TapeCode::Ascii);
        let lines = reader.next_lines().unwrap_or_default();
        Head::of(reader.lenient(lines), block_delete)
    }

    #[test]
    fn names_stand_at_the_beginning() {
        let ten = Head::Sequence(number(b"10"));
        for text in ["N10", " (A) N10\tX1", "/N10 X", "N10/", "N10(", "\n$ N10", "/ (A)N10", "N10 &"] {
            assert_eq!(head(text, false), ten, "{text:?}");
        }
        for text in ["N10X", "N", "N1A", "N123456", "NOEX", "//N10", "X1 N10", "(A N10", "N10&"] {
            assert_eq!(head(text, false), Head::Other, "{text:?}");
        }
        assert_eq!(head("/ (A)N10", true), Head::Other);
        assert_eq!(head("/ \tN10", true), ten);
        assert_eq!(head("NOEXA", false), Head::Sequence(number(b"OEXA")));
    }

    #[test]
    fn end_ends_a_schedule() {
        let ends = |text: &str| {
            let mut reader = Reader::new(text.as_bytes(), TapeCode::Ascii);
            let lines = reader.next_lines().unwrap_or_default();
            is_end(reader.lenient(lines))
        };
        for text in ["END", " (A) N1 END X", "/END", "N1/END", "/N1 END", "END;", "N1\n$END"] {
            assert!(ends(text), "{text:?}");
        }
        for text in ["ENDE", "END1", "N1END", "N123456 END", "//END", "/N1/END", "X END", "(END)", "NOEX END"]
        {
            assert!(!ends(text), "{text:?}");
        }
    }

    #[test]
    fn programs_have_names() {
        assert_eq!(head(" (A) O12 X", false), Head::Program(Some(Label::new("O12"))));
        assert_eq!(head(":AB&", false), Head::Program(Some(Label::new("OAB"))));
        assert_eq!(head("O12345", false), Head::Program(None));
        assert_eq!(head("/O1", false), Head::Other);
    }
}
