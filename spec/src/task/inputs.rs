//! Signals that a program reads (E100L-IOV-01, E100L-IOV-03 to -06, E100L-IORD-01): the set-up says what arrives.

use std::collections::BTreeMap;

use crate::vocabulary::Inputs;

/// The signals, each with a list of values of its own.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum Signal {
    /// VDIN.
    Input,
    /// VIRD.
    InputBit,
    /// VORD.
    OutputBit,
}

/// How many values of each signal were read.
#[derive(Clone, Debug, Default)]
pub struct Readings(BTreeMap<(Signal, usize), usize>);

impl Readings {
    /// The next value of a signal; the last one stays, a signal without values is 0.
    pub fn next(&mut self, signal: Signal, number: usize, inputs: &Inputs) -> i32 {
        let read = self.0.entry((signal, number)).or_default();
        let key = u16::try_from(number).unwrap_or(u16::MAX);
        let bit =
            |bits: &BTreeMap<u16, Vec<u8>>| bits.get(&key).and_then(|list| at(list, *read)).map(i32::from);
        let value = match signal {
            Signal::Input => inputs.vdin.get(&key).and_then(|list| at(list, *read)),
            Signal::InputBit => bit(&inputs.vird),
            Signal::OutputBit => bit(&inputs.vord),
        };
        *read = read.saturating_add(1);
        value.unwrap_or_default()
    }

    /// The next value of an input; a byte takes one of each of its bits (E100L-IOV-03).
    pub fn input(&mut self, number: usize, inputs: &Inputs) -> i32 {
        match number {
            9 | 19 | 39 => {
                (0..8).fold(0, |byte, bit| byte | self.next(Signal::Input, number - 8 + bit, inputs) << bit)
            }
            _ => self.next(Signal::Input, number, inputs),
        }
    }
}

fn at<T: Copy>(list: &[T], index: usize) -> Option<T> {
    list.get(index).or(list.last()).copied()
}
