//! The fast interpreter of the E100L: the same semantics as the reference, written for speed.
//!
//! It shares with the reference only the vocabulary. A program is read block by block and never held as a
//! whole; memory grows with the number of distinct sequence names alone, and a bounded number of parsed
//! blocks is kept where blocks are run again (module `task`). Coordinates are exact integers; what leaves the
//! rationals is rounded for certain (module `exact`).

mod ahead;
mod angle;
mod arc;
pub mod arithmetic;
mod assignment;
mod barriers;
mod block;
mod carry;
mod chamfer;
mod cite;
pub mod codes;
mod communication;
mod compensation;
mod contour;
mod cycle;
mod evaluate;
mod exact;
mod expression;
mod fault;
mod functions;
mod items;
mod lap;
mod miscellaneous;
mod motion;
mod names;
mod number;
mod parse;
mod plain;
#[cfg(not(feature = "planted-bugs"))]
mod planted;
#[cfg(feature = "planted-bugs")]
pub mod planted;
mod schedule;
mod sides;
mod slot;
mod spindle;
mod state;
mod system;
mod task;
mod text;
mod thread;
mod tool_data;
mod torque;
mod variables;
mod words;

use turnspec_oracle::vocabulary::{
    Action, Alarm, AlarmName, Ending, Event, MachineType, Place, Reading, ReadingSet, Readings, RuleSet,
    Setup, Sink,
};

pub use exact::SlowPaths;
pub use task::{Holder, Level, Local, Mode, Situation};

use arithmetic::units::Units;
use cite::CiteCache;
use communication::Communication;
use compensation::Compensation;
use fault::Fault;
use functions::Scales;
use lap::Lap;
use names::Names;
use parse::Options;
use planted::Bug;
use schedule::Schedule;
use sides::{Saddles, SideRun};
use slot::Slot;
use state::State;
use task::{Task, Turn};
use text::Reader;
use words::Operand;

/// A run of the engine, block by block.
pub struct Interpreter<'a> {
    setup: &'a Setup,
    units: Units,
    scales: Scales,
    options: Options,
    known: Known,
    reader: Reader<'a>,
    /// Sequence names of the main program, as long as it goes straight on.
    names: Names,
    /// Whether a block was read, so that a program name comes too late.
    begun: bool,
    /// Blocks that were read before their turn, at most two, and room for another one.
    ahead: [Box<Slot>; 2],
    ahead_count: usize,
    spare: Option<Box<Slot>>,
    /// The block in progress; taken out while it is carried out.
    current: Option<Box<Slot>>,
    /// Place of the block in progress.
    place: Place,
    /// Place of a fault that is not that of the block in progress.
    fault_place: Option<Place>,
    /// Whether the block in progress has a length word in inches.
    inch_block: bool,
    state: State,
    task: Task<'a>,
    compensation: Compensation,
    communication: Communication<'a>,
    schedule: Schedule,
    lap: Lap,
    /// What makes this run that of one of two saddles.
    side: Option<Box<SideRun>>,
    /// The runs of both saddles, of which this run is the whole.
    saddles: Option<Box<Saddles<'a>>>,
    ordinal: u64,
    ending: Option<Ending>,
    cites: CiteCache,
    slow: SlowPaths,
    buffer: Vec<u8>,
    stack: Vec<Operand>,
}

/// The readings of the set-up as sets of one.
struct Known {
    inch: ReadingSet,
    arc: ReadingSet,
    leg: ReadingSet,
    after_chamfer: ReadingSet,
    feed_length: ReadingSet,
    tool_offset: ReadingSet,
    barrier_path: ReadingSet,
    clamp: ReadingSet,
    put_real: ReadingSet,
    user_alarm_c: ReadingSet,
    taper: ReadingSet,
    thread_shift: ReadingSet,
    flank: ReadingSet,
    balanced: ReadingSet,
    peck_retract: ReadingSet,
    chip_discharge: ReadingSet,
    keyway_return: ReadingSet,
    contour_feed: ReadingSet,
}

