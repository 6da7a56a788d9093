//! READ and GET.

use turnspec_oracle::vocabulary::{Feature, ProgramText};

use super::AREA;
use crate::builder::Builder;
use crate::expression::{Expression, Variable};
use crate::number::Number;
use crate::program::Statement;
use crate::state::Axis;
use crate::unit::Written;

/// The most digits of a number that is received.
const DIGITS: usize = 8;

/// What can take a number.
#[derive(Clone, Copy)]
enum Target {
    Common,
    Local,
    ToolOffset,
    ZeroOffset,
    Droop,
    Output,
    Interference,
}

impl Builder<'_, '_, '_> {
    /// READ now and then, and GET of some of what is there.
    pub(super) fn receive(&mut self) {
        if self.state.io.unread.is_empty() || self.choices.chance(25) {
            self.read();
        }
        for _ in 0..=self.choices.below(4) {
            if self.state.io.unread.is_empty() {
                break;
            }
            self.get();
        }
    }

    /// READ of a text that is there, or of one that the device gets for it.
    fn read(&mut self) {
        let code = self.state.setup.parameters.end_code;
        let channel = self.choices.below(10).min(self.choices.below(10));
        let name = format!("CN{channel}");
        let taken = self.state.io.taken[channel];
        let known =
            self.state.setup.devices.get(&name).and_then(|texts| texts.get(taken)).map(|text| text.0.clone());
        let text = known.unwrap_or_else(|| {
            let text = super::transmission(self.choices, code);
            self.state.setup.devices.entry(name).or_default().push(ProgramText(text.clone()));
            text
        });
        let end = if code == turnspec_oracle::vocabulary::EndCode::Null { 0 } else { b'%' };
        let area: Vec<u8> = text.into_iter().take_while(|byte| *byte != end).collect();
        if area.len() > AREA && !self.choices.chance(4) {
            // It would be too long: its end code comes early.
            let text = self
                .state
                .setup
                .devices
                .get_mut(&format!("CN{channel}"))
                .and_then(|texts| texts.get_mut(taken));
            if let Some(text) = text {
                text.0.insert(self.choices.below(AREA), end);
            }
            return self.read();
        }
        self.begin();
        self.statement(Statement::Read(channel as i64), Vec::new());
        self.state.io.taken[channel] += 1;
        self.state.io.unread = area;
    }

    /// GET of a number if one begins here, else over what lies before the next one.
    fn get(&mut self) {
        self.begin();
        let unread = self.state.io.unread.clone();
        let found = number_at(&unread).filter(|_| !self.choices.chance(8));
        let Some((length, _)) = found else { return self.pass_over(&unread) };
        let cut = if self.choices.chance(20) { 1 + self.choices.below(length) } else { length };
        let part = unread.get(..cut).unwrap_or_default();
        let (length, number) = match number_at(part) {
            Some((shorter, number)) if shorter == cut => (cut, number),
            _ => match number_at(&unread) {
                Some(found) => found,
                None => return self.pass_over(&unread),
            },
        };
        let Some(target) = self.target_of(number) else { return self.pass_over(&unread) };
        let rest = length == unread.len() && self.choices.chance(60);
        let length_written = (!rest).then_some(length as i64);
        self.statement(Statement::Get(Some(target), length_written), Vec::new());
        self.state.io.unread.drain(..length);
    }

    /// GET without a variable, to the next number or anywhere.
    fn pass_over(&mut self, unread: &[u8]) {
        let next = (1..unread.len())
            .find(|place| unread.get(*place..).is_some_and(|rest| number_at(rest).is_some()));
        let length = match next {
            Some(place) if self.choices.chance(85) => place,
            _ => 1 + self.choices.below(unread.len()),
        };
        self.statement(Statement::Get(None, Some(length as i64)), Vec::new());
        self.state.io.unread.drain(..length.min(unread.len()));
    }

    /// A variable that can take a number, with the number in it.
    fn target_of(&mut self, number: Number) -> Option<Variable> {
        let text = !self.state.is_eia();
        let system = self.allows(Feature::SystemVariable);
        let length = self.state.units.assigned_length(Written::Plain(number));
        let rounded = number.to_f64().round();
        let brackets = text && system && self.allows(Feature::Expression);
        let frame = self.allows(Feature::ZeroShift) && !self.state.barriers.is_watched();
        let bit = brackets && self.allows(Feature::InputOutput) && (0.0..=255.0).contains(&rounded);
        let weight = |weight, holds: bool| if holds { weight } else { 0 };
        let list = [
            (weight(30, self.allows(Feature::Variable)), Target::Common),
            (weight(12, self.allows(Feature::LocalVariable)), Target::Local),
            (
                weight(16, brackets && self.allows(Feature::Tool) && length.abs() <= 90_000_000),
                Target::ToolOffset,
            ),
            (weight(6, system && frame && length.abs() <= 60_000_000), Target::ZeroOffset),
            (weight(8, system && (0.0..=1_000.0).contains(&rounded)), Target::Droop),
            (weight(12, bit), Target::Output),
            (weight(8, brackets && (0..=9_999_999_000).contains(&length)), Target::Interference),
        ];
        if list.iter().all(|(weight, _)| *weight == 0) {
            return None;
        }
        match self.choices.weighted(&list) {
            Target::Common => Some(self.common_target(number)),
            Target::Local => self.local_target(number.to_f64()).map(Variable::Local),
            Target::ToolOffset => {
                let entry = self.choices.within(1, 4);
                let axis = self.choices.below(2);
                let (suffix, _) = self.suffix(entry);
                let entry = u8::try_from(entry).unwrap_or(1);
                self.state.tool_offsets.entry(entry).or_default()[axis] = length;
                Some(Variable::Indexed(["VTOFX", "VTOFZ"][axis], suffix))
            }
            Target::ZeroOffset => {
                let axis = self.choices.pick(&[Axis::X, Axis::Z]);
                self.state.zero_offset[axis as usize] = length;
                Some(Variable::System(["VZOFX", "VZOFZ"][axis as usize]))
            }
            Target::Droop => Some(Variable::System(self.choices.pick(&["VINPX", "VINPZ", "VINPC"]))),
            Target::Output => {
                let output = self.choices.pick(if rounded <= 1.0 {
                    super::outputs::BITS
                } else {
                    super::outputs::BYTES
                });
                let (suffix, _) = self.suffix(output);
                Some(Variable::Indexed("VDOUT", suffix))
            }
            Target::Interference => Some(self.stored_length(length)),
        }
    }

    fn common_target(&mut self, number: Number) -> Variable {
        let place = self.choices.within(1, 9) as u8;
        self.state.common.insert(place, number.to_f64());
        self.state.control.now_known(place);
        Variable::Common(place)
    }

    /// A suffix of this value, or of one that is rounded to it.
    pub(super) fn suffix(&mut self, number: i64) -> (Box<Expression>, i64) {
        let written = match self.choices.below(12) {
            0 => Number::decimal(number * 10 + 4, 1),
            1 => Number::decimal(number * 10 - 5, 1),
            _ => Number::whole(number),
        };
        let expression = match self.value(written).0 {
            crate::program::Value::Expression(expression) if written == Number::whole(number) => expression,
            _ => Expression::Constant(written),
        };
        (Box::new(expression), number)
    }
}

