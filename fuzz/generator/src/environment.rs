//! What an expression can read: common and system variables at the beginning of a block.

use std::collections::{BTreeMap, BTreeSet};

use turnspec_oracle::vocabulary::{Feature, UnitSystem};

use crate::choices::Choices;
use crate::expression::{Expression, Variable};
use crate::io::{INTERFERENCE, unset};
use crate::number::Number;
use crate::profile::Profile;
use crate::unit::{Estimate, Units};

/// The variables as an expression sees them.
#[derive(Clone, Debug)]
pub struct Environment {
    /// Common variables that are not zero.
    pub common: BTreeMap<u8, f64>,
    /// Common variables whose value is not known.
    pub unknown: BTreeSet<u8>,
    /// Local variables whose value is known.
    pub local: BTreeMap<&'static str, f64>,
    /// Whether nothing is known that may be another thing when the block is carried out again.
    pub shared: bool,
    /// System variables without suffix.
    pub system: Vec<(&'static str, Estimate)>,
    /// Tool offsets in nanometres, X and Z.
    pub tool_offsets: BTreeMap<u8, [i64; 2]>,
    /// Inputs that always show the same: variable, number, value.
    pub inputs: Vec<(&'static str, u16, i32)>,
    /// Tool interference data that were written.
    pub stored: BTreeMap<(&'static str, u8), Estimate>,
    /// Number of tool offsets.
    pub offset_sets: u8,
    /// Whether boolean operators and functions may be used.
    pub user_task_2: bool,
    /// What expressions may need.
    profile: Profile,
    /// By what the angles of functions exceed degrees.
    pub function_angle: f64,
    /// Parts of 1 at which DROUND, DFIX and DFUP work.
    pub decimal_scale: f64,
    units: Units,
}

impl Environment {
    /// An environment in which nothing is known yet.
    #[must_use]
    pub fn new(units: Units, offset_sets: u8, user_task_2: bool) -> Self {
        let decimal_scale = match units.system {
            UnitSystem::Millimetre => 1_000.0,
            UnitSystem::Inch => 10_000.0,
            _ => 1.0,
        };
        Self {
            common: BTreeMap::new(),
            unknown: BTreeSet::new(),
            local: BTreeMap::new(),
            shared: false,
            system: Vec::new(),
            tool_offsets: BTreeMap::new(),
            inputs: Vec::new(),
            stored: BTreeMap::new(),
            offset_sets,
            user_task_2,
            profile: Profile::FULL,
            function_angle: units.function_angle(),
            decimal_scale,
            units,
        }
    }

    /// Keeps expressions within a profile.
    pub fn restrict(&mut self, profile: &Profile) {
        self.profile = *profile;
    }

    /// Whether expressions may need a feature.
    #[must_use]
    pub fn allows(&self, feature: Feature) -> bool {
        let task_2 = matches!(feature, Feature::Boolean | Feature::Function);
        self.profile.allows(feature) && (self.user_task_2 || !task_2)
    }

    /// A length in nanometres as a system variable shows it (E100L-TYPE-13).
    #[must_use]
    pub fn shown_length(units: Units, length: i64) -> Estimate {
        match units.system {
            UnitSystem::Micrometre => whole(length, 1_000),
            _ => Estimate::Real(length as f64 / units.length_unit() as f64),
        }
    }

    /// An angle in micro-degrees as a system variable shows it.
    #[must_use]
    pub fn shown_angle(units: Units, angle: i64) -> Estimate {
        match units.angle_unit() {
            1_000 => whole(angle, 1_000),
            unit => Estimate::Real(angle as f64 / unit as f64),
        }
    }

    /// The value of a variable; none when reading it raises an alarm or is not known.
    #[must_use]
    pub fn value(&self, variable: &Variable) -> Option<Estimate> {
        match variable {
            Variable::Indexed(name @ ("VDIN" | "VIRD" | "VORD"), suffix) => {
                let number = suffix.estimate(self)?.to_f64().round();
                let input =
                    self.inputs.iter().find(|(known, place, _)| known == name && f64::from(*place) == number);
                input.map(|(.., value)| Estimate::Integer(*value))
            }
            Variable::Common(_) | Variable::Indexed(..) if self.shared => None,
            Variable::Common(number) if self.unknown.contains(number) => None,
            Variable::Local(name) => self.local.get(name).copied().map(Estimate::Real),
            Variable::Common(number) => {
                Some(Estimate::Real(self.common.get(number).copied().unwrap_or_default()))
            }
            Variable::System(name) => {
                self.system.iter().find(|(known, _)| known == name).map(|(_, value)| *value)
            }
            Variable::Indexed(name, suffix) => {
                let number = u8::try_from(suffix.estimate(self)?.to_f64().round() as i64).ok()?;
                if let Some(unset) = unset(name, self.units) {
                    return Some(self.stored.get(&(*name, number)).copied().unwrap_or(unset));
                }
                let axis = match *name {
                    "VTOFX" => 0,
                    "VTOFZ" => 1,
                    _ => return None,
                };
                let amounts = self.tool_offsets.get(&number).copied().unwrap_or_default();
                (number <= self.offset_sets).then(|| Self::shown_length(self.units, amounts[axis]))
            }
        }
    }

    /// A common variable, usually one that was assigned.
    pub fn some_common(&self, choices: &mut Choices<'_, '_>) -> Variable {
        let known: Vec<u8> = self.common.keys().copied().collect();
        if known.is_empty() || choices.chance(15) {
            return Variable::Common(choices.within(1, 200) as u8);
        }
        Variable::Common(choices.pick(&known))
    }

    /// A local variable whose value is known; a common one when there is none.
    pub fn some_local(&self, choices: &mut Choices<'_, '_>) -> Variable {
        let known: Vec<&str> = self.local.keys().copied().collect();
        if known.is_empty() { self.some_common(choices) } else { Variable::Local(choices.pick(&known)) }
    }

    /// An input that always shows the same; a common variable when there is none.
    pub fn some_input(&self, choices: &mut Choices<'_, '_>) -> Variable {
        if self.inputs.is_empty() {
            return self.some_common(choices);
        }
        let (name, number, _) = choices.pick(&self.inputs);
        Variable::Indexed(name, Box::new(Expression::Constant(Number::whole(number.into()))))
    }

    /// A variable of the tool interference data, often one that was written.
    pub fn some_stored(&self, choices: &mut Choices<'_, '_>) -> Variable {
        let written: Vec<_> = self.stored.keys().copied().collect();
        let (name, number) = if written.is_empty() || choices.chance(25) {
            (choices.pick(INTERFERENCE).0, choices.within(1, 12) as u8)
        } else {
            choices.pick(&written)
        };
        Variable::Indexed(name, Box::new(Expression::Constant(Number::whole(number.into()))))
    }

    /// A system variable whose value is known.
    pub fn some_system(&self, choices: &mut Choices<'_, '_>) -> Variable {
        if self.system.is_empty() || choices.chance(15) {
            let number = choices.within(0, self.offset_sets.into());
            let suffix = Expression::Constant(Number::whole(number));
            return Variable::Indexed(choices.pick(&["VTOFX", "VTOFZ"]), Box::new(suffix));
        }
        Variable::System(self.system[choices.below(self.system.len())].0)
    }
}

fn whole(value: i64, unit: i64) -> Estimate {
    Estimate::Integer(i32::try_from((value as f64 / unit as f64).round() as i64).unwrap_or_default())
}
