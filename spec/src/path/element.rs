//! Elements of the path: what every motion has in common.

use super::plane::Point;
use crate::barrier;
use crate::controls::e100l::units;
use crate::emission::Emission;
use crate::fault::{Outcome, fail};
use crate::frame::{Amounts, position};
use crate::modal::{Plan, active_feed, motion_speed};
use crate::quantity::{ratio, whole};
use crate::real::{self, Interval};
use crate::state::State;
use crate::vocabulary::rule_ids::*;
use crate::vocabulary::{
    Action, AlarmName, Angle, Feed, FeedLength, Length, Motion, ReadingSet, RuleSet, Sense, Setup,
};

/// The axes that a motion commands.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct Axes {
    /// X.
    pub x: bool,
    /// Z.
    pub z: bool,
    /// W.
    pub w: bool,
    /// C, with its travel in micro-degrees.
    pub c: Option<i64>,
}

impl Axes {
    /// X and Z.
    pub const PLANE: Self = Self { x: true, z: true, w: false, c: None };
}

/// A motion of a block before it is carried out.
#[derive(Clone, Debug)]
pub struct Element {
    /// Where it goes, in program coordinates.
    pub target: Amounts,
    /// The axes that it commands.
    pub axes: Axes,
    /// Which way.
    pub shape: Shape,
    /// The rules that led there.
    pub rules: RuleSet,
    /// The readings that it depends on.
    pub readings: ReadingSet,
}

/// Which way a motion goes.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Shape {
    /// Each axis on its own.
    Rapid,
    /// Straight, at a feed.
    Line,
    /// Round a centre, at a feed.
    Arc {
        /// X (as a diameter) and Z, in program coordinates.
        centre: Point,
        /// The way round.
        sense: Sense,
    },
}

impl Element {
    /// Whether it has or computes X or Z.
    pub fn in_plane(&self) -> bool {
        self.axes.x || self.axes.z
    }

    /// Where it ends in the plane, from a program position, before limits: an axis without a command stays.
    pub fn programmed_end(&self, from: Amounts) -> Amounts {
        let (axes, target) = (self.axes, self.target);
        Amounts {
            x: if axes.x { target.x } else { from.x },
            z: if axes.z { target.z } else { from.z },
            ..from
        }
    }

    /// E100L-ADDR-01: its target.
    pub fn check_range(&self, setup: &Setup) -> Outcome<()> {
        check_range(self.target, self.axes, setup)
    }

    /// The feed of a cutting motion.
    pub fn feed(&self, state: &State) -> Outcome<Option<(Feed, RuleSet)>> {
        if self.shape == Shape::Rapid { Ok(None) } else { active_feed(state).map(Some) }
    }
}

/// What the axes of the turning plane do in a motion.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Way {
    /// Where they start: X (as a diameter) and Z in machine coordinates.
    pub from: Point,
    /// Which limits are tested.
    pub limits: Tested,
    /// Whether the barriers are tested; if not, they were before.
    pub barriers: bool,
}

/// The travel limits that a motion is tested against.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Tested {
    /// Those of the axes that it commands.
    Commanded,
    /// X and Z, whichever it commands: what leads out of compensation (E100L-NRC-66, E100L-NRC-71).
    Plane,
    /// All but X and Z, which the tip is tested against (E100L-NRC-80).
    OutsidePlane,
    /// None: they were tested before.
    Nothing,
}

/// E100L-ADDR-01: a target that no coordinate word could name, on the axes that go there.
pub fn check_range(target: Amounts, axes: Axes, setup: &Setup) -> Outcome<()> {
    let largest = units::largest_length(setup.unit_system);
    let beyond = |moves: bool, value: i64| moves && value.abs() > largest;
    if beyond(axes.x, target.x) || beyond(axes.z, target.z) || beyond(axes.w, target.w) {
        return fail(AlarmName::CoordinateRange, ADDR_01);
    }
    Ok(())
}

/// Rules that every motion of a block obeys; X is a diameter with the C axis too (E100L-DIA-02).
pub fn coordinate_rules(plan: &Plan) -> RuleSet {
    let incremental = plan.modes.incremental();
    let mut rules = RuleSet::of(&[COORD_03, if incremental { ABS_02 } else { ABS_01 }]);
    // E100L-CSC-02: in conversion mode X is a length of the face.
    if plan.words.get('X').is_some() && !plan.converts {
        rules = rules.with(DIA_01);
        if incremental {
            rules = rules.with(ABS_03);
        }
    }
    if plan.words.inch { rules.with(INCH_02) } else { rules }
}

/// The reading of the inch conversion, where a block depends on it.
pub fn coordinate_readings(plan: &Plan, setup: &Setup) -> ReadingSet {
    if plan.words.inch {
        ReadingSet::default().with(setup.readings.inch_conversion)
    } else {
        ReadingSet::default()
    }
}

/// Where a motion leads the machine; the second value tells whether a limit replaced a coordinate.
fn goal(element: &Element, tested: Tested, state: &State) -> Outcome<(Amounts, bool)> {
    let axes = element.axes;
    let wanted = state.frame.to_machine(element.target);
    let mut machine = state.frame.machine;
    let mut replaced = false;
    let limits = state.limits;
    let plane = |moves| match tested {
        Tested::Commanded => moves,
        Tested::Plane => true,
        Tested::OutsidePlane | Tested::Nothing => false,
    };
    let commanded = [
        (axes.x, plane(axes.x), &limits.x, wanted.x, &mut machine.x),
        (axes.z, plane(axes.z), &limits.z, wanted.z, &mut machine.z),
        (axes.w, axes.w && tested != Tested::Nothing, &limits.w, wanted.w, &mut machine.w),
    ];
    for (moves, tested, limit, wanted, place) in commanded {
        let target = if moves { wanted } else { *place };
        *place = match element.shape {
            _ if !tested => target,
            Shape::Arc { .. } => limit.check(target).map(|()| target)?,
            Shape::Rapid | Shape::Line => {
                let (allowed, exceeds) = limit.clamp(target)?;
                replaced |= exceeds;
                allowed
            }
        };
    }
    if axes.c.is_some() {
        machine.c = wanted.c;
    }
    Ok((machine, replaced))
}

