//! Output variables VDOUT, the comment of user alarms, user alarm C.

use turnspec_oracle::vocabulary::{Feature, UserAlarmC};

use super::interference::of_value;
use crate::builder::Builder;
use crate::expression::{Expression, Variable};
use crate::number::Number;
use crate::program::Item;

/// Outputs of one bit.
pub(super) const BITS: &[i64] = &[1, 2, 8, 11, 18, 21, 22, 23, 24, 31, 38, 41, 48];

/// Outputs of eight bits.
pub(super) const BYTES: &[i64] = &[9, 19, 39, 49];

/// The positions of the comment.
const POSITIONS: i64 = 16;

impl Builder<'_, '_, '_> {
    /// A block that sets an output, or two, sometimes with words behind.
    pub(super) fn output(&mut self) {
        self.begin();
        let mut items = vec![self.output_assignment()];
        if self.choices.chance(25) {
            self.state.begin_block();
            items.push(self.output_assignment());
        }
        if self.choices.chance(15) {
            self.companions(&mut items);
        }
        self.push(items);
    }

    /// An assignment to an output.
    pub(crate) fn output_assignment(&mut self) -> Item {
        let byte = self.choices.chance(35);
        let number = self.choices.pick(if byte { BYTES } else { BITS });
        let wanted = self.choices.within(0, if byte { 255 } else { 1 });
        let aside = self.choices.pick(&[0, 0, 0, 0, 4, -4]);
        let written = Number::decimal(wanted * 10 + aside, 1);
        let (suffix, _) = self.suffix(number);
        let value = if aside == 0 { of_value(self.value(written).0) } else { Expression::Constant(written) };
        Item::Assignment(Variable::Indexed("VDOUT", suffix), value)
    }

    /// A block that writes a part of the comment, or two.
    pub(super) fn comment(&mut self) {
        self.begin();
        let mut items = vec![self.comment_item()];
        if self.choices.chance(20) {
            items.push(self.comment_item());
        }
        if self.choices.chance(10) {
            self.companions(&mut items);
        }
        self.push(items);
    }

    /// A string for a part of the comment.
    pub(crate) fn comment_item(&mut self) -> Item {
        let position = if self.choices.chance(45) { 1 } else { self.choices.within(1, POSITIONS) };
        let most = usize::try_from(POSITIONS + 1 - position).unwrap_or(1);
        let (text, _) = self.comment_text(most);
        let (suffix, _) = self.suffix(position);
        Item::Comment(*suffix, text)
    }

    /// User alarm C, with which the program goes on or not.
    pub(super) fn message(&mut self) {
        let stops = self.state.setup.readings.user_alarm_c == UserAlarmC::Stops;
        if stops && !(self.choices.chance(15) && self.allows(Feature::Alarm)) {
            return self.comment();
        }
        self.begin();
        let mut items = Vec::new();
        if self.choices.chance(30) {
            items.push(self.comment_item());
        }
        items.push(self.alarm_item(991));
        if self.choices.chance(20) {
            self.companions(&mut items);
        }
        self.push(items);
        if stops {
            self.nothing_more();
        }
    }

    /// A code for one of the outputs that raise user alarms.
    pub(crate) fn alarm_item(&mut self, output: i64) -> Item {
        let code = self.choices.pick(&[1, 9_999, 12, 3, 500]);
        let value = match self.choices.below(4) {
            0 => Expression::Constant(Number::decimal(code * 10 - 4, 1)),
            _ => of_value(self.value(Number::whole(code)).0),
        };
        let suffix = Box::new(Expression::Constant(Number::whole(output)));
        Item::Assignment(Variable::Indexed("VDOUT", suffix), value)
    }
}
