//! A run: block after block, each stage in turn, events numbered and placed.

use std::collections::{BTreeSet, VecDeque};

use crate::emission::Emission;
use crate::fault::{Fault, Outcome};
use crate::modal::{self, Plan, Words};
use crate::path::{self, Ahead};
use crate::state::{Modes, State};
use crate::syntax::{Body, Item, ItemKind, Source, parse};
use crate::vocabulary::rule_ids::*;
use crate::vocabulary::{Action, AlarmName, Ending, Event, Label, Place, ReadingSet, Setup, Sink};

/// A run of the oracle, block by block.
pub struct Run<'a> {
    source: Source<'a>,
    state: State<'a>,
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
            setup,
            sequence_names: BTreeSet::new(),
            program_name: Label::default(),
            began: false,
            waiting: VecDeque::new(),
            events: 0,
            ending: None,
        }
    }

    /// Carries out the next block; its events go to the sink. `Some` when the run has ended.
    pub fn step(&mut self, sink: &mut impl Sink) -> Option<Ending> {
        if self.ending.is_some() {
            return self.ending;
        }
        let mut emissions = Vec::new();
        let mut place = Place::default();
        let result = self.block(&mut place, &mut emissions);
        for emission in emissions {
            self.send(place, emission, sink);
        }
        match result {
            Ok(Progress::Going) => {}
            Ok(Progress::Ended) => self.ending = Some(Ending::End),
            Err(fault) => {
                let alarm = Emission {
                    action: Action::Alarm(fault.alarm),
                    rules: fault.rules,
                    readings: ReadingSet::default(),
                };
                self.send(fault.block.unwrap_or(place), alarm, sink);
                self.ending = Some(Ending::Alarm);
            }
        }
        self.ending
    }

    fn send(&mut self, block: Place, emission: Emission, sink: &mut impl Sink) {
        self.events += 1;
        let Emission { action, rules, readings } = emission;
        sink.event(&Event { n: self.events, block, rules, readings, action });
    }

    /// Carries out one block. The place is set as soon as it is known.
    pub(crate) fn block(&mut self, place: &mut Place, emissions: &mut Vec<Emission>) -> Outcome<Progress> {
        let next = match self.waiting.pop_front() {
            Some(next) => next,
            None => self.read(place)?,
        };
        *place = next.place;
        let words = match next.content {
            Content::End => return Err(Fault::new(AlarmName::NoProgramEnd, PROG_02)),
            Content::Name => return Ok(Progress::Going),
            Content::Words(words) => *words,
            Content::Items(items) => modal::evaluate(&items, &mut self.state, emissions)?,
        };
        let after_angle = self.state.angle_target.is_some();
        let plan = modal::check(words, self.state.modes, after_angle, &self.state)?;
        modal::before_motion(&plan, &mut self.state, emissions)?;
        if plan.words.assigns || plan.words.get('T').is_some() || plan.one_shot == Some(50) {
            // The frame may have changed: a corner of before means nothing now.
            self.state.base = None;
        }
        self.motion(&plan, emissions)?;
        let ended = modal::after_motion(&plan, &mut self.state, emissions);
        Ok(if ended { Progress::Ended } else { Progress::Going })
    }

    fn motion(&mut self, plan: &Plan, emissions: &mut Vec<Emission>) -> Outcome<()> {
        match plan.one_shot {
            Some(4) => {
                let number = plan.words.feed.clone().unwrap_or_default();
                emissions.push(modal::dwell(&number, &self.state)?);
            }
            _ if plan.moves => {
                let ahead = self.look_ahead(plan)?;
                path::motion(plan, &ahead, &mut self.state, emissions)?;
            }
            _ => {}
        }
        Ok(())
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
        let next = self.peek(0, plan)?;
        ahead.extend(next.clone());
        let (next, place) = path::next_block(plan, &ahead)?;
        // E100L-ANG-06: an angle-only line ends on the line of the block after it; when that line is the one
        // behind a corner, its own end needs one block more.
        if next.is_angle_only() && !plan.is_angle_only() {
            let next = next.clone();
            let further = self.peek(1, &next)?;
            path::next_block(&next, further.as_slice()).map_err(|fault| fault.of_block(place))?;
            ahead.extend(further);
        }
        Ok(ahead)
    }

    /// The block `index` places further, checked as the one after `before`; none if there is nothing that a
    /// corner could be computed from.
    fn peek(&mut self, index: usize, before: &Plan) -> Outcome<Option<Ahead>> {
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
        let modes: Modes = before.modes;
        let plan = modal::check(words, modes, before.is_angle_only(), &self.state);
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
