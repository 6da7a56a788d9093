//! A schedule program carried out: its own blocks, and the programs that it selects (E100L-SDF-01 to -20).

use super::Progress;
use super::Spot;
use super::channel::Channel;
use super::texts::Read;
use crate::controls::e100l::g_codes::GGroup;
use crate::emission::Emission;
use crate::fault::{Fault, Outcome, fail};
use crate::modal;
use crate::quantity::round_narrow;
use crate::schedule::{self, Running, Schedule};
use crate::syntax::{Item, ScheduleBlock, Selection, parse_schedule};
use crate::task::{self, Calls, Registration};
use crate::vocabulary::rule_ids::*;
use crate::vocabulary::{Action, AlarmName, Label, Place, RuleId, RuleSet};

impl Channel<'_> {
    /// Whether the block that comes next is one of the schedule program.
    pub(super) fn in_schedule(&self) -> bool {
        self.schedule.as_ref().is_some_and(|schedule| schedule.running.is_none())
    }

    /// Carries out one block of the schedule program.
    pub(super) fn schedule_block(
        &mut self,
        place: &mut Place,
        decided: &mut Vec<(Place, Emission)>,
    ) -> Outcome<Progress> {
        let Some(schedule) = &mut self.schedule else { return Ok(Progress::Ended) };
        let Some(Read { start, line, behind }) = self.reader.programs.texts().read(schedule.next)? else {
            *place = self.reader.programs.texts().end(schedule.next);
            return fail(AlarmName::ScheduleEndMissing, SDF_20);
        };
        self.reader.step(line.place, place)?;
        let block = parse_schedule(&line, self.setup, &mut place.sequence)?;
        // E100L-SEQ-03: each name once.
        if schedule.block(place.sequence).is_some_and(|first| first < start) {
            return fail(AlarmName::SequenceNameDuplicate, SEQ_03);
        }
        schedule.next = behind;
        match block {
            ScheduleBlock::Empty => {}
            ScheduleBlock::Goto(name) => self.schedule_jump(name, GOTO_02)?,
            ScheduleBlock::If(condition, name) => {
                if self.holds(&condition)? {
                    self.schedule_jump(name, IFST_03)?;
                }
            }
            ScheduleBlock::Set(settings) => self.vset(&settings, *place, decided)?,
            ScheduleBlock::Select(selection) => self.select(&selection, start, *place, decided)?,
            ScheduleBlock::End => {
                let end = Action::End { code: Label::new("END") };
                let event = Emission::new(end, RuleSet::of(&[SDF_20]));
                decided.push((*place, event.of(self.state.side())));
                return Ok(Progress::Ended);
            }
        }
        Ok(Progress::Going)
    }

    /// E100L-SDF-15, E100L-SDF-16.
    fn schedule_jump(&mut self, name: Label, rule: RuleId) -> Outcome<()> {
        if let Some(schedule) = &mut self.schedule
            && let Some(block) = schedule.block(name)
        {
            schedule.next = block;
            return Ok(());
        }
        Err(Fault::about(AlarmName::SequenceNameUnknown, rule, name.as_str()))
    }

    /// E100L-SDF-17.
    fn vset(&mut self, settings: &[Item], place: Place, decided: &mut Vec<(Place, Emission)>) -> Outcome<()> {
        let mut emissions = Vec::new();
        let own = Registration::Change { program: 0 };
        let result = modal::evaluate(settings, own, &mut self.state, &mut emissions);
        self.state.base = None;
        for mut event in emissions {
            event.set_variable_by(RuleSet::of(&[SDF_17]));
            decided.push((place, event.of(self.state.side())));
        }
        result.map(|_| ())
    }

    /// E100L-SDF-06, E100L-SDF-13: the files are found before the number of repetitions is evaluated.
    fn select(
        &mut self,
        selection: &Selection,
        block: Spot,
        place: Place,
        decided: &mut Vec<(Place, Emission)>,
    ) -> Outcome<()> {
        let Some(schedule) = &mut self.schedule else { return Ok(()) };
        let selected = match schedule.found.get(&block) {
            Some(selected) => selected.clone(),
            None => {
                let selected = schedule::find(selection, &mut self.reader.programs, self.setup)?;
                schedule.found.insert(block, selected.clone());
                selected
            }
        };
        let number = match &selection.repetitions {
            Some(expression) => round_narrow(&task::evaluate(expression, &mut self.state)?.exact()),
            None => 1,
        };
        let Some(repetitions) = u16::try_from(number).ok().filter(|number| (1..=9999).contains(number))
        else {
            return fail(AlarmName::RepetitionsRange, SDF_13);
        };
        self.reader.programs.within = Some(selected.texts.clone());
        self.repeat(Running { selected, place, repetition: 1, repetitions }, decided);
        Ok(())
    }

    /// A repetition of a selected program begins.
    fn repeat(&mut self, running: Running, decided: &mut Vec<(Place, Emission)>) {
        let start = running.selected.start;
        let (place, event) = running.event();
        decided.push((place, event.of(self.state.side())));
        self.calls = Calls::selected(start);
        self.reader.go_to(start);
        if let Some(schedule) = &mut self.schedule {
            schedule.running = Some(running);
        }
    }

    /// E100L-SDF-14: what comes behind M02 or M30: nothing, the next repetition, or the next block of the schedule.
    pub(super) fn program_ended(&mut self, decided: &mut Vec<(Place, Emission)>) -> Progress {
        let Some(Schedule { running, .. }) = &mut self.schedule else { return Progress::Ended };
        self.state.memory.locals.keep();
        match running.take() {
            Some(last) if last.repetition < last.repetitions => {
                self.repeat(Running { repetition: last.repetition + 1, ..last }, decided);
            }
            _ => self.calls = Calls::new(self.reader.programs.texts().main_start()),
        }
        Progress::Going
    }

    /// E100L-SDF-14: what neither a modal call nor compensation means in the next program is told nowhere.
    pub(super) fn check_end_of_selected(&self) -> Outcome<()> {
        if self.schedule.is_none() {
            return Ok(());
        }
        if self.calls.modes.count() > 0 {
            return Err(Fault::about(AlarmName::Unspecified, SDF_14, "MODIN"));
        }
        if self.state.modes.compensating() {
            let code = Label::of_code(b'G', self.state.modes.get(GGroup::Compensation));
            return Err(Fault::about(AlarmName::Unspecified, SDF_14, code.as_str()));
        }
        Ok(())
    }
}