/// The present position as the end of a motion.
pub fn standing(c_travel: Option<i64>, state: &State) -> Motion {
    let (c_joined, w_axis) = (state.c_joined(), state.setup.options.w_axis);
    Motion {
        program: position(state.frame.program(), c_joined, w_axis),
        machine: position(state.frame.machine, c_joined, w_axis),
        c_travel: c_travel.map(Angle),
        ..Motion::default()
    }
}

/// E100L-CSS-01, E100L-CSS-05: the motion event with the spindle speed at its end. E100L-AX4-08: while the saddle moves
/// that is not the reference, nobody knows where the other one is.
pub fn with_speed(mut event: Emission, rapid: bool, state: &State) -> Emission {
    if !state.is_reference() {
        return event.rule_if(state.modes.cutting_speed(), AX4_08);
    }
    match motion_speed(state.frame.program().x, state) {
        None => event,
        Some(speed) => {
            if let Action::Rapid { motion }
            | Action::Linear { motion, .. }
            | Action::Arc { motion, .. }
            | Action::ContourArc { motion, .. }
            | Action::Thread { motion, .. } = &mut event.action
            {
                motion.speed = Some(speed.speed);
            }
            let rules = event.rules.with(if rapid { CSS_05 } else { CSS_01 }).union(speed.rules());
            Emission { rules, ..event }.readings(speed.readings())
        }
    }
}

/// The length on which the feed of a line is measured, with its rules and its reading.
///
/// E100L-G01-04 without C; E100L-CFEED-01, E100L-CFEED-03 with C: travels of diameters, and 360 degrees count
/// as 500 mm.
pub fn feed_path(
    from: Amounts,
    to: Amounts,
    c_travel: Option<i64>,
    setup: &Setup,
) -> (Length, RuleSet, ReadingSet) {
    let (x, z, w) = (whole(to.x - from.x), whole(to.z - from.z), whole(to.w - from.w));
    let (x, c, rules, readings) = match c_travel {
        Some(travel) => {
            (x, ratio(travel * 25, 18), RuleSet::of(&[CFEED_01, CFEED_03]), ReadingSet::default())
        }
        None => {
            let reading = setup.readings.feed_length;
            let x = if reading == FeedLength::Radius { x / whole(2) } else { x };
            (x, whole(0), RuleSet::of(&[G01_04]), ReadingSet::default().with(reading))
        }
    };
    let square = &x * &x + &z * &z + &w * &w + &c * &c;
    let length = real::nearest_whole(|precision| Interval::of(&square, precision).sqrt());
    (Length(crate::quantity::narrow(&length)), rules, readings)
}

/// E100L-G01-01, E100L-G01-02: what a line of G01 cites.
pub const LINEAR: RuleSet = RuleSet::of(&[G01_01, G01_02]);

/// Carries a motion out. A block without the word of an axis has none that counts as its last (E100L-TUNC-02).
pub fn carry_out(element: &Element, way: Way, plan: &Plan, state: &mut State) -> Outcome<Emission> {
    if way.limits != Tested::Nothing {
        element.check_range(state.setup)?;
    }
    let feed = element.feed(state)?;
    let before = state.frame.machine;
    let (machine, replaced) = goal(element, way.limits, state)?;
    if way.barriers {
        barrier::check(element, state.frame.program(), state.frame.to_program(machine), state)?;
    }
    state.frame.machine = machine;
    if plan.moves {
        state.cut_last = feed.is_some();
    }
    state.contour.wind(element.axes.c);
    let motion = standing(element.axes.c, state);
    let rules = element.rules.union(coordinate_rules(plan));
    let readings = element.readings.union(coordinate_readings(plan, state.setup));
    let from = Amounts { x: way.from.0, z: way.from.1, ..before };
    let event = event(element.shape, motion, feed, from, rules, state).readings(readings);
    let event = barrier::tested(event, element, state);
    Ok(with_speed(event.rule_if(replaced, LIM_01), element.shape == Shape::Rapid, state))
}

/// The event of a motion from a machine position to the present one; without a feed it is rapid.
pub fn event(
    shape: Shape,
    motion: Motion,
    feed: Option<(Feed, RuleSet)>,
    from: Amounts,
    rules: RuleSet,
    state: &State,
) -> Emission {
    let rules = if state.frame.mirrored { rules.with(MIRR_05) } else { rules };
    let event = |action, rules| state.lap.marked(Emission::new(action, rules));
    let Some((feed, feed_rules)) = feed else { return event(Action::Rapid { motion }, rules) };
    let rules = rules.union(feed_rules);
    if let Shape::Arc { centre, sense } = shape {
        let (centre_x, centre_z) = (Length(centre.0), Length(centre.1));
        return event(Action::Arc { motion, feed, sense, centre_x, centre_z }, rules);
    }
    let c_travel = motion.c_travel.map(|travel| travel.0);
    let (path, path_rules, readings) = feed_path(from, state.frame.machine, c_travel, state.setup);
    event(Action::Linear { motion, feed, path }, rules.union(path_rules)).readings(readings)
}
