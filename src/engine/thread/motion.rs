//! The motions of a thread: tests, event, rules (execution of threads, 7 and 9).

use turnspec_oracle::vocabulary::rule_ids::MIRR_05;
use turnspec_oracle::vocabulary::{
    Action, Angle, Feed, FeedRate, FeedUnit, LeadAxis, Length, Motion, Part, ReadingSet, RuleSet, Sink,
};

use crate::engine::Interpreter;
use crate::engine::arithmetic::frame::to_machine;
use crate::engine::arithmetic::plane::Point;
use crate::engine::arithmetic::run_out::withdrawal_rate;
use crate::engine::cite::Cites;
use crate::engine::fault::Fault;
use crate::engine::motion::Kind;
use crate::engine::state::{X, Z};

/// Rules and readings of an event.
#[derive(Clone, Copy, Default)]
pub struct Cited {
    pub rules: RuleSet,
    pub readings: ReadingSet,
}

impl Cited {
    /// With more rules.
    pub fn and(self, rules: RuleSet) -> Self {
        Self { rules: self.rules.union(rules), ..self }
    }

    /// With more rules under a condition.
    pub fn and_if(self, condition: bool, rules: RuleSet) -> Self {
        if condition { self.and(rules) } else { self }
    }

    /// With a reading.
    pub fn by(self, readings: ReadingSet) -> Self {
        Self { readings: self.readings.union(readings), ..self }
    }

    /// With a reading under a condition.
    pub fn by_if(self, condition: bool, readings: ReadingSet) -> Self {
        if condition { self.by(readings) } else { self }
    }
}

/// What the thread events of a pass or leg have in common.
#[derive(Clone, Copy, Debug)]
pub struct Thread {
    pub axis: LeadAxis,
    pub change: i64,
    /// The angle of the spindle in micro-degrees.
    pub start: i64,
}

impl Thread {
    /// Its lead where it begins.
    pub fn with_lead(self, lead: i64) -> Drive {
        Drive::Thread(self, lead)
    }
}

/// How a motion is driven.
#[derive(Clone, Copy, Debug)]
pub enum Drive {
    Rapid,
    /// With the lead where it begins.
    Thread(Thread, i64),
    /// At the withdrawal rate.
    Withdrawal,
}

/// One motion of a thread.
#[derive(Clone, Copy)]
pub struct Step {
    pub drive: Drive,
    pub end: Point,
    /// Whether X and Z are tested.
    pub tested: [bool; 2],
    /// Its pass, and what it does there.
    pub part: Option<(u32, Part)>,
    pub cited: Cited,
}

impl Interpreter<'_> {
    /// Makes a motion, unless it leads nowhere.
    pub(super) fn make(&mut self, step: &Step, sink: &mut impl Sink) -> Result<(), Fault> {
        let Step { drive, end, tested, part, mut cited } = *step;
        if end == self.present() {
            return Ok(());
        }
        let axes = [(X, end.x, tested[0]), (Z, end.z, tested[1])];
        for (_, target, tested) in axes {
            if tested {
                self.check_coordinate(target)?;
            }
        }
        let start = self.state.machine;
        let mut machine = start;
        for (axis, target, tested) in axes {
            machine[axis] = to_machine(target, self.state.frame(axis));
            if tested {
                // Nothing is cut back, as in arcs (E100L-THRD-10).
                self.limit(axis, &mut machine[axis], true)?;
            }
        }
        let rapid = matches!(drive, Drive::Rapid);
        if self.state.watch.acts() {
            let kind = if rapid { Kind::Rapid } else { Kind::Linear };
            let mut cites = Cites::default();
            self.check_barriers(kind, &machine, &mut cites, &mut cited.readings)?;
            cited = cited.and(self.cites.rules(cites));
        }
        self.state.machine = machine;
        self.state.last_motion_cut = !rapid;
        let (pass, part) = part.unzip();
        let motion = Motion {
            program: self.position(end.x, end.z, |axis| self.state.program(axis)),
            machine: self.position(self.state.machine_x(machine[X]), machine[Z], |axis| machine[axis]),
            pass,
            part,
            ..Motion::default()
        };
        if self.state.mirror < 0 {
            cited = cited.and(const { RuleSet::of(&[MIRR_05]) });
        }
        let action = match drive {
            Drive::Rapid => Action::Rapid { motion },
            Drive::Thread(Thread { axis, change, start }, lead) => Action::Thread {
                motion,
                lead: FeedRate(lead),
                axis,
                change: (change != 0).then_some(FeedRate(change)),
                start: (start != 0).then_some(Angle(start)),
                spindle: None,
                feed: None,
            },
            Drive::Withdrawal => {
                let value = withdrawal_rate(self.setup.parameters.thread_chamfer_feed.into());
                let feed = Feed { value: FeedRate(value), unit: FeedUnit::PerMinute };
                Action::Linear { motion, feed, path: Length(self.path(&start, &machine, None)) }
            }
        };
        self.emit_with(sink, cited.rules, cited.readings, action);
        Ok(())
    }
}
