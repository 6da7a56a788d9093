//! A run: block after block, each stage in turn, events numbered and placed.

use std::collections::{BTreeSet, VecDeque};

use crate::compensation::{Compensation, Stream};
use crate::emission::Emission;
use crate::fault::{Fault, Outcome};
use crate::modal::{self, Before, Plan, Words};
use crate::path::{self, Ahead};
use crate::state::State;
use crate::syntax::{Body, Item, ItemKind, Source, parse};
use crate::vocabulary::rule_ids::*;
use crate::vocabulary::{Action, AlarmName, Ending, Event, Label, Place, Setup, Sink};

/// A run of the oracle, block by block.
pub struct Run<'a> {
    source: Source<'a>,
    state: State<'a>,
    compensation: Compensation,
    setup: &'a Setup,
    sequence_names: BTreeSet<Label>,
    program_name: Label,
    began: bool,
    /// Blocks that were read ahead of their turn.
    waiting: VecDeque<Waiting>,
    events: u64,
    ending: Option<Ending>,
}

/// Whether a program goes on.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Progress {
    /// There is a next block.
    Going,
    /// M02 or M30 was carried out.
    Ended,
}

/// A block that was read.
#[derive(Clone)]
struct Waiting {
    place: Place,
    content: Content,
}

#[derive(Clone)]
enum Content {
    /// The program name.
    Name,
    /// Items, not evaluated yet.
    Items(Vec<Item>),
    /// Words that look-ahead has evaluated.
    Words(Box<Words>),
    /// The end of the text.
    End,
}

impl<'a> Run<'a> {
    /// Prepares a run of a program on a valid set-up.
    #[must_use]
    pub fn new(program: &'a [u8], setup: &'a Setup) -> Self {
        Self {
            source: Source::new(program, setup.tape.code),
            state: State::new(setup),
            compensation: Compensation::Off,
            setup,
            sequence_names: BTreeSet::new(),
            program_name: Label::default(),
            began: false,
            waiting: VecDeque::new(),
            events: 0,
            ending: None,
        }
    }

    /// Carries out the next block; the events that are decided then go to the sink. `Some` when the run has ended.
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
                let alarm = Emission::new(Action::Alarm(fault.alarm), fault.rules);
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

    /// Carries out one block: the events that are decided then, in order, each with its place. The place of the
    /// block is set as soon as it is known.
    pub(crate) fn block(
        &mut self,
        place: &mut Place,
        decided: &mut Vec<(Place, Emission)>,
    ) -> Outcome<Progress> {
        let next = match self.waiting.pop_front() {
            Some(next) => next,
            None => self.read(place)?,
        };
        *place = next.place;
        let mut stream = self.compensation.stream(*place, decided);
        let progress = self.carry_out(next.content, &mut stream);
        stream.close();
        progress
    }

    fn carry_out(&mut self, content: Content, stream: &mut Stream) -> Outcome<Progress> {
        let words = match content {
            Content::End => return Err(Fault::new(AlarmName::NoProgramEnd, PROG_02)),
            Content::Name => return Ok(Progress::Going),
            Content::Words(words) => *words,
            // A sequence name alone.
            Content::Items(items) if items.is_empty() => return Ok(Progress::Going),
            Content::Items(items) => modal::evaluate(&items, &mut self.state, &mut stream.emissions)?,
        };
        let plan = modal::check(words, self.before(), &self.state)?;
        modal::before_motion(&plan, &mut self.state, &mut stream.emissions)?;
        if plan.words.assigns || plan.words.get('T').is_some() || plan.one_shot == Some(50) {
            // The frame may have changed: a corner of before means nothing now.
            self.state.base = None;
        }
        let moved = self.motion(&plan, stream)?;
        if modal::ends_program(&plan) {
            self.compensation.end_of_program(stream, &self.state)?;
        }
        if modal::after_motion(&plan, &mut self.state, &mut stream.emissions) {
            return Ok(Progress::Ended);
        }
        self.compensation.end_of_block(moved, stream, &self.state)?;
        Ok(Progress::Going)
    }

