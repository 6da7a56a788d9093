//! Tool interference data (E100L-SVAR-14): stores that assignments write and expressions read.

use std::collections::BTreeMap;

use turnspec_oracle::vocabulary::Setup;

use crate::builder::Builder;
use crate::environment::Environment;
use crate::expression::{Expression, Variable};
use crate::number::Number;
use crate::program::{Item, Value};
use crate::unit::{Estimate, Units};

/// What a variable holds.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Holds {
    Whole,
    Angle,
    Length,
}

/// The variables: name, whether of a tool group, what they hold, lowest and highest value in thousandths or as a number.
pub(crate) const NAMES: &[(&str, bool, Holds, i64, i64)] = &[
    ("VTLIN", false, Holds::Whole, 1, 38),
    ("VGRIN", true, Holds::Whole, 1, 38),
    ("VTLFN", false, Holds::Whole, 0, 4),
    ("VGRFN", true, Holds::Whole, 0, 4),
    ("VTIPN", false, Holds::Whole, 0, 2),
    ("VTLA1", false, Holds::Angle, 0, 360_000),
    ("VGRA1", true, Holds::Angle, 0, 360_000),
    ("VTLA2", false, Holds::Angle, -360_000, 360_000),
    ("VGRA2", true, Holds::Angle, -360_000, 360_000),
    ("VTLL", false, Holds::Length, 0, 9_999_999),
    ("VGRL", true, Holds::Length, 0, 9_999_999),
    ("VTLD", false, Holds::Length, 0, 9_999_999),
    ("VGRD", true, Holds::Length, 0, 9_999_999),
    ("VTLW", false, Holds::Length, 0, 9_999_999),
    ("VGRW", true, Holds::Length, 0, 9_999_999),
    ("VTIZN", false, Holds::Length, 0, 9_999_999),
    ("VTIZP", false, Holds::Length, 0, 9_999_999),
    ("VTIXN", false, Holds::Length, 0, 9_999_999),
    ("VTIXP", false, Holds::Length, 0, 9_999_999),
];

/// What the variables hold, as expressions read them.
#[derive(Clone, Debug)]
pub(super) struct Stored {
    pub values: BTreeMap<(&'static str, u8), Estimate>,
}

impl Stored {
    pub fn new(setup: &Setup) -> Self {
        let units = Units::of(setup);
        let read = |(name, value): (&String, &turnspec_oracle::vocabulary::Length)| {
            let (variable, number) = name.strip_suffix(']')?.split_once('[')?;
            let (variable, _, holds, ..) = NAMES.iter().find(|(known, ..)| *known == variable)?;
            Some(((*variable, number.parse().ok()?), shown(units, *holds, value.0)))
        };
        Self { values: setup.system_variables.iter().filter_map(read).collect() }
    }
}

/// A value in nanometres, micro-degrees or millionths as expressions read it.
fn shown(units: Units, holds: Holds, value: i64) -> Estimate {
    match holds {
        Holds::Whole => Estimate::Integer(i32::try_from(value / 1_000_000).unwrap_or_default()),
        Holds::Angle => Environment::shown_angle(units, value),
        Holds::Length => Environment::shown_length(units, value),
    }
}

/// What a variable shows that was never written; none when the name is no such variable.
pub(crate) fn unset(name: &str, units: Units) -> Option<Estimate> {
    NAMES.iter().find(|(known, ..)| *known == name).map(|(_, _, holds, ..)| shown(units, *holds, 0))
}

impl Builder<'_, '_, '_> {
    /// A tool or a tool group that there is.
    fn tool_or_group(&mut self, group: bool) -> i64 {
        let options = &self.state.setup.options;
        let most = i64::from(if group { options.tool_groups } else { options.tools });
        if self.choices.chance(20) { most } else { self.choices.within(1, most.min(6)) }
    }

    /// A block that writes one of the variables, or two.
    pub(super) fn interference(&mut self) {
        self.begin();
        let mut items = Vec::new();
        for _ in 0..=self.choices.below(2) {
            items.push(self.interference_assignment());
            self.state.begin_block();
        }
        self.push(items);
    }

    /// An assignment to one of the variables.
    pub(crate) fn interference_assignment(&mut self) -> Item {
        let (name, group, holds, low, high) = self.choices.pick(NAMES);
        let number = self.tool_or_group(group);
        let (suffix, _) = self.suffix(number);
        let variable = Variable::Indexed(name, suffix);
        let wanted = match self.choices.below(5) {
            0 => low,
            1 => high,
            _ => self.choices.within(low, high),
        };
        let (item, value) = match holds {
            Holds::Length => {
                let most = if self.state.units.system.is_inch() { high - 10 } else { high };
                let wanted = wanted.clamp(low, most);
                self.assign_length(variable, wanted, wanted)
            }
            Holds::Angle => {
                let (value, written) = self.value(self.state.units.write_angle(wanted * 1_000));
                (Item::Assignment(variable, of_value(value)), self.state.units.angle(written))
            }
            Holds::Whole => {
                let aside = self.choices.pick(&[0, 0, 4, -4]);
                let number = Number::decimal(wanted * 10 + aside, 1);
                (Item::Assignment(variable, Expression::Constant(number)), wanted * 1_000_000)
            }
        };
        self.store(name, number, holds, value);
        item
    }

    /// A variable that holds a length, with this length in it.
    pub(super) fn stored_length(&mut self, length: i64) -> Variable {
        let name = self.choices.pick(&["VTLL", "VTLD", "VTLW", "VTIZP", "VTIXN"]);
        let number = self.tool_or_group(false);
        self.store(name, number, Holds::Length, length);
        Variable::Indexed(name, Box::new(Expression::Constant(Number::whole(number))))
    }

    fn store(&mut self, name: &'static str, number: i64, holds: Holds, value: i64) {
        let shown = shown(self.state.units, holds, value);
        self.state.io.stored.values.insert((name, u8::try_from(number).unwrap_or(1)), shown);
    }
}

/// The value of a word as an expression.
pub(super) fn of_value(value: Value) -> Expression {
    match value {
        Value::Expression(expression) => expression,
        Value::Plain(number) => Expression::Constant(number),
    }
}
