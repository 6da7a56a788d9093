//! The end of a program of two sides (E100L-AX4-05).

use turnspec_oracle::vocabulary::rule_ids::*;
use turnspec_oracle::vocabulary::{Action, AlarmName, Ending, Label, Place, RuleSet, Side, Sink};

use crate::engine::Interpreter;
use crate::engine::arithmetic::span::offset;
use crate::engine::fault::Fault;

/// An M02 or M30 that was carried out.
#[derive(Clone, Copy, Debug)]
pub struct End {
    pub code: Label,
    pub side: Side,
    pub place: Place,
}

impl Interpreter<'_> {
    /// Both sides have ended: the reset of each, and the end.
    pub(super) fn end_saddles(&mut self, sink: &mut impl Sink) -> Result<Ending, Fault> {
        let Some(End { code, side, place }) = self.saddles.end else {
            self.turn_to(self.saddles.last_ended.unwrap_or(Side::A));
            self.place = self.end_of_text();
            return Fault::raise(AlarmName::NoProgramEnd, PROG_02);
        };
        for side in [Side::A, Side::B] {
            self.turn_to(side);
            self.place = place;
            self.reset(sink);
        }
        self.turn_to(side);
        self.place = place;
        self.emit(sink, const { RuleSet::of(&[MCODE_04, AX4_05]) }, Action::End { code });
        Ok(Ending::End)
    }

    /// The place behind the last line.
    pub(super) fn end_of_text(&self) -> Place {
        let end = offset(self.reader.length());
        Place {
            program: self.task.present.name,
            sequence: Label::default(),
            line: self.saddles.division.last_line,
            start: end,
            end,
        }
    }
}
