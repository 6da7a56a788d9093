//! A channel: a program that is carried out block by block, with the state of the machine, or of the saddle, that it moves.

use super::lap::Lap;
use super::outline::Outline;
use super::passes::{Cycle, Passes};
use super::reading::{self, Block, Content, Reader};
use super::statement::Carried;
use super::{Progress, Texts};
use crate::compensation::{Compensation, Stream};
use crate::contour;
use crate::emission::Emission;
use crate::fault::Outcome;
use crate::lap;
use crate::modal::{self, Before, Plan, Words};
use crate::path;
use crate::schedule::Schedule;
use crate::state::State;
use crate::task::{Calls, Registration};
use crate::thread;
use crate::turret;
use crate::vocabulary::rule_ids::*;
use crate::vocabulary::{Place, Setup, Side};

/// A program and what it moves.
pub struct Channel<'a> {
    pub(super) reader: Reader<'a>,
    pub(super) calls: Calls,
    pub(super) state: State<'a>,
    pub(super) compensation: Compensation,
    /// The schedule program, if the main text is one.
    pub(super) schedule: Option<Schedule>,
    /// A fixed cycle of which passes are left.
    pub(super) cycle: Option<Box<Cycle>>,
    /// The block of a definition of LAP that is passed over (E100L-LAP-10).
    pub(super) passing: Option<Place>,
    /// A call of LAP that is carried out.
    pub(super) lap: Option<Box<Lap<'a>>>,
    /// The definition that the last call of LAP has read.
    pub(super) outline: Option<Box<Outline>>,
    pub(super) setup: &'a Setup,
}

/// A block that was carried out up to its motion.
pub struct Moved {
    /// Its words and modes.
    pub plan: Plan,
    /// Whether it had or computed X or Z.
    pub(super) in_plane: bool,
    /// The passes that are left of a fixed cycle.
    pub passes: Option<Passes>,
}

impl<'a> Channel<'a> {
    /// A channel at the beginning of its text.
    pub fn new(texts: Texts<'a>, state: State<'a>) -> Self {
        let setup = state.setup;
        let (start, schedule) = (texts.main_start(), texts.is_schedule(setup).then(|| Schedule::new(&texts)));
        let reader = Reader::new(texts, setup);
        let calls = Calls::new(start);
        let compensation = Compensation::Off;
        let (cycle, passing, lap, outline) = (None, None, None, None);
        Self { reader, calls, state, compensation, schedule, cycle, passing, lap, outline, setup }
    }

    /// Carries out one block, or the next pass of a cycle: the events that are decided then, in order, each with its
    /// place. The place of the block is set as soon as it is known.
    pub fn block(&mut self, place: &mut Place, decided: &mut Vec<(Place, Emission)>) -> Outcome<Progress> {
        if self.in_schedule() {
            return self.schedule_block(place, decided);
        }
        if let Some(cycle) = self.cycle.take() {
            return self.next_pass(*cycle, place, decided);
        }
        if let Some(lap) = self.lap.take() {
            return self.go_on_in_call(lap, place, decided);
        }
        let Some(block) = self.arrive(place)? else {
            return Err(reading::end(self.calls.running()));
        };
        let Block { place: here, content, behind, .. } = block;
        let mut stream = self.compensation.stream(here, self.state.side(), decided);
        let progress = self.carry_out(content, Carried { place: here, behind }, &mut stream);
        stream.close();
        if progress? == Progress::Ended {
            return Ok(self.program_ended(decided));
        }
        self.modal_call(place, decided)?;
        Ok(Progress::Going)
    }

    fn next_pass(
        &mut self,
        cycle: Cycle,
        place: &mut Place,
        decided: &mut Vec<(Place, Emission)>,
    ) -> Outcome<Progress> {
        let Cycle { mut moved, block } = cycle;
        self.begin_pass(block, place)?;
        let mut stream = self.compensation.stream(block.place, self.state.side(), decided);
        let progress =
            self.pass(&mut moved, &mut stream).and_then(|()| self.go_on(moved, block, &mut stream));
        stream.close();
        if progress? == Progress::Ended {
            return Ok(self.program_ended(decided));
        }
        Ok(Progress::Going)
    }

    fn carry_out(&mut self, content: Content, block: Carried, stream: &mut Stream) -> Outcome<Progress> {
        let Some(words) = self.words(content, block, stream)? else { return Ok(Progress::Going) };
        let moved = self.up_to_motion(words, stream)?;
        if moved.plan.is_contour_call() {
            self.begin_call(moved.plan, block);
            return Ok(Progress::Going);
        }
        if moved.plan.begins_definition() {
            self.passing = Some(block.place);
        }
        self.go_on(moved, block, stream)
    }

