//! Two saddles: in which order the two side programs run, and where they wait for each other (execution of two
//! saddles, "The order of the sides").

use turnspec_oracle::vocabulary::rule_ids::*;
use turnspec_oracle::vocabulary::{
    Action, AlarmName, Ending, Label, Place, ReleaseCause, RuleId, RuleSet, Setup, Side, Sink,
};

use crate::engine::fault::Fault;
use crate::engine::names::Names;
use crate::engine::planted::{self, Bug};
use crate::engine::slot::Slot;
use crate::engine::state::{State, X};
use crate::engine::task::Turn;
use crate::engine::{Interpreter, SlowPaths};

use super::sections::Sections;
use super::side::{Common, CommonWords, SideRun, Status, Stop};

/// The places of the sides.
const A: usize = 0;
const B: usize = 1;

/// The two sides of a run.
pub struct Saddles<'a> {
    sides: [Interpreter<'a>; 2],
    begun: bool,
    /// The side that has run last.
    running: usize,
    /// The side whose waiting block comes next, of two that were released together.
    pair: Option<usize>,
    /// The side that has ended last, and the one that ended last with M02 or M30.
    ended: usize,
    ended_by_code: Option<usize>,
    /// The end of the text.
    end: Place,
}

impl<'a> Saddles<'a> {
    /// Prepares the run of a program on a machine with two saddles.
    pub fn new(program: &'a [u8], setup: &'a Setup) -> Self {
        let side = |side| {
            let mut interpreter = Interpreter::one(program, setup);
            interpreter.state = State::of_side(setup, side);
            interpreter.side = Some(Box::default());
            interpreter
        };
        let (mut a, mut b) = (side(Side::A), side(Side::B));
        (a.state.other_x, b.state.other_x) = (b.state.program(X), a.state.program(X));
        Self {
            sides: [a, b],
            begun: false,
            running: A,
            pair: None,
            ended: A,
            ended_by_code: None,
            end: Place::default(),
        }
    }

    /// Carries out the next block of either side, or lets the sides go on.
    pub fn step(&mut self, sink: &mut impl Sink) -> Option<Ending> {
        if !self.begun {
            self.begun = true;
            if let Err(fault) = self.begin() {
                return Some(self.sides[A].fail(fault, sink));
            }
        }
        loop {
            if let Some(side) = self.pair.take() {
                return self.run_waiting(side, sink);
            }
            match [A, B].into_iter().find(|side| self.status(*side) == Status::Ready) {
                Some(side) => return self.run(side, sink),
                None if [A, B].iter().all(|side| self.status(*side) == Status::Ended) => {
                    return Some(self.finish(sink));
                }
                None => {
                    if let Err((side, fault)) = self.release(sink) {
                        return Some(self.sides[side].fail(fault, sink));
                    }
                }
            }
        }
    }

    /// How often exact integers had to decide, on both sides.
    pub fn slow_paths(&self) -> SlowPaths {
        let [a, b] = self.sides.each_ref().map(Interpreter::slow_paths);
        a.and(b)
    }

    fn side(&mut self, side: usize) -> &mut SideRun {
        self.sides[side].side.get_or_insert_default()
    }

    fn status(&self, side: usize) -> Status {
        self.sides[side].side.as_ref().map_or(Status::Ended, |side| side.status)
    }

    /// Cuts the text, reads what stands before the first selection block, and tells whether a side has nothing to do.
    fn begin(&mut self) -> Result<(), Fault> {
        let a = &mut self.sides[A];
        let sections = Sections::of(a.reader.clone(), a.options);
        let length = u32::try_from(a.reader.length()).unwrap_or(u32::MAX);
        self.end = Place { line: sections.last_line, start: length, end: length, ..Place::default() };
        if a.is_schedule() {
            a.place = self.end;
            return open(AX4_12, "schedule");
        }
        if let Some(head) = sections.head {
            a.reader.keep_to(&[head]);
            a.read_head()?;
        }
        let name = a.task.present.name;
        self.end.program = name;
        if sections.sides.iter().all(Vec::is_empty) {
            a.place = self.end;
            return Fault::raise(AlarmName::NoProgramEnd, PROG_02);
        }
        for (side, sections) in self.sides.iter_mut().zip(&sections.sides) {
            side.names = Names::default();
            side.begun = true;
            side.task.present.name = name;
            side.reader.keep_to(sections);
        }
        let counts = [A, B].map(|side| self.sides[side].has_block_that_counts());
        for (side, other) in [(A, B), (B, A)] {
            if !counts[side] {
                self.side(side).status = Status::Ended;
                self.side(other).alone = true;
                self.ended = other;
            }
        }
        if counts == [false; 2] {
            self.ended = A;
        }
        Ok(())
    }

    /// One block of a side.
    fn run(&mut self, side: usize, sink: &mut impl Sink) -> Option<Ending> {
        self.hand_over(side);
        let ending = self.sides[side].step(sink);
        if self.status(side) == Status::Ended {
            self.ended = side;
            if self.side(side).code != 0 {
                self.ended_by_code = Some(side);
            }
        }
        ending
    }

    /// The waiting block of one of two sides that were released together.
    fn run_waiting(&mut self, side: usize, sink: &mut impl Sink) -> Option<Ending> {
        self.side(side).common = match side {
            A => Common::ForBoth,
            _ if planted::is(Bug::CommonTwice) => Common::Own,
            _ => Common::Done,
        };
        let ending = self.run(side, sink);
        self.side(side).common = Common::Own;
        self.pair = (side == A).then_some(B);
        ending
    }

