//! The motions of a cycle: tests and event (execution of drilling, 4).

use turnspec_oracle::vocabulary::rule_ids as rules;
use turnspec_oracle::vocabulary::{
    Action, AlarmName, Angle, Feed, FeedRate, LeadAxis, Length, Motion, Part, Sink, SpindleName,
};

use crate::engine::Interpreter;
use crate::engine::arithmetic::contour::Spot;
use crate::engine::arithmetic::frame::to_machine;
use crate::engine::arithmetic::plane::Point;
use crate::engine::cite::Cites;
use crate::engine::contour::face_point;
use crate::engine::fault::Fault;
use crate::engine::motion::{Kind, Turn};
use crate::engine::state::{C, X, Z};
use crate::engine::thread::Cited;

use super::axis::Axis;

/// How a motion is driven.
#[derive(Clone, Copy, Debug)]
pub enum Drive {
    Rapid,
    Feed(Feed),
    /// A tap in step with the tool, which starts at an angle.
    Tap {
        lead: i64,
        axis: LeadAxis,
        start: i64,
    },
    /// A thread in step with the C axis.
    Helix {
        lead: i64,
        axis: LeadAxis,
        feed: Feed,
    },
}

/// One motion of a cycle.
#[derive(Clone, Copy)]
pub struct Move {
    /// The end in X and Z, program coordinates.
    pub end: Point,
    /// The turn of C, if the motion names it.
    pub turn: Option<Turn>,
    pub drive: Drive,
    pub part: Part,
    pub pass: Option<u32>,
    /// The point of conversion mode to which it leads.
    pub point: Option<Spot>,
    pub cited: Cited,
}

impl Move {
    /// A rapid motion that belongs to no pass.
    pub fn rapid(end: Point, turn: Option<Turn>, part: Part, cited: Cited) -> Self {
        Self { end, turn, drive: Drive::Rapid, part, pass: None, point: None, cited }
    }
}

impl Interpreter<'_> {
    /// Makes a motion, unless it leads nowhere.
    pub(super) fn go(&mut self, motion: &Move, sink: &mut impl Sink) -> Result<(), Fault> {
        let Move { end, turn, drive, part, pass, point, mut cited } = *motion;
        let present = self.present();
        let travels = end != present;
        if !travels && turn.is_none_or(|turn| turn.travel == 0) {
            return Ok(());
        }
        let axes = [(X, end.x, end.x != present.x), (Z, end.z, end.z != present.z)];
        for (_, target, travels) in axes {
            if travels {
                self.check_coordinate(target)?;
            }
        }
        let start = self.state.machine;
        let mut machine = start;
        for (axis, target, travels) in axes {
            if travels {
                machine[axis] = to_machine(target, self.state.frame(axis));
                // Nothing is cut back (E100L-GRV-10).
                self.limit(axis, &mut machine[axis], true)?;
            }
        }
        let rapid = matches!(drive, Drive::Rapid);
        let mut cites = Cites::default();
        if travels && self.state.watch.acts() {
            let kind = if rapid { Kind::Rapid } else { Kind::Linear };
            self.check_barriers(kind, &machine, &mut cites, &mut cited.readings)?;
        }
        if let Some(turn) = turn {
            machine[C] = turn.machine;
            self.state.contour.wind(turn.travel);
        }
        self.state.machine = machine;
        self.state.last_motion_cut = matches!(part, Part::Cut | Part::Exit | Part::Infeed | Part::Finish);
        let speed = self.motion_speed(end.x, !rapid, &mut cites, &mut cited.readings);
        if cites != Cites::default() {
            cited = cited.and(self.cites.rules(cites));
        }
        let motion = Motion {
            program: self.position(end.x, end.z, |axis| self.state.program(axis)),
            machine: self.position(self.state.machine_x(machine[X]), machine[Z], |axis| machine[axis]),
            c_travel: turn.map(|turn| Angle(turn.travel)),
            speed,
            pass,
            part: Some(part),
            face: point.map(face_point),
            ..Motion::default()
        };
        let thread = |lead, axis, start: i64, spindle, feed| Action::Thread {
            motion,
            lead: FeedRate(lead),
            axis,
            change: None,
            start: (start != 0).then_some(Angle(start)),
            spindle: Some(spindle),
            feed,
        };
        let action = match drive {
            Drive::Rapid => Action::Rapid { motion },
            Drive::Feed(feed) => {
                Action::Linear { motion, feed, path: Length(self.path(&start, &machine, None)) }
            }
            Drive::Tap { lead, axis, start } => thread(lead, axis, start, SpindleName::Tool, None),
            Drive::Helix { lead, axis, feed } => thread(lead, axis, 0, SpindleName::CAxis, Some(feed)),
        };
        self.emit_with(sink, cited.rules, cited.readings, action);
        Ok(())
    }

    /// Makes a motion of one axis.
    pub(super) fn go_along(
        &mut self,
        (axis, coordinate): (Axis, i64),
        drive: Drive,
        (part, pass): (Part, Option<u32>),
        cited: Cited,
        sink: &mut impl Sink,
    ) -> Result<(), Fault> {
        let end = axis.put(self.present(), coordinate);
        self.go(&Move { end, turn: None, drive, part, pass, point: None, cited }, sink)
    }

    /// A cutting pass begins: every one but the first of its block is a step of the run (E100L-GOTO-03).
    pub(super) fn begin_pass(&mut self) -> Result<(), Fault> {
        let follows = std::mem::replace(&mut self.state.cycle.has_cut, true);
        if follows && !self.task.count_pass() {
            return Fault::raise(AlarmName::StepLimit, rules::GOTO_03);
        }
        Ok(())
    }
}
