//! GOTO and IF: where the run goes on (E100L-GOTO-01 to E100L-GOTO-03, E100L-IFST-03), and which sequence
//! names are used twice (E100L-SEQ-03).

use turnspec_oracle::vocabulary::{AlarmName, Label, RuleId};

use crate::engine::Interpreter;
use crate::engine::fault::Fault;
use crate::engine::names::Names;
use crate::engine::planted::{self, Bug};

use super::head;
use super::labels::{Bound, Labels};
use super::{Activation, Activity};

impl Interpreter<'_> {
    /// Goes on with the block of the present program that has a name.
    pub(super) fn jump(&mut self, name: Label, rule: RuleId) -> Result<(), Fault> {
        let here = self.reader.mark();
        let number = head::number(name.as_str().as_bytes().get(1..).unwrap_or_default());
        let Some(target) = self.labels().and_then(|labels| labels.find(number)) else {
            return Err(Fault::about(AlarmName::SequenceNameUnknown, rule, name));
        };
        if target.at < here.at {
            let until = &mut self.task.present.kept_until;
            *until = (*until).max(here.at);
        }
        self.reader.seek(target);
        if planted::is(Bug::JumpBehindTarget) {
            self.reader.next_lines();
        }
        Ok(())
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
