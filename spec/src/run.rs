//! A run: block after block, each stage in turn, events numbered and placed.

mod ahead;
mod passes;
mod programs;
mod reading;
mod schedule;
mod statement;
mod texts;
mod view;

pub use programs::{Program, Programs};
pub use texts::{Read, Spot, Texts};
pub use view::{ActiveMode, ActiveProgram, LocalVariable};

use crate::compensation::{Compensation, Stream};
use crate::emission::Emission;
use crate::fault::Outcome;
use crate::modal::{self, Before, Plan};
use crate::path;
use crate::schedule::Schedule;
use crate::state::State;
use crate::task::{Calls, Registration};
use crate::thread;
use crate::vocabulary::{Action, Ending, Event, Place, Setup, Sink};
use passes::Cycle;
use reading::{Block, Content, Reader};
use statement::Carried;

/// A run of the oracle, block by block.
pub struct Run<'a> {
    reader: Reader<'a>,
    calls: Calls,
    state: State<'a>,
    compensation: Compensation,
    /// The schedule program, if the main text is one.
    schedule: Option<Schedule>,
    /// A compound thread cycle of which passes are left.
    cycle: Option<Box<Cycle>>,
    setup: &'a Setup,
    events: u64,
    ending: Option<Ending>,
}

/// What is to be carried out of a block.
enum Rest {
    /// All.
    All(Content),
    /// The passes that are left of a cycle, and what comes after them.
    Cycle(Box<Cycle>),
}

/// Whether a program goes on.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Progress {
    /// There is a next block.
    Going,
    /// M02 or M30 was carried out, or END of a schedule program.
    Ended,
}

impl<'a> Run<'a> {
    /// Prepares a run of a program on a valid set-up.
    #[must_use]
    pub fn new(program: &'a [u8], setup: &'a Setup) -> Self {
        let reader = Reader::new(program, setup);
        let texts = reader.programs.texts();
        let (start, schedule) = (texts.main_start(), texts.is_schedule(setup).then(|| Schedule::new(texts)));
        Self {
            reader,
            calls: Calls::new(start),
            schedule,
            state: State::new(setup),
            compensation: Compensation::Off,
            cycle: None,
            setup,
            events: 0,
            ending: None,
        }
    }

    /// Carries out the next block, be it empty or skipped, of a compound thread cycle the next pass; the events that are decided then go to the sink. `Some` when the run has ended.
    pub fn step(&mut self, sink: &mut impl Sink) -> Option<Ending> {
        if self.ending.is_some() {
            return self.ending;
        }
        let mut emissions = Vec::new();
        let mut place = Place::default();
        let result = self.block(&mut place, &mut emissions);
        for (place, emission) in emissions {
            self.send(place, emission, sink);
        }
        match result {
            Ok(Progress::Going) => {}
            Ok(Progress::Ended) => self.ending = Some(Ending::End),
            Err(fault) => {
                let alarm = Emission::new(Action::Alarm(fault.alarm), fault.rules).readings(fault.readings);
                self.send(fault.block.unwrap_or(place), alarm, sink);
                self.ending = Some(Ending::Alarm);
            }
        }
        self.ending
    }

    fn send(&mut self, block: Place, emission: Emission, sink: &mut impl Sink) {
        self.events += 1;
        let Emission { action, rules, readings, .. } = emission;
        sink.event(&Event { n: self.events, block, rules, readings, action });
    }

