//! One motion of a thread: its tests and its event.

use super::lead::Lead;
use crate::barrier;
use crate::emission::Emission;
use crate::fault::Outcome;
use crate::frame::Amounts;
use crate::integer;
use crate::modal::Plan;
use crate::path::{Axes, Element, Point, Shape, coordinate_readings, coordinate_rules, feed_path, standing};
use crate::state::State;
use crate::vocabulary::rule_ids::*;
use crate::vocabulary::{
    Action, Angle, Feed, FeedRate, FeedUnit, LeadAxis, Motion, Part, Reading, ReadingSet, RuleId, RuleSet,
    Setup,
};

/// Rules and readings that an event names.
#[derive(Clone, Copy, Default, Debug)]
pub struct Cited {
    /// The rules.
    pub rules: RuleSet,
    /// The readings.
    pub readings: ReadingSet,
}

impl Cited {
    /// These rules.
    pub fn rules(rules: &[RuleId]) -> Self {
        Self { rules: RuleSet::of(rules), ..Self::default() }
    }

    /// These and a reading.
    pub fn reading(self, reading: impl Into<Reading>) -> Self {
        Self { readings: self.readings.with(reading), ..self }
    }

    /// Both.
    pub fn and(self, other: Self) -> Self {
        Self { rules: self.rules.union(other.rules), readings: self.readings.union(other.readings) }
    }

    /// Both, if `holds`.
    pub fn and_if(self, holds: bool, other: Self) -> Self {
        if holds { self.and(other) } else { self }
    }
}

/// What a motion of a thread does.
#[derive(Clone, Copy, Debug)]
pub enum Work {
    /// It positions.
    Rapid,
    /// It cuts, with this lead where it begins, in picometres per revolution.
    Thread(i64),
    /// It withdraws at the rate of E100L-TCHM-03.
    Withdrawal,
}

/// What all motions of a thread have in common.
#[derive(Clone, Copy, Debug)]
pub struct Thread {
    /// The lead.
    pub lead: Lead,
    /// The axis along which it is measured.
    pub axis: LeadAxis,
    /// Where the spindle stands when the thread starts, in micro-degrees.
    pub start_angle: i64,
}

/// A motion of a thread.
#[derive(Clone, Copy, Debug)]
pub struct Step {
    /// Where it ends: X (as a diameter) and Z, in program coordinates.
    pub end: Point,
    /// The axes that are tested.
    pub axes: Axes,
    /// What it does.
    pub work: Work,
    /// Its pass and its part in it.
    pub part: Option<(u32, Part)>,
    /// What its event names.
    pub cited: Cited,
}

/// Carries a motion out: range, limits, barriers, then the event. A limit never takes the place of its end
/// (E100L-THRD-10).
pub fn carry_out(step: &Step, thread: &Thread, plan: &Plan, state: &mut State) -> Outcome<Emission> {
    let (from, before) = (state.frame.program(), state.frame.machine);
    let target = Amounts { x: step.end.0, z: step.end.1, ..from };
    let cuts = !matches!(step.work, Work::Rapid);
    let shape = if cuts { Shape::Line } else { Shape::Rapid };
    let Cited { rules, readings } = step.cited;
    let element = Element { target, axes: step.axes, shape, rules, readings };
    if !state.lap.is_reading() {
        element.check_range(state.setup)?;
    }
    let wanted = state.frame.to_machine(target);
    if step.axes.x {
        state.limits.x.check(wanted.x)?;
    }
    if step.axes.z {
        state.limits.z.check(wanted.z)?;
    }
    let machine = Amounts { x: wanted.x, z: wanted.z, ..before };
    barrier::check(&element, from, target, state)?;
    state.frame.machine = machine;
    state.cut_last = cuts;
    let event = event(step, thread, before, state)
        .rules(coordinate_rules(plan))
        .rule_if(state.frame.mirrored, MIRR_05)
        .readings(coordinate_readings(plan, state.setup));
    Ok(barrier::tested(event, &element, state))
}

fn event(step: &Step, thread: &Thread, before: Amounts, state: &State) -> Emission {
    let motion = Motion {
        pass: step.part.map(|(pass, _)| pass),
        part: step.part.map(|(_, part)| part),
        ..standing(None, state)
    };
    let Cited { rules, readings } = step.cited;
    let cited = |action| Emission::new(action, rules).readings(readings);
    match step.work {
        Work::Rapid => cited(Action::Rapid { motion }),
        Work::Thread(lead) => {
            let Thread { axis, lead: Lead { change, .. }, start_angle } = *thread;
            state.lap.marked(cited(Action::Thread {
                motion,
                lead: FeedRate(lead),
                axis,
                change: (change != 0).then_some(FeedRate(change)),
                start: (start_angle != 0).then_some(Angle(start_angle)),
                spindle: None,
                feed: None,
            }))
        }
        Work::Withdrawal => {
            let feed = Feed { value: FeedRate(withdrawal_rate(state.setup)), unit: FeedUnit::PerMinute };
            let (path, rules, readings) = feed_path(before, state.frame.machine, None, state.setup);
            let action = Action::Linear { motion, feed, path };
            cited(action).rules(rules.with(TCHM_03)).readings(readings)
        }
    }
}

/// E100L-TCHM-03: the rate of chamfer and withdrawal, in picometres per minute.
pub fn withdrawal_rate(setup: &Setup) -> i64 {
    integer::thread::withdrawal_rate(setup.parameters.thread_chamfer_feed)
}
