//! The comment of user alarms, VUACM (E100L-VUACM-01, E100L-VUACM-03).

use turnspec_oracle::vocabulary::rule_ids::*;
use turnspec_oracle::vocabulary::{Action, AlarmName, RuleSet, Sink, Text, Value};

use crate::engine::Interpreter;
use crate::engine::assignment::Origin;
use crate::engine::fault::Fault;
use crate::engine::system::SystemVariable;
use crate::engine::variables::variable_label;
use crate::engine::words::{Code, Parsed};

/// How a string behind VUACM is written.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum CommentForm {
    /// As it is.
    Plain,
    /// By hexadecimal codes (E100L-VUACM-04).
    Codes,
    /// With a prefix that makes its letters lower case (E100L-VUACM-05).
    Lower,
}

/// The positions of the comment, and which of them have been set.
#[derive(Debug, Default)]
pub struct Comment {
    codes: [u8; 16],
    set: [bool; 16],
}

impl Comment {
    /// Writes characters from a position on, counted from 1; false when they go beyond the last one.
    fn write(&mut self, position: usize, characters: &[u8]) -> bool {
        let first = position.saturating_sub(1);
        let places = first..first + characters.len();
        let (Some(codes), Some(set)) = (self.codes.get_mut(places.clone()), self.set.get_mut(places)) else {
            return false;
        };
        codes.copy_from_slice(characters);
        set.fill(true);
        true
    }

    /// What is displayed: the characters up to the first position that has not been set.
    pub fn shown(&self) -> &[u8] {
        let length = self.set.iter().take_while(|set| **set).count();
        self.codes.get(..length).unwrap_or_default()
    }
}

impl Interpreter<'_> {
    /// Assigns a string to the comment from a position on.
    pub(in crate::engine) fn assign_comment(
        &mut self,
        parsed: &Parsed,
        suffix: Code,
        (text, form): (Code, CommentForm),
        origin: Origin,
        sink: &mut impl Sink,
    ) -> Result<(), Fault> {
        let position = self.compute(parsed, suffix)?.number();
        let position = self.suffix(SystemVariable::Comment, position)?;
        let characters = parsed.text(text);
        if !self.communication.comment.write(position, characters) {
            return Fault::raise(AlarmName::StringTooLong, VUACM_01);
        }
        let rules = match form {
            CommentForm::Plain => const { RuleSet::of(&[VUACM_01]) },
            CommentForm::Codes => const { RuleSet::of(&[VUACM_01, VUACM_04]) },
            CommentForm::Lower => const { RuleSet::of(&[VUACM_01, VUACM_05]) },
        };
        let name = variable_label(SystemVariable::Comment, Some(position));
        let value = Value::Text(Text::new(characters));
        self.emit(sink, origin.rules(rules), Action::Variable { name, value });
        Ok(())
    }
}