    /// Carries out one block, or a pass of it: the events that are decided then, in order, each with its place. The place of the
    /// block is set as soon as it is known.
    pub(crate) fn block(
        &mut self,
        place: &mut Place,
        decided: &mut Vec<(Place, Emission)>,
    ) -> Outcome<Progress> {
        if self.in_schedule() {
            return self.schedule_block(place, decided);
        }
        let cycle = self.cycle.take();
        let (block, rest) = match cycle {
            Some(cycle) => {
                self.reader.step(cycle.block.place, place)?;
                (cycle.block, Rest::Cycle(cycle))
            }
            None => {
                let Block { place, content, behind } = self.reader.arrive(self.calls.running_mut(), place)?;
                (Carried { place, behind }, Rest::All(content))
            }
        };
        let mut stream = self.compensation.stream(block.place, decided);
        let progress = match rest {
            Rest::Cycle(cycle) => self.pass(cycle, &mut stream),
            Rest::All(content) => self.carry_out(content, block, &mut stream),
        };
        stream.close();
        if progress? == Progress::Ended {
            return Ok(self.program_ended(decided));
        }
        self.modal_call(place, decided)?;
        Ok(Progress::Going)
    }

    fn carry_out(&mut self, content: Content, block: Carried, stream: &mut Stream) -> Outcome<Progress> {
        let words = match content {
            Content::Nothing | Content::Name => return Ok(Progress::Going),
            Content::Statement(statement) => {
                return self.statement(&statement, block, stream).map(|()| Progress::Going);
            }
            Content::Communication(statement) => {
                return self.communicate(&statement, stream).map(|()| Progress::Going);
            }
            Content::Words(words) => *words,
            Content::Items(items) => {
                let own = Registration::Change { program: self.calls.depth() };
                modal::evaluate(&items, own, &mut self.state, &mut stream.emissions)?
            }
        };
        let plan = modal::check(words, self.before(), &self.state)?;
        modal::before_motion(&plan, &mut self.state, &mut stream.emissions)?;
        if plan.words.assigns || plan.words.get('T').is_some() || plan.one_shot == Some(50) {
            // The frame may have changed: a corner of before means nothing now.
            self.state.base = None;
        }
        if plan.is_compound() {
            return self.compound(plan, block, stream);
        }
        let moved = self.motion(&plan, stream)?;
        self.after_motion(&plan, moved, block, stream)
    }

    /// What comes after the motion of a block.
    fn after_motion(
        &mut self,
        plan: &Plan,
        moved: bool,
        block: Carried,
        stream: &mut Stream,
    ) -> Outcome<Progress> {
        if modal::ends_program(plan) {
            self.compensation.end_of_program(stream, &self.state)?;
            self.check_end_of_selected()?;
        }
        if modal::after_motion(plan, self.schedule.is_some(), &mut self.state, &mut stream.emissions) {
            return Ok(Progress::Ended);
        }
        self.compensation.end_of_block(moved, stream, &self.state)?;
        if plan.triggers() {
            self.calls.trigger(block.place, block.behind);
        }
        Ok(Progress::Going)
    }

    fn before(&self) -> Before {
        Before {
            modes: self.state.modes,
            after_angle: self.state.angle_target.is_some(),
            left_over: self.compensation.is_left_over(),
            modal: self.calls.last_to_call() > 0,
        }
    }

    /// The motion of a block, or what it does instead; whether it has or computes X or Z.
    fn motion(&mut self, plan: &Plan, stream: &mut Stream) -> Outcome<bool> {
        let mut elements = Vec::new();
        let mut dwell = None;
        match plan.one_shot {
            Some(4) => {
                let number = plan.words.feed.clone().unwrap_or_default();
                dwell = Some(modal::dwell(&number, &self.state)?);
            }
            Some(22) => {
                // E100L-G34-05.
                self.state.thread.chain = false;
                path::torque_skip(plan, &mut self.state, &mut stream.emissions)?;
            }
            None if plan.is_thread() => thread::cut(plan, &mut self.state, &mut stream.emissions)?,
            _ if plan.moves => {
                let ahead = self.look_ahead(plan)?;
                elements = path::elements(plan, &ahead, &mut self.state)?;
            }
            _ => {}
        }
        self.compensation.motion(plan, &elements, dwell, stream, &mut self.state)
    }
}

/// Runs a whole program.
pub fn run(program: &[u8], setup: &Setup, sink: &mut impl Sink) -> Ending {
    let mut run = Run::new(program, setup);
    loop {
        if let Some(ending) = run.step(sink) {
            return ending;
        }
    }
}