impl Known {
    fn new(readings: &Readings) -> Self {
        fn one(reading: impl Into<Reading>) -> ReadingSet {
            ReadingSet::default().with(reading)
        }
        Self {
            inch: one(readings.inch_conversion),
            arc: one(readings.arc_one_coordinate),
            leg: one(readings.chamfer_leg),
            after_chamfer: one(readings.incremental_after_chamfer),
            feed_length: one(readings.feed_length),
            tool_offset: one(readings.tool_offset),
            barrier_path: one(readings.barrier_path),
            clamp: one(readings.speed_clamp),
            put_real: one(readings.put_real),
            user_alarm_c: one(readings.user_alarm_c),
            taper: one(readings.taper_reference),
            thread_shift: one(readings.thread_shift),
            flank: one(readings.thread_flank),
            balanced: one(readings.balanced_infeed),
            peck_retract: one(readings.peck_retract),
            chip_discharge: one(readings.chip_discharge),
            keyway_return: one(readings.keyway_return),
            contour_feed: one(readings.contour_feed),
        }
    }
}

impl<'a> Interpreter<'a> {
    /// Prepares a run of a program on a valid set-up.
    #[must_use]
    pub fn new(program: &'a [u8], setup: &'a Setup) -> Self {
        if setup.machine.r#type == MachineType::TwoSaddles {
            let saddles = Some(Box::new(Saddles::new(program, setup)));
            return Self { saddles, ..Self::one(program, setup) };
        }
        Self::single(program, setup)
    }

    /// The run of a whole text that is not divided.
    fn single(program: &'a [u8], setup: &'a Setup) -> Self {
        let mut interpreter = Self::one(program, setup);
        if setup.schedule && !interpreter.reader.has_header() {
            interpreter.begin_schedule();
        }
        interpreter
    }

    /// The run of one saddle.
    fn one(program: &'a [u8], setup: &'a Setup) -> Self {
        Self {
            setup,
            units: Units::new(setup.unit_system),
            scales: Scales::new(setup),
            options: Options::new(setup),
            known: Known::new(&setup.readings),
            reader: Reader::new(program, setup.tape.code),
            names: Names::default(),
            begun: false,
            ahead: [Box::default(), Box::default()],
            ahead_count: 0,
            spare: None,
            current: None,
            place: Place::default(),
            fault_place: None,
            inch_block: false,
            state: State::new(setup),
            task: Task::new(program, setup.limits.steps),
            compensation: Compensation::default(),
            communication: Communication::default(),
            schedule: Schedule::default(),
            lap: Lap::default(),
            side: None,
            saddles: None,
            ordinal: 0,
            ending: None,
            cites: CiteCache::default(),
            slow: SlowPaths::default(),
            buffer: Vec::new(),
            stack: Vec::new(),
        }
    }

    /// Carries out the next block; its events go to the sink. `Some` when the run has ended.
    pub fn step(&mut self, sink: &mut impl Sink) -> Option<Ending> {
        if self.ending.is_some() {
            return self.ending;
        }
        if let Some(saddles) = &mut self.saddles {
            self.ending = saddles.step(sink);
            return self.ending;
        }
        let mut slot = self.current.take().unwrap_or_default();
        let result = self.next_block(&mut slot, sink);
        self.current = Some(slot);
        match result {
            Ok(ending) => self.ending = ending,
            Err(fault) => self.ending = Some(self.fail(fault, sink)),
        }
        self.ending
    }

    /// Raises an alarm, which ends the run.
    fn fail(&mut self, fault: Fault, sink: &mut impl Sink) -> Ending {
        if let Some(place) = self.fault_place {
            self.place = place;
        }
        self.compensation.drop_held();
        let alarm = Alarm::about(fault.name, fault.detail);
        let reading = match fault.name {
            AlarmName::UserAlarmC => self.known.user_alarm_c,
            _ => ReadingSet::default(),
        };
        self.emit_with(sink, RuleSet::of(&[fault.rule]), reading, Action::Alarm(alarm));
        Ending::Alarm
    }

    /// How often exact integers had to decide because `f64` left a result in doubt.
    #[must_use]
    pub fn slow_paths(&self) -> SlowPaths {
        self.saddles.as_ref().map_or(self.slow, |saddles| saddles.slow_paths())
    }

    fn next_block(&mut self, slot: &mut Box<Slot>, sink: &mut impl Sink) -> Result<Option<Ending>, Fault> {
        if self.side.is_some() && self.resume(slot, sink)? {
            return Ok(None);
        }
        if self.lap.is_active() {
            return self.next_block_of_definition(slot, sink);
        }
        if self.compensation.acts() {
            self.compensation.begin_block();
        }
        if self.ahead_count > 0 {
            std::mem::swap(slot, &mut self.ahead[0]);
            self.ahead.swap(0, 1);
            self.ahead_count -= 1;
            self.place = slot.place;
            self.note_block(slot);
            self.count_passed(slot)?;
            self.check_common(&slot.words)?;
            if !planted::is(Bug::NextInchStale) {
                self.inch_block = slot.parsed.has_length && self.units.inch;
            }
        } else {
            let found = self.read(slot, Turn::Now);
            self.place = slot.place;
            if self.side.is_some() {
                if found.as_ref().is_ok_and(|found| !found) {
                    return self.run_out(sink).map(|()| None);
                }
                self.note_block(slot);
            }
            if !found? {
                return Err(self.end_missing());
            }
            if let Some(control) = slot.parsed.control {
                return self.carry_out_statement(&slot.parsed, control, sink);
            }
            if self.is_turret_block(&slot.parsed) {
                self.select_turret(&slot.parsed, sink)?;
                return self.finish_turret_block(sink).map(|()| None);
            }
            self.inch_block = slot.parsed.has_length && self.units.inch;
            self.evaluate(slot, sink)?;
            if self.side.is_some() && self.stop_at_p(&slot.words, sink)? {
                return Ok(None);
            }
        }
        self.carry_out(slot, sink)
    }

    /// Hands an event of the block in progress to the sink.
    fn emit(&mut self, sink: &mut impl Sink, rules: RuleSet, action: Action) {
        self.emit_with(sink, rules, ReadingSet::default(), action);
    }

    #[inline(always)]
    fn emit_with(&mut self, sink: &mut impl Sink, rules: RuleSet, readings: ReadingSet, action: Action) {
        let mut event = Event::new(self.ordinal + 1, self.place, rules, readings, action);
        self.name_side(&mut event);
        self.hand_over(sink, event);
    }

    /// Hands an event to the sink, or holds it.
    #[inline(always)]
    fn hand_over(&mut self, sink: &mut impl Sink, event: Event) {
        if self.compensation.holds() | self.lap.observes() {
            return self.hand_over_apart(sink, event);
        }
        self.ordinal = event.n;
        sink.event(&event);
    }
}

impl Interpreter<'_> {
    /// Holds an event, or takes note of it.
    #[cold]
    fn hand_over_apart(&mut self, sink: &mut impl Sink, event: Event) {
        if self.lap.observes() {
            return self.observe(sink, event);
        }
        self.compensation.hold(&event);
    }
}

/// Runs a whole program.
pub fn run(program: &[u8], setup: &Setup, sink: &mut impl Sink) -> Ending {
    let mut interpreter = Interpreter::new(program, setup);
    loop {
        if let Some(ending) = interpreter.step(sink) {
            return ending;
        }
    }
}

/// Number of blocks that the grammar accepts, up to the first fault or the end of the text. Nothing is
/// evaluated or carried out.
#[must_use]
pub fn count_blocks(program: &[u8], setup: &Setup) -> u64 {
    let mut interpreter = Interpreter::single(program, setup);
    interpreter.task.count_no_steps();
    let mut slot = Slot::default();
    let mut blocks = 0;
    while let Ok(true) = interpreter.read(&mut slot, Turn::Now) {
        blocks += 1;
    }
    blocks
}

#[cfg(test)]
mod tests;