    fn before(&self) -> Before {
        Before {
            modes: self.state.modes,
            after_angle: self.state.angle_target.is_some(),
            left_over: self.compensation.is_left_over(),
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
            Some(22) => path::torque_skip(plan, &mut self.state, &mut stream.emissions)?,
            _ if plan.moves => {
                let ahead = self.look_ahead(plan)?;
                elements = path::elements(plan, &ahead, &mut self.state)?;
            }
            _ => {}
        }
        self.compensation.motion(plan, &elements, dwell, stream, &mut self.state)
    }

    /// Reads the next block that is one (neither empty nor skipped). The place is set as soon as it is known.
    fn read(&mut self, place: &mut Place) -> Outcome<Waiting> {
        loop {
            let Some(line) = self.source.next_line()? else {
                let end = Place { program: self.program_name, ..self.source.end() };
                *place = end;
                return Ok(Waiting { place: end, content: Content::End });
            };
            *place = Place { program: self.program_name, ..line.place };
            let parsed = parse(&line, self.setup, &mut place.sequence);
            let body = parsed.map_err(|fault| fault.of_block(*place))?.body;
            // E100L-SEQ-03, E100L-SEQ-04: each name once, compared as text.
            if !place.sequence.is_empty() && !self.sequence_names.insert(place.sequence) {
                return Err(Fault::new(AlarmName::SequenceNameDuplicate, SEQ_03).of_block(*place));
            }
            let content = match body {
                Body::Empty => continue,
                Body::Skipped => {
                    self.began = true;
                    continue;
                }
                Body::ProgramName(name) => {
                    if self.began {
                        return Err(Fault::new(AlarmName::ProgramNameMisplaced, PROG_02).of_block(*place));
                    }
                    self.program_name = name;
                    place.program = name;
                    Content::Name
                }
                Body::Items(items) => Content::Items(items),
            };
            self.began = true;
            return Ok(Waiting { place: *place, content });
        }
    }

    /// What a corner needs of the blocks behind it: evaluated once, and kept for their turn.
    fn look_ahead(&mut self, plan: &Plan) -> Outcome<Vec<Ahead>> {
        let mut ahead = Vec::new();
        if !plan.is_angle_only() && !is_any_angle_chamfer(plan, self.setup) {
            return Ok(ahead);
        }
        // The needing block leads away from a displacement that was left over.
        let before = Before { modes: self.state.modes, after_angle: plan.is_angle_only(), left_over: false };
        let next = self.peek(0, before)?;
        ahead.extend(next.clone());
        let (next, place) = path::next_block(plan, &ahead)?;
        // E100L-ANG-06: an angle-only line ends on the line of the block after it; when that line is the one
        // behind a corner, its own end needs one block more.
        if next.is_angle_only() && !plan.is_angle_only() {
            let next = next.clone();
            let before = Before { modes: next.modes, after_angle: true, left_over: false };
            let further = self.peek(1, before)?;
            path::next_block(&next, further.as_slice()).map_err(|fault| fault.of_block(place))?;
            ahead.extend(further);
        }
        Ok(ahead)
    }

    /// The block `index` places further, checked as one that comes after this; none if there is nothing that a
    /// corner could be computed from.
    fn peek(&mut self, index: usize, before: Before) -> Outcome<Option<Ahead>> {
        if self.waiting.len() <= index {
            let mut place = Place::default();
            let read = self.read(&mut place).map_err(|fault| fault.of_block(place))?;
            self.waiting.push_back(read);
        }
        let Some(waiting) = self.waiting.get_mut(index) else { return Ok(None) };
        let place = waiting.place;
        if let Content::Items(items) = &waiting.content {
            if items.iter().any(|item| matches!(item.kind, ItemKind::Assignment(..))) {
                return Ok(None);
            }
            let words = modal::evaluate(items, &mut self.state, &mut Vec::new())
                .map_err(|fault| fault.of_block(place))?;
            waiting.content = Content::Words(Box::new(words));
        }
        let Content::Words(words) = &waiting.content else { return Ok(None) };
        let words = words.as_ref().clone();
        let plan = modal::check(words, before, &self.state);
        plan.map(|plan| Some(Ahead { plan, place })).map_err(|fault| fault.of_block(place))
    }
}

fn is_any_angle_chamfer(plan: &Plan, setup: &Setup) -> bool {
    plan.is_chamfer() && setup.parameters.chamfering == crate::vocabulary::Chamfering::AnyAngle
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