/// The longest number at the beginning of a text (E100L-GPUT-05), with the blanks before it.
pub(crate) fn number_at(text: &[u8]) -> Option<(usize, Number)> {
    let mut at = text.iter().take_while(|byte| **byte == b' ').count();
    let negative = text.get(at) == Some(&b'-');
    at += usize::from(negative || text.get(at) == Some(&b'+'));
    let (mut mantissa, mut decimals, mut digits, mut point) = (0_i64, 0_u8, 0, false);
    let mut end = None;
    while let Some(byte) = text.get(at) {
        match byte {
            b'0'..=b'9' if digits < DIGITS => {
                mantissa = mantissa * 10 + i64::from(byte - b'0');
                decimals += u8::from(point);
                digits += 1;
            }
            b'.' if !point => point = true,
            _ => break,
        }
        at += 1;
        if digits > 0 {
            let mantissa = if negative { -mantissa } else { mantissa };
            end = Some((at, Number { mantissa, decimals, point }));
        }
    }
    end
}

#[cfg(test)]
mod tests {
    use super::number_at;

    #[test]
    fn numbers_end_where_get_ends_them() {
        let length = |text: &str| number_at(text.as_bytes()).map(|(length, number)| (length, number.text()));
        let found = |length: usize, text: &str| Some((length, text.to_owned()));
        assert_eq!(length("  -5+007.5"), found(4, "-5"));
        assert_eq!(length("+007.5.1"), found(6, "7.5"));
        assert_eq!(length("5."), found(2, "5."));
        assert_eq!(length("123456789"), found(8, "12345678"));
        assert_eq!(length("- 1"), None);
        assert_eq!(length("."), None);
    }
}