    /// What comes after the motion, if no passes are left.
    fn go_on(&mut self, moved: Moved, block: Carried, stream: &mut Stream) -> Outcome<Progress> {
        if moved.passes.is_some() {
            self.cycle = Some(Box::new(Cycle { moved, block }));
            return Ok(Progress::Going);
        }
        self.after_motion(&moved, block, stream)
    }

    /// The words of a block, evaluated. What holds none is carried out at once.
    pub(super) fn words(
        &mut self,
        content: Content,
        block: Carried,
        stream: &mut Stream,
    ) -> Outcome<Option<Words>> {
        match content {
            Content::Nothing | Content::Name => Ok(None),
            Content::Statement(statement) => self.statement(&statement, block, stream).map(|()| None),
            Content::Communication(statement) => self.communicate(&statement, stream).map(|()| None),
            Content::Turret(codes) => self.change_turret(&codes, stream).map(|()| None),
            Content::Words(words) => Ok(Some(*words)),
            Content::Items(items) => {
                let own = Registration::Change { program: self.calls.depth() };
                modal::evaluate(&items, own, &mut self.state, &mut stream.emissions).map(Some)
            }
            Content::ContourCall(contour, items) => {
                let own = Registration::Change { program: self.calls.depth() };
                modal::evaluate_call(contour, &items, own, &mut self.state, &mut stream.emissions).map(Some)
            }
        }
    }

    /// Checks, and steps 1 to 7.
    pub(super) fn up_to_motion(&mut self, words: Words, stream: &mut Stream) -> Outcome<Moved> {
        let before = Before { has_contour: self.has_contour(&words), ..self.before() };
        let plan = self.state.lap.taken(modal::check(words, before, &self.state)?);
        modal::before_motion(&plan, &mut self.state, &mut stream.emissions)?;
        if plan.words.assigns || plan.words.get('T').is_some() || plan.one_shot == Some(50) {
            // The frame may have changed: a corner of before means nothing now.
            self.state.base = None;
        }
        if plan.has_passes() {
            return self.begin_cycle(plan, stream);
        }
        lap::begin_motion(&plan, &mut self.state)?;
        let in_plane = self.motion(&plan, stream)?;
        Ok(Moved { plan, in_plane, passes: None })
    }

    /// Step 8.
    fn after_motion(&mut self, moved: &Moved, block: Carried, stream: &mut Stream) -> Outcome<Progress> {
        let plan = &moved.plan;
        if let Some(code) = modal::end_code(plan) {
            self.compensation.end_of_program(stream, &mut self.state)?;
            self.check_end_of_selected()?;
            let selected = self.schedule.is_some();
            if !selected {
                stream.emissions.append(&mut modal::reset(&mut self.state));
            }
            stream.emissions.push(modal::end(code, &self.state).rule_if(selected, SDF_14));
            return Ok(Progress::Ended);
        }
        self.end_of_block(moved, stream)?;
        if plan.triggers() {
            self.calls.trigger(block.place, block.behind);
        }
        Ok(Progress::Going)
    }

    /// M00 and M01, and the end of a block that does not end the program.
    pub(super) fn end_of_block(&mut self, moved: &Moved, stream: &mut Stream) -> Outcome<()> {
        stream.emissions.extend(modal::stop(&moved.plan, &self.state));
        self.compensation.end_of_block(moved.in_plane, stream, &mut self.state)
    }

    /// A block that selects a turret: one without motion.
    fn change_turret(&mut self, codes: &[Side], stream: &mut Stream) -> Outcome<()> {
        let left_over = self.compensation.is_left_over();
        turret::change(codes, left_over, &mut self.state, &mut stream.emissions)?;
        self.compensation.end_of_block(false, stream, &mut self.state)
    }

    pub(super) fn before(&self) -> Before {
        Before {
            modes: self.state.modes,
            after_angle: self.state.angle_target.is_some(),
            left_over: self.compensation.is_left_over(),
            modal: self.calls.last_to_call() > 0,
            has_contour: false,
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
            _ if plan.cutter.is_some() => {}
            None if plan.is_thread() => {
                let lead = thread::lead_of_block(&self.state)?;
                // The look-ahead of an angle alone comes behind the lead, before everything else of the leg.
                let ahead = self.look_ahead(plan)?;
                thread::cut(plan, lead, &ahead, &mut self.state, &mut stream.emissions)?;
            }
            None if contour::has_own_motions(plan) => {
                contour::carry_out(plan, &mut self.state, &mut stream.emissions)?;
            }
            _ if plan.moves => {
                let ahead = self.look_ahead(plan)?;
                elements = self.state.in_contour_coordinates(|state| path::elements(plan, &ahead, state))?;
            }
            _ => {}
        }
        if let Some(plane) = plan.cutter {
            return self.compensation.motion_of_cutter(plane, plan, dwell, stream, &mut self.state);
        }
        lap::place(plan, &mut elements, &mut self.state)?;
        self.compensation.motion(plan, &elements, dwell, stream, &mut self.state)
    }
}
