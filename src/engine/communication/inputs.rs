//! Input variables VDIN, VIRD and VORD (E100L-IOV-01, E100L-IOV-03, E100L-IORD-01).

use std::collections::BTreeMap;

use crate::engine::Interpreter;
use crate::engine::system::SystemVariable;

/// How many values of each list of the set-up were read, by number or address.
#[derive(Debug, Default)]
pub struct Taken {
    vdin: BTreeMap<u16, usize>,
    vird: BTreeMap<u16, usize>,
    vord: BTreeMap<u16, usize>,
}

/// Whether VDIN has a number.
pub fn input_exists(number: usize) -> bool {
    matches!(number, 1..=19 | 21..=24 | 31..=39 | 1000..=1004 | 1235..=1250)
}

impl Interpreter<'_> {
    /// The next value of an input.
    pub(in crate::engine) fn read_input(&mut self, variable: SystemVariable, number: usize) -> i32 {
        let number = u16::try_from(number).unwrap_or_default();
        let (inputs, taken) = (&self.setup.inputs, &mut self.communication.taken);
        match (variable, number) {
            (SystemVariable::InputBit, _) => next(&inputs.vird, &mut taken.vird, number),
            (SystemVariable::OutputBit, _) => next(&inputs.vord, &mut taken.vord, number),
            (_, 9 | 19 | 39) => {
                let first = number - 8;
                (first..number)
                    .fold(0, |byte, bit| byte | next(&inputs.vdin, &mut taken.vdin, bit) << (bit - first))
            }
            // VDIN[10] (E100L-IOV-04), timers (E100L-IOV-05) and specification codes (E100L-IOV-06) are numbers,
            // those of the set-up, which sees to their ranges.
            _ => next(&inputs.vdin, &mut taken.vdin, number),
        }
    }
}

/// The next value of a list; the last one stays, and without a list it is 0.
fn next<T: Copy + Into<i32>>(
    lists: &BTreeMap<u16, Vec<T>>,
    taken: &mut BTreeMap<u16, usize>,
    number: u16,
) -> i32 {
    let Some(list) = lists.get(&number) else { return 0 };
    let place = taken.entry(number).or_default();
    let value = list.get(*place).or(list.last()).copied();
    *place = list.len().min(*place + 1);
    value.map_or(0, T::into)
}
