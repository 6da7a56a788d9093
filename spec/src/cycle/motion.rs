//! One motion of a cycle: its tests and its event. Nothing is cut back by a limit (E100L-GRV-10).

use crate::barrier;
use crate::contour::{self, PlanePoint};
use crate::emission::Emission;
use crate::fault::Outcome;
use crate::frame::Amounts;
use crate::integer::turn;
use crate::modal::{Plan, active_feed};
use crate::path::{
    Axes, Element, Shape, coordinate_readings, coordinate_rules, feed_path, standing, with_speed,
};
use crate::state::State;
use crate::thread::Cited;
use crate::vocabulary::rule_ids::*;
use crate::vocabulary::{
    Action, Angle, Feed, FeedRate, FeedUnit, LeadAxis, Motion, Part, RuleSet, SpindleName,
};

/// An axis of the turning plane.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Axis {
    /// X, a diameter.
    X,
    /// Z.
    Z,
}

impl Axis {
    /// The one that it is not.
    pub fn other(self) -> Self {
        match self {
            Self::X => Self::Z,
            Self::Z => Self::X,
        }
    }

    /// The coordinate on it.
    pub fn of(self, amounts: Amounts) -> i64 {
        match self {
            Self::X => amounts.x,
            Self::Z => amounts.z,
        }
    }

    /// Its letter.
    pub fn letter(self) -> char {
        match self {
            Self::X => 'X',
            Self::Z => 'Z',
        }
    }

    /// As the axis of a lead.
    pub fn lead(self) -> LeadAxis {
        match self {
            Self::X => LeadAxis::X,
            Self::Z => LeadAxis::Z,
        }
    }
}

/// A motion: the coordinates that it names, in program coordinates.
#[derive(Clone, Copy, Debug)]
pub struct Go {
    /// X.
    pub x: Option<i64>,
    /// Z.
    pub z: Option<i64>,
    /// C.
    pub c: Option<Turn>,
    /// The point of the face that X and C are in conversion mode (E100L-CSC-09).
    pub point: Option<PlanePoint>,
    /// How.
    pub manner: Manner,
    /// What it does in the cycle.
    pub part: Part,
    /// Its pass.
    pub pass: Option<u32>,
    /// What its event names.
    pub cited: Cited,
}

/// How C turns.
#[derive(Clone, Copy, Debug)]
pub enum Turn {
    /// To an angle, in the direction in force (E100L-CAX-05).
    To(i64),
    /// By an angle with its sign.
    By(i64),
}

/// How a motion goes.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Manner {
    /// Rapidly.
    Rapid,
    /// At the feed in force.
    Feed,
    /// At a feed per minute of its own, in picometres.
    FeedAt(i64),
    /// With the driven tool (E100L-STAP-01): lead in picometres, and the angle at which it starts.
    Tap {
        /// The axis of the lead.
        axis: Axis,
        /// The lead.
        lead: i64,
        /// The start angle in micro-degrees.
        start: i64,
    },
    /// With the C axis (E100L-CTHR-01): lead in picometres, and feed in picometres per minute.
    Helix {
        /// The axis of the lead.
        axis: Axis,
        /// The lead.
        lead: i64,
        /// The feed along it.
        feed: i64,
    },
}

impl Go {
    /// Along one axis.
    pub fn along(axis: Axis, to: i64, manner: Manner, part: Part, cited: Cited) -> Self {
        let (x, z) = match axis {
            Axis::X => (Some(to), None),
            Axis::Z => (None, Some(to)),
        };
        Self { x, z, c: None, point: None, manner, part, pass: None, cited }
    }

    /// In a pass.
    pub fn in_pass(self, pass: u32) -> Self {
        Self { pass: Some(pass), ..self }
    }
}

impl Turn {
    /// Where C arrives, and its travel with its sign.
    fn from(self, present: i64, state: &State) -> (i64, i64) {
        match self {
            Self::To(target) => (turn::within(target), turn::travel(present, target, 0, state.is_active(15))),
            Self::By(travel) => (turn::within(present + travel), travel),
        }
    }
}

