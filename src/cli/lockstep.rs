//! Both implementations side by side, compared event by event.

use std::collections::VecDeque;

use turnspec_oracle::vocabulary::{Ending, Event};

use super::Failure;
use super::machine::Machine;

/// Where two runs differ: the events that should be the same, or the end of one of the runs.
pub struct Mismatch {
    /// What the oracle says; `None` when its run has ended.
    pub oracle: Option<Event>,
    /// What the engine says; `None` when its run has ended.
    pub engine: Option<Event>,
}

/// Runs both to the end or to the first difference. Each event on which they agree goes to `accept`, in
/// order. They need not step alike: whichever has no event waiting takes the next step.
pub fn compare(
    oracle: impl Machine,
    engine: impl Machine,
    mut accept: impl FnMut(&Event) -> Result<(), Failure>,
) -> Result<Option<Mismatch>, Failure> {
    let (mut oracle, mut engine) = (Side::new(oracle), Side::new(engine));
    loop {
        match (oracle.next(), engine.next()) {
            (Some(one), Some(other)) if one == other => accept(&one)?,
            (None, None) if oracle.ending == engine.ending => return Ok(None),
            (oracle, engine) => return Ok(Some(Mismatch { oracle, engine })),
        }
    }
}

struct Side<M> {
    machine: M,
    waiting: VecDeque<Event>,
    ending: Option<Ending>,
}

impl<M: Machine> Side<M> {
    fn new(machine: M) -> Self {
        Self { machine, waiting: VecDeque::new(), ending: None }
    }

    fn next(&mut self) -> Option<Event> {
        while self.waiting.is_empty() && self.ending.is_none() {
            self.ending = self.machine.step(&mut |event| self.waiting.push_back(*event));
        }
        self.waiting.pop_front()
    }
}

#[cfg(test)]
mod tests {
    use turnspec_oracle::vocabulary::{Action, Ending, Event, Place, ReadingSet, RuleSet};

    use super::super::Failure;
    use super::super::machine::Machine;
    use super::{Mismatch, compare};

    /// Emits stops; each number is how many in one step.
    struct Stops(Vec<u64>, u64);

    impl Machine for Stops {
        fn step(&mut self, sink: &mut dyn FnMut(&Event)) -> Option<Ending> {
            if self.0.is_empty() {
                return Some(Ending::End);
            }
            for _ in 0..self.0.remove(0) {
                self.1 += 1;
                let (block, rules, readings) = (Place::default(), RuleSet::EMPTY, ReadingSet::default());
                sink(&Event::new(self.1, block, rules, readings, Action::Stop));
            }
            None
        }
    }

    fn both(oracle: &[u64], engine: &[u64]) -> (u64, Option<Mismatch>) {
        let mut agreed = 0;
        let outcome = compare(Stops(oracle.to_vec(), 0), Stops(engine.to_vec(), 0), |event| {
            agreed = event.n;
            Ok::<(), Failure>(())
        });
        (agreed, outcome.unwrap_or_default())
    }

    #[test]
    fn steps_of_different_length_agree_when_the_events_do() {
        assert!(matches!(both(&[1, 0, 2, 1], &[4]), (4, None)));
    }

    #[test]
    fn a_run_that_ends_early_is_a_mismatch() {
        let (agreed, mismatch) = both(&[2], &[1, 2]);
        assert_eq!(agreed, 2);
        assert!(mismatch.is_some_and(|found| found.oracle.is_none() && found.engine.is_some()));
    }
}
