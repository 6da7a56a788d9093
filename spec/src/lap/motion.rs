//! One motion of a rough cycle: its tests and its event (execution-lap.md, sections 13 and 14).

use super::job::Job;
use super::plane::Spot;
use super::recording::Leg;
use crate::barrier;
use crate::emission::Emission;
use crate::fault::Outcome;
use crate::frame::Amounts;
use crate::modal::feed_in_force;
use crate::path::{Axes, Element, Shape, event, standing, with_speed};
use crate::state::{State, StoredFeed};
use crate::thread::Cited;
use crate::vocabulary::rule_ids::*;
use crate::vocabulary::{Action, Motion, Part, Sense};

/// How a motion goes.
#[derive(Clone, Debug)]
pub enum Course {
    /// Positioning.
    Rapid,
    /// Straight, at a feed if there is one.
    Line(Option<StoredFeed>),
    /// Round a centre.
    Arc(Spot, Sense, Option<StoredFeed>),
    /// A thread.
    Thread(Leg),
}

/// What a motion belongs to.
#[derive(Clone, Copy, Debug)]
pub struct Role {
    /// Its pass.
    pub pass: Option<u32>,
    /// What it does in it.
    pub part: Part,
    /// What its event names besides what all name.
    pub cited: Cited,
}

/// Where events of a cycle go, and the machine that it moves.
pub struct Tool<'t, 's> {
    /// The cycle.
    pub job: &'t Job,
    /// The control.
    pub state: &'t mut State<'s>,
    /// The events.
    pub emissions: &'t mut Vec<Emission>,
}

impl Tool<'_, '_> {
    /// Where the tool is.
    pub fn present(&self) -> Spot {
        let Amounts { x, z, .. } = self.state.frame.program();
        self.job.plane.spot((x, z))
    }

    /// Goes somewhere; nothing happens where the tool is there already.
    pub fn go(&mut self, to: Spot, course: &Course, role: Role) -> Outcome<()> {
        if to != self.present() {
            let event = carry_out(self.job, to, course, role, self.state)?;
            self.emissions.push(event);
        }
        Ok(())
    }

    /// Positions both axes.
    pub fn rapid(&mut self, to: Spot, role: Role) -> Outcome<()> {
        self.go(to, &Course::Rapid, role)
    }

    /// Positions the infeed axis.
    pub fn rapid_infeed(&mut self, infeed: i64, role: Role) -> Outcome<()> {
        self.rapid(Spot { infeed, ..self.present() }, role)
    }

    /// Positions the cutting axis.
    pub fn rapid_cutting(&mut self, cutting: i64, role: Role) -> Outcome<()> {
        self.rapid(Spot { cutting, ..self.present() }, role)
    }

    /// Positions the infeed axis, if that leads upward.
    pub fn lift(&mut self, infeed: i64, role: Role) -> Outcome<()> {
        let is_above = self.job.plane.up * (infeed - self.present().infeed) > 0;
        if is_above { self.rapid_infeed(infeed, role) } else { Ok(()) }
    }

    /// E100L-AP1-06: leaves what was cut by these amounts, against the infeed and back along the cutting axis.
    pub fn relieve(&mut self, infeed: i64, cutting: i64, role: Role) -> Outcome<()> {
        let (present, plane) = (self.present(), self.job.plane);
        let (infeed, cutting) = (plane.up * infeed, plane.onward * cutting);
        let to = Spot { infeed: present.infeed + infeed, cutting: present.cutting - cutting };
        self.rapid(to, role)
    }
}

fn carry_out(job: &Job, to: Spot, course: &Course, role: Role, state: &mut State) -> Outcome<Emission> {
    let (from, before) = (state.frame.program(), state.frame.machine);
    let (x, z) = job.plane.point(to);
    let target = Amounts { x, z, ..from };
    let (shape, feed) = match course {
        Course::Rapid => (Shape::Rapid, None),
        Course::Line(feed) => (Shape::Line, Some(feed_in_force(*feed, state)?)),
        Course::Arc(centre, sense, feed) => {
            let shape = Shape::Arc { centre: job.plane.point(*centre), sense: *sense };
            (shape, Some(feed_in_force(*feed, state)?))
        }
        Course::Thread(_) => (Shape::Line, None),
    };
    let cited = job.cited.and(role.cited);
    let element = Element { target, axes: Axes::PLANE, shape, rules: cited.rules, readings: cited.readings };
    element.check_range(state.setup)?;
    let machine = state.frame.to_machine(target);
    state.limits.x.check(machine.x)?;
    state.limits.z.check(machine.z)?;
    barrier::check(&element, from, target, state)?;
    state.frame.machine = Amounts { x: machine.x, z: machine.z, ..before };
    state.cut_last = shape != Shape::Rapid;
    let motion = Motion { pass: role.pass, part: Some(role.part), ..standing(None, state) };
    let event = match course {
        Course::Thread(leg) => thread(leg, motion, cited, state),
        _ => event(shape, motion, feed, before, cited.rules, state).readings(cited.readings),
    };
    Ok(with_speed(barrier::tested(event, &element, state), shape == Shape::Rapid, state))
}

fn thread(leg: &Leg, motion: Motion, cited: Cited, state: &State) -> Emission {
    let Leg { lead, axis, change, start, rules, readings } = leg.clone();
    let action = Action::Thread { motion, lead, axis, change, start, spindle: None, feed: None };
    Emission::new(action, cited.rules.union(rules))
        .readings(cited.readings.union(readings))
        .rule_if(state.frame.mirrored, MIRR_05)
}
