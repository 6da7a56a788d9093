//! GOTO and IF: where the run goes on (E100L-GOTO-01 to E100L-GOTO-03, E100L-IFST-03), and which sequence
//! names are used twice (E100L-SEQ-03).

use turnspec_oracle::vocabulary::{AlarmName, Label, RuleId};

use crate::engine::Interpreter;
use crate::engine::fault::Fault;
use crate::engine::names::Names;
use crate::engine::planted::{self, Bug};

use crate::engine::text::Mark;

use super::head;
use super::labels::{Bound, Labels};
use super::{Activation, Activity};

impl Interpreter<'_> {
    /// Goes on with the block of the present program that has a name.
    pub(super) fn jump(&mut self, name: Label, rule: RuleId) -> Result<(), Fault> {
        let Some(target) = self.labels().and_then(|labels| labels.find(number_of(name))) else {
            return Err(Fault::about(AlarmName::SequenceNameUnknown, rule, name));
        };
        self.go_to(target);
        if planted::is(Bug::JumpBehindTarget) {
            self.reader.next_lines();
        }
        Ok(())
    }

    /// Goes on with a block of the present program; what is run again is kept.
    pub(in crate::engine) fn go_to(&mut self, target: Mark) {
        let here = self.reader.mark();
        if target.at < here.at {
            let until = &mut self.task.present.kept_until;
            *until = (*until).max(here.at);
        }
        self.reader.seek(target);
    }

    /// The first block of the present program with a name, whose names are known.
    pub(in crate::engine) fn block_named(&self, name: Label) -> Option<Mark> {
        let labels = self.task.labels.get(self.task.present.labels)?.as_ref()?;
        labels.find(number_of(name))
    }

    /// Makes the names of the present program known.
    pub(in crate::engine) fn index_present(&mut self) {
        self.labels();
    }

    /// Whether a block that the run has come to is the first of its program with its sequence name.
    #[inline]
    pub(in crate::engine) fn is_first_with(&mut self, name: &[u8], start: usize) -> bool {
        // As long as the main program has gone straight on, every name behind was met.
        if self.task.present.is_open() && !matches!(self.task.labels.first(), Some(Some(_))) {
            return self.names.insert(name);
        }
        let first = self.labels().and_then(|labels| labels.find(head::number(name)));
        first.is_none_or(|first| first.at >= start)
    }

    /// The sequence names of the present program.
    fn labels(&mut self) -> Option<&Labels> {
        let place = self.task.present.labels;
        if !matches!(self.task.labels.get(place), Some(Some(_))) {
            self.index_names(place);
        }
        self.task.labels.get(place)?.as_ref()
    }

    #[cold]
    fn index_names(&mut self, place: usize) {
        let Activation { kind, start, end, .. } = self.task.present;
        let mut reader = self.reader.clone();
        reader.seek(start);
        let bound = match kind {
            Activity::Main => Bound::NextName(self.task.own_name),
            _ => Bound::Offset(end),
        };
        let block_delete = self.options.block_delete && kind != Activity::Schedule;
        let labels = Labels::new(reader, bound, block_delete);
        let all = &mut self.task.labels;
        if all.len() <= place {
            all.resize_with(place + 1, || None);
        }
        if let Some(slot) = all.get_mut(place) {
            *slot = Some(labels);
        }
        if place == 0 {
            self.names = Names::default();
        }
    }
}

/// The number of a sequence name with its `N`.
fn number_of(name: Label) -> u32 {
    head::number(name.as_str().as_bytes().get(1..).unwrap_or_default())
}
