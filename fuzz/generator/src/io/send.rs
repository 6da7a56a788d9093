//! PUT and WRITE.

use turnspec_oracle::vocabulary::Feature;

use super::AREA;
use crate::builder::Builder;
use crate::expression::Variable;
use crate::program::{Sent, Statement};
use crate::unit::Estimate;

/// A field for a number of which little is known.
const WIDE: usize = 48;

/// Variables that are sent with digits alone, or as the shortest decimal.
const PLAIN: &[&str] = &["VETON", "VETLN", "VRSTT", "VPAI", "VRUND", "VINPX", "VINPZ", "VINPC"];

impl Builder<'_, '_, '_> {
    /// A few PUT blocks, and WRITE mostly.
    pub(super) fn send(&mut self) {
        let steady = self.state.control.steady;
        if steady {
            self.write();
        }
        for _ in 0..=self.choices.below(4) {
            self.put();
        }
        if steady || self.state.io.written > AREA / 2 || self.choices.chance(55) {
            self.write();
        }
    }

    /// WRITE.
    pub(super) fn write(&mut self) {
        self.begin();
        let channel = self.choices.within(0, 9).min(self.choices.within(0, 9));
        self.statement(Statement::Write(channel), Vec::new());
        self.state.io.written = 0;
    }

    /// PUT of what still has room.
    fn put(&mut self) {
        self.begin();
        let room = AREA.saturating_sub(self.state.io.written);
        if room == 0 {
            return self.write();
        }
        let text = !self.state.is_eia();
        let values = self.allows(Feature::Variable) || self.allows(Feature::SystemVariable);
        let weight = |weight, holds: bool| if holds { weight } else { 0 };
        let list = [(weight(45, values), 0), (12, 1), (weight(28, text), 2), (weight(15, text), 3)];
        let (sent, length) = match self.choices.weighted(&list) {
            0 => self.field(room),
            2 => {
                let most = room.min(16);
                let text = self.text(most);
                let length = text.characters.len();
                (Sent::Text(text), length)
            }
            3 => {
                let codes = self.codes(room.min(16));
                let length = codes.len();
                (Sent::Codes(codes), length)
            }
            _ => self.blanks(room),
        };
        self.statement(Statement::Put(sent), Vec::new());
        self.state.io.written += length;
    }

    /// Blanks, now and then as many as fit.
    fn blanks(&mut self, room: usize) -> (Sent, usize) {
        let length = if self.choices.chance(6) { room } else { 1 + self.choices.below(room.min(12)) };
        (Sent::Blanks(length as i64), length)
    }

    /// The number of a variable in a field that it fits in.
    fn field(&mut self, room: usize) -> (Sent, usize) {
        let variable = self.sent_variable();
        let value = self.state.environment.value(&variable);
        let width = value.map_or(WIDE, |value| self.width(&variable, value));
        let length = (width + self.choices.pick(&[0, 0, 1, 3, 8])).min(room);
        if length < width {
            return self.blanks(room);
        }
        (Sent::Field(variable, length as i64), length)
    }

    /// A variable that can be sent.
    fn sent_variable(&mut self) -> Variable {
        let brackets = !self.state.is_eia() && self.allows(Feature::Expression);
        let system = self.allows(Feature::SystemVariable);
        let inputs = brackets
            && system
            && self.allows(Feature::InputOutput)
            && !self.state.environment.inputs.is_empty();
        let weight = |weight, holds: bool| if holds { weight } else { 0 };
        let environment = &self.state.environment;
        let list = [
            (weight(30, self.allows(Feature::Variable)), 0),
            (weight(12, self.allows(Feature::LocalVariable) && !environment.local.is_empty()), 1),
            (weight(34, system && brackets), 2),
            (weight(12, inputs), 3),
            (weight(12, system && brackets), 4),
            (1, 5),
        ];
        match self.choices.weighted(&list) {
            0 => environment.some_common(self.choices),
            1 => environment.some_local(self.choices),
            2 => environment.some_system(self.choices),
            3 => environment.some_input(self.choices),
            4 => environment.some_stored(self.choices),
            _ if system => Variable::System(self.choices.pick(&["VPAI", "VRUND"])),
            _ => Variable::Common(1),
        }
    }

    /// How wide a number is; with room for the last bits of one that is only estimated.
    fn width(&mut self, variable: &Variable, value: Estimate) -> usize {
        let decimals = usize::from(self.state.units.length_decimals());
        let (dimensional, angle) = match variable {
            Variable::System(name) => (!PLAIN.contains(name), name.ends_with('C')),
            Variable::Indexed(name, _) => (true, name.ends_with(['1', '2'])),
            _ => (false, false),
        };
        match value {
            Estimate::Integer(value) => value.to_string().len(),
            Estimate::Real(value) if dimensional => {
                let decimals = if angle { decimals.min(3) } else { decimals };
                format!("{value:.decimals$}").len()
            }
            Estimate::Real(value) => {
                let width = value.to_string().len();
                if width <= 8 && self.choices.chance(75) { width } else { width + 18 }
            }
        }
    }
}