    /// Hands what is common over to the side that runs next.
    fn hand_over(&mut self, side: usize) {
        if side == self.running {
            return;
        }
        let [a, b] = &mut self.sides;
        let (from, to) = if side == B { (a, b) } else { (b, a) };
        to.state.take_common(&from.state);
        to.ordinal = from.ordinal;
        to.task.set_steps(from.task.steps_left());
        self.running = side;
    }

    /// Neither side is ready: the table of the text.
    fn release(&mut self, sink: &mut impl Sink) -> Result<(), (usize, Fault)> {
        use ReleaseCause::{Counterpart, Equal, OtherEnded, PCode, Smaller};
        match (self.status(A), self.status(B)) {
            (Status::At(Stop::P(p)), Status::At(Stop::P(q))) if p == q => {
                if self.common_words(A) != self.common_words(B) {
                    return Err((A, self.differ(A)));
                }
                self.go_on(A, Equal, PSYNC_03, sink);
                self.go_on(B, Equal, PSYNC_03, sink);
                self.pair = Some(A);
            }
            (Status::At(Stop::P(p)), Status::At(Stop::P(q))) => {
                let side = if (p < q) != planted::is(Bug::GreaterGoesOn) { A } else { B };
                if self.common_words(side).any() {
                    return Err((side, self.differ(side)));
                }
                self.go_on(side, Smaller, PSYNC_03, sink);
            }
            (Status::At(Stop::M100), Status::At(Stop::M100)) => {
                self.go_on(A, Counterpart, M100_01, sink);
                self.go_on(B, Counterpart, M100_01, sink);
            }
            (Status::At(Stop::M100), Status::At(_)) if planted::is(Bug::M100WaitsForM100) => {
                self.go_on(A, Counterpart, M100_01, sink);
            }
            (Status::At(Stop::M100), Status::At(_)) => self.go_on(A, PCode, M100_05, sink),
            (Status::At(_), Status::At(Stop::M100)) => self.go_on(B, PCode, M100_05, sink),
            (Status::At(stop), _) => self.go_on(A, OtherEnded, other_ended(stop), sink),
            (_, Status::At(stop)) => self.go_on(B, OtherEnded, other_ended(stop), sink),
            _ => {}
        }
        Ok(())
    }

    fn go_on(&mut self, side: usize, cause: ReleaseCause, rule: RuleId, sink: &mut impl Sink) {
        self.hand_over(side);
        self.sides[side].release_side(cause, rule, sink);
    }

    /// The common words of the block at which a side waits.
    fn common_words(&self, side: usize) -> CommonWords {
        let slot = self.sides[side].current.as_deref();
        slot.map_or_else(|| CommonWords::of(&Slot::default().words), |slot| CommonWords::of(&slot.words))
    }

    fn differ(&mut self, side: usize) -> Fault {
        self.hand_over(side);
        Fault::new(AlarmName::SidesDiffer, AX4_06)
    }

    /// Both programs are at their end.
    fn finish(&mut self, sink: &mut impl Sink) -> Ending {
        let Some(last) = self.ended_by_code else {
            self.hand_over(self.ended);
            let end = self.end;
            let side = &mut self.sides[self.ended];
            side.place = end;
            return side.fail(Fault::new(AlarmName::NoProgramEnd, PROG_02), sink);
        };
        let (place, code) = (self.sides[last].place, self.side(last).code);
        for side in [A, B] {
            self.hand_over(side);
            self.sides[side].place = place;
            self.sides[side].reset(sink);
        }
        self.hand_over(last);
        let code = Label::of_code(b'M', code);
        self.sides[last].emit(sink, const { RuleSet::of(&[MCODE_04, AX4_05]) }, Action::End { code });
        Ending::End
    }
}

fn other_ended(stop: Stop) -> RuleId {
    match stop {
        Stop::P(_) => PSYNC_04,
        Stop::M100 => M100_03,
    }
}

fn open<T>(rule: RuleId, detail: &str) -> Result<T, Fault> {
    Err(Fault::about(AlarmName::Unspecified, rule, Label::new(detail)))
}

impl Interpreter<'_> {
    /// Whether the text is a schedule program.
    fn is_schedule(&self) -> bool {
        self.reader.is_schedule().unwrap_or(self.setup.schedule)
    }

    /// What stands before the first selection block may do nothing.
    fn read_head(&mut self) -> Result<(), Fault> {
        let mut slot = Slot::default();
        loop {
            let found = self.read(&mut slot, Turn::Now);
            self.place = slot.place;
            if !found? {
                return Ok(());
            }
            if slot.parsed.control.is_some() || !slot.parsed.is_only_name() {
                return open(AX4_02, "turret");
            }
        }
    }

    /// Whether the side program has a block that counts: one with a fault does.
    fn has_block_that_counts(&mut self) -> bool {
        let (mut slot, start) = (Slot::default(), self.reader.mark());
        let (names, steps) = (std::mem::take(&mut self.names), self.task.steps_left());
        self.task.count_no_steps();
        let counts = loop {
            match self.read(&mut slot, Turn::Now) {
                Ok(false) => break false,
                // That a name was used before is no fault of the form.
                Err(fault) if fault.name != AlarmName::SequenceNameDuplicate => break true,
                _ if slot.parsed.is_only_name() => {}
                _ => break true,
            }
        };
        self.names = names;
        self.task.set_steps(steps);
        self.reader.seek(start);
        counts
    }
}
