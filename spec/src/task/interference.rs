//! Tool interference data (E100L-SVAR-14): stores that nothing else reads.

use std::collections::BTreeMap;

use super::number::Number;
use super::read::Amount;
use crate::controls::e100l::system_variables::Measure;
use crate::vocabulary::Setup;

/// The data that are not zero, by name and number: in nanometres, micro-degrees, or millionths of a plain number.
#[derive(Clone, Debug)]
pub struct Interference(BTreeMap<(String, usize), i64>);

/// What a plain number is counted in.
const PLAIN: i64 = 1_000_000;

impl Interference {
    /// The data of a set-up.
    pub fn new(setup: &Setup) -> Self {
        let known = setup.system_variables.iter().filter_map(|(variable, value)| {
            let (name, number) = variable.strip_suffix(']')?.split_once('[')?;
            Some(((name.to_owned(), number.parse().ok()?), value.0))
        });
        Self(known.collect())
    }

    /// What a variable holds.
    pub fn get(&self, name: &str, number: usize, measure: Measure) -> Amount {
        let value = self.0.get(&(name.to_owned(), number)).copied().unwrap_or_default();
        match measure {
            Measure::Plain => {
                Amount::Number(Number::Integer(i32::try_from(value / PLAIN).unwrap_or_default()))
            }
            Measure::Length => Amount::Length(value),
            Measure::Angle => Amount::Angle(value),
        }
    }

    /// Sets a variable to a number of increments.
    pub fn set(&mut self, name: &str, number: usize, measure: Measure, increments: i64) {
        let increment = if measure == Measure::Plain { PLAIN } else { 1_000 };
        self.0.insert((name.to_owned(), number), increments * increment);
    }
}