/// Carries a motion out: range, limits, barriers, then the event; nothing of a motion without travel.
pub fn carry_out(go: &Go, plan: &Plan, state: &mut State) -> Outcome<Option<Emission>> {
    let (from, before) = (state.frame.program(), state.frame.machine);
    let turned = go.c.map(|turn| turn.from(from.c, state));
    let target = Amounts {
        x: go.x.unwrap_or(from.x),
        z: go.z.unwrap_or(from.z),
        c: turned.map_or(from.c, |(target, _)| target),
        ..from
    };
    if let Some(point) = go.point {
        state.contour.keep(point, target.x, target.c, &state.frame);
    }
    let axes = Axes { x: target.x != from.x, z: target.z != from.z, ..Axes::default() };
    let c_travel = turned.map(|(_, travel)| travel);
    if !axes.x && !axes.z && c_travel.unwrap_or(0) == 0 {
        return Ok(None);
    }
    let cuts = go.manner != Manner::Rapid;
    let shape = if cuts { Shape::Line } else { Shape::Rapid };
    let Cited { rules, readings } = go.cited;
    let element = Element { target, axes, shape, rules, readings };
    element.check_range(state.setup)?;
    let wanted = state.frame.to_machine(target);
    if axes.x {
        state.limits.x.check(wanted.x)?;
    }
    if axes.z {
        state.limits.z.check(wanted.z)?;
    }
    barrier::check(&element, from, target, state)?;
    state.frame.machine = Amounts { x: wanted.x, z: wanted.z, c: wanted.c, ..before };
    state.contour.wind(c_travel);
    state.cut_last = cuts;
    let event = event(go, c_travel, before, state)?
        .rules(rules.union(coordinate_rules(plan)))
        .readings(readings.union(coordinate_readings(plan, state.setup)))
        .rule_if(c_travel.is_some(), CAX_05)
        .rule_if(state.frame.mirrored, MIRR_05);
    let event = barrier::tested(event, &element, state);
    Ok(Some(with_speed(event, !cuts, state)))
}

fn event(go: &Go, c_travel: Option<i64>, before: Amounts, state: &State) -> Outcome<Emission> {
    let face = go.point.map(contour::face_point);
    let motion = Motion { pass: go.pass, part: Some(go.part), face, ..standing(c_travel, state) };
    Ok(match go.manner {
        Manner::Rapid => Emission::new(Action::Rapid { motion }, RuleSet::EMPTY),
        Manner::Feed => {
            let (feed, rules) = active_feed(state)?;
            line(motion, feed, before, rules, state)
        }
        Manner::FeedAt(feed) => line(motion, per_minute(feed), before, RuleSet::of(&[FEED_02]), state),
        Manner::Tap { axis, lead, start } => {
            let start = (start != 0).then_some(Angle(start));
            thread(motion, lead, axis, start, SpindleName::Tool, None)
        }
        Manner::Helix { axis, lead, feed } => {
            thread(motion, lead, axis, None, SpindleName::CAxis, Some(per_minute(feed)))
        }
    })
}

fn per_minute(feed: i64) -> Feed {
    Feed { value: FeedRate(feed), unit: FeedUnit::PerMinute }
}

/// E100L-G01-04: a line without C.
fn line(motion: Motion, feed: Feed, before: Amounts, rules: RuleSet, state: &State) -> Emission {
    let (path, path_rules, readings) = feed_path(before, state.frame.machine, None, state.setup);
    Emission::new(Action::Linear { motion, feed, path }, rules.union(path_rules)).readings(readings)
}

fn thread(
    motion: Motion,
    lead: i64,
    axis: Axis,
    start: Option<Angle>,
    spindle: SpindleName,
    feed: Option<Feed>,
) -> Emission {
    let action = Action::Thread {
        motion,
        lead: FeedRate(lead),
        axis: axis.lead(),
        change: None,
        start,
        spindle: Some(spindle),
        feed,
    };
    Emission::new(action, RuleSet::EMPTY)
}
