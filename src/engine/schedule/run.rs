//! Running selected programs (E100L-SDF-13, E100L-SDF-14), and the end of the schedule (E100L-SDF-20).

use turnspec_oracle::vocabulary::rule_ids::*;
use turnspec_oracle::vocabulary::{Action, AlarmName, Ending, Label, RuleSet, Sink};

use crate::engine::Interpreter;
use crate::engine::arithmetic::round::Rounding;
use crate::engine::fault::Fault;
use crate::engine::words::{Code, Parsed};

use super::{Running, Selecting};

/// Most repetitions of a program.
const MOST: i64 = 9999;

impl Interpreter<'_> {
    /// PSELECT.
    pub(in crate::engine) fn select(
        &mut self,
        parsed: &Parsed,
        selecting: Selecting,
        sink: &mut impl Sink,
    ) -> Result<(), Fault> {
        let start = self.place.start;
        let selection = match self.schedule.selections.get(&start) {
            Some(selection) => *selection,
            None => {
                let selection = self.find_selection(parsed, selecting)?;
                self.schedule.remember(start, selection);
                selection
            }
        };
        let last = self.repetitions(parsed, selecting.repetitions)?;
        let (schedule, back) = (self.task.present, self.reader.mark());
        let running = Running { selection, place: self.place, repetition: 1, last, schedule, back };
        self.begin_selected(running, sink);
        Ok(())
    }

    /// How often the program runs.
    fn repetitions(&mut self, parsed: &Parsed, code: Option<Code>) -> Result<u16, Fault> {
        let Some(code) = code else { return Ok(1) };
        let number = self.compute(parsed, code)?.number();
        // A value that rounds into the range lies within half a unit of it.
        let value = if number.within(2, 1, 2 * MOST + 1) { number.whole(1, Rounding::HalfAway) } else { 0 };
        match u16::try_from(value) {
            Ok(value) if (1..=MOST).contains(&value.into()) => Ok(value),
            _ => Fault::raise(AlarmName::RepetitionsRange, SDF_13),
        }
    }

    /// One repetition of the selected program, from its first block on.
    fn begin_selected(&mut self, running: Running, sink: &mut impl Sink) {
        let program = running.selection.program;
        let (file, repetition) = (running.selection.file, running.repetition);
        self.place = running.place;
        let action = Action::Select { file, name: program.name, repetition };
        self.emit(sink, const { RuleSet::of(&[SDF_06, SDF_14]) }, action);
        // Its name is in force from its name block on, as that of a main program.
        self.task.present = program;
        self.task.present.name = Label::default();
        if repetition > 1 {
            self.task.present.keep_all();
        }
        self.reader.turn_to(self.task.text(program.text), program.start);
        self.schedule.running = Some(running);
    }

    /// M02 or M30 of a selected program, after its motion: no reset, and the next repetition or the schedule
    /// goes on.
    pub(in crate::engine) fn end_selected(&mut self, code: u16, sink: &mut impl Sink) -> Result<(), Fault> {
        let force = |what| Err(Fault::about(AlarmName::Unspecified, SDF_14, what));
        if self.task.has_modes() {
            return force(const { Label::new("MODIN") });
        }
        if self.state.compensation != 40 {
            return force(Label::of_code(b'G', self.state.compensation));
        }
        let action = Action::End { code: Label::of_code(b'M', code) };
        self.emit(sink, const { RuleSet::of(&[MCODE_04, SDF_14]) }, action);
        let Some(running) = self.schedule.running.take() else { return Ok(()) };
        self.task.leave_program();
        // What was looked at beyond the end does not come any more.
        self.ahead_count = 0;
        self.state.angle_target = None;
        if running.repetition < running.last {
            let repetition = running.repetition + 1;
            self.begin_selected(Running { repetition, ..running }, sink);
        } else {
            self.task.present = running.schedule;
            self.reader.turn_to(self.task.text(running.schedule.text), running.back);
        }
        Ok(())
    }

    /// END.
    pub(in crate::engine) fn end_schedule(&mut self, sink: &mut impl Sink) -> Ending {
        let code = const { Label::new("END") };
        self.emit(sink, const { RuleSet::of(&[SDF_20]) }, Action::End { code });
        Ending::End
    }
}
