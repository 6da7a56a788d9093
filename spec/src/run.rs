//! A run: block after block, each stage in turn, events numbered and placed.
//!
//! A machine with one saddle carries one program out, a [`Channel`]; one with two carries out two, in turns
//! ([`Saddles`]).

mod ahead;
mod channel;
mod definition;
mod lap;
mod meeting;
mod outline;
mod passes;
mod portions;
mod programs;
mod reading;
mod saddles;
mod schedule;
mod side;
mod statement;
mod texts;
mod view;

pub use outline::{Outline, OutlineMotion};
pub use programs::{Program, Programs};
pub use texts::{Read, Spot, Texts};
pub use view::{ActiveMode, ActiveProgram, LocalVariable};

use crate::emission::Emission;
use crate::fault::Outcome;
use crate::state::State;
use crate::vocabulary::{Action, Ending, Event, MachineType, Place, Setup, Sink};
use channel::Channel;
use saddles::Saddles;

/// A run of the oracle, block by block.
pub struct Run<'a> {
    machine: Machine<'a>,
    setup: &'a Setup,
    events: u64,
    ending: Option<Ending>,
}

/// What runs.
enum Machine<'a> {
    /// One program.
    One(Box<Channel<'a>>),
    /// Two, one a saddle.
    Two(Box<Saddles<'a>>),
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
        let texts = Texts::new(program, setup);
        let machine = match setup.machine.r#type {
            MachineType::OneTurret | MachineType::TwoTurrets => {
                Machine::One(Box::new(Channel::new(texts, State::new(setup))))
            }
            MachineType::TwoSaddles => Machine::Two(Box::new(Saddles::new(&texts, setup))),
        };
        Self { machine, setup, events: 0, ending: None }
    }

    /// Carries out the next block, be it empty or skipped, or the next pass of a fixed cycle; the events that
    /// are decided then go to the sink. On two
    /// saddles also lets them meet. `Some` when the run has ended.
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
                let side = self.channel().state.side();
                self.send(fault.block.unwrap_or(place), alarm.of(side), sink);
                self.ending = Some(Ending::Alarm);
            }
        }
        self.ending
    }

    fn send(&mut self, block: Place, emission: Emission, sink: &mut impl Sink) {
        self.events += 1;
        let Emission { action, rules, readings, side, .. } = emission;
        let mut event = Event::new(self.events, block, rules, readings, action);
        match self.setup.machine.r#type {
            MachineType::OneTurret => {}
            MachineType::TwoTurrets => event.turret = side,
            MachineType::TwoSaddles => event.saddle = side,
        }
        sink.event(&event);
    }

    /// Carries out one block, or a pass of it: the events that are decided then, in order, each with its place. The
    /// place of the block is set as soon as it is known.
    pub(crate) fn block(
        &mut self,
        place: &mut Place,
        decided: &mut Vec<(Place, Emission)>,
    ) -> Outcome<Progress> {
        match &mut self.machine {
            Machine::One(channel) => channel.block(place, decided),
            Machine::Two(saddles) => saddles.step(place, decided),
        }
    }

    /// The program that runs, of two saddles that of the one which has moved last.
    fn channel(&self) -> &Channel<'a> {
        match &self.machine {
            Machine::One(channel) => channel,
            Machine::Two(saddles) => saddles.active(),
        }
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
