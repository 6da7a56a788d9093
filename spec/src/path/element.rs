//! Elements of the path: what every motion has in common.

use crate::controls::e100l::units;
use crate::emission::Emission;
use crate::fault::{Outcome, fail};
use crate::frame::{Amounts, position};
use crate::modal::{Plan, motion_speed};
use crate::quantity::{ratio, whole};
use crate::real::{self, Interval};
use crate::state::State;
use crate::vocabulary::rule_ids::*;
use crate::vocabulary::{Action, AlarmName, Angle, FeedLength, Length, Motion, ReadingSet, RuleSet, Setup};

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

/// What happens to a target beyond its range or a travel limit.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Beyond {
    /// The positive limit replaces it (E100L-LIM-01).
    Replaced,
    /// It alarms.
    Refused,
    /// It was tested before.
    Allowed,
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
    if plan.words.get('X').is_some() {
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

/// Moves the machine to a program position and describes the motion; the second result tells whether a limit
/// replaced a coordinate.
pub fn go(target: Amounts, axes: Axes, beyond: Beyond, state: &mut State) -> Outcome<(Motion, bool)> {
    let wanted = state.frame.to_machine(target);
    let mut machine = state.frame.machine;
    let mut replaced = false;
    let limits = state.limits;
    let commanded = [
        (axes.x, &limits.x, wanted.x, &mut machine.x),
        (axes.z, &limits.z, wanted.z, &mut machine.z),
        (axes.w, &limits.w, wanted.w, &mut machine.w),
    ];
    for (moves, limit, wanted, place) in commanded {
        if moves {
            let (allowed, exceeds) = match beyond {
                Beyond::Replaced => limit.clamp(wanted)?,
                Beyond::Refused => (limit.check(wanted).map(|()| wanted)?, false),
                Beyond::Allowed => (wanted, false),
            };
            *place = allowed;
            replaced |= exceeds;
        }
    }
    if axes.c.is_some() {
        machine.c = wanted.c;
    }
    state.frame.machine = machine;
    let program = state.frame.program();
    let (c_joined, w_axis) = (state.c_joined(), state.setup.options.w_axis);
    let motion = Motion {
        program: position(program, c_joined, w_axis),
        machine: position(machine, c_joined, w_axis),
        c_travel: axes.c.map(Angle),
        tip: None,
        nose: None,
        speed: None,
    };
    Ok((motion, replaced))
}

/// E100L-CSS-01, E100L-CSS-05: the motion event with the spindle speed at its end.
pub fn with_speed(mut event: Emission, rapid: bool, state: &State) -> Emission {
    match motion_speed(state.frame.program().x, state) {
        None => event,
        Some(speed) => {
            if let Action::Rapid { motion } | Action::Linear { motion, .. } | Action::Arc { motion, .. } =
                &mut event.action
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

/// A line at a feed to a program position, for these rules.
pub fn line(
    target: Amounts,
    axes: Axes,
    beyond: Beyond,
    rules: RuleSet,
    plan: &Plan,
    state: &mut State,
) -> Outcome<Emission> {
    if beyond != Beyond::Allowed {
        check_range(target, axes, state.setup)?;
    }
    let (feed, feed_rules) = crate::modal::active_feed(state)?;
    let from = state.frame.machine;
    let (motion, replaced) = go(target, axes, beyond, state)?;
    let (path, path_rules, path_readings) = feed_path(from, state.frame.machine, axes.c, state.setup);
    state.cut_last = true;
    let rules = rules.union(feed_rules).union(coordinate_rules(plan)).union(path_rules);
    let event = Emission::new(Action::Linear { motion, feed, path }, rules)
        .readings(path_readings)
        .readings(coordinate_readings(plan, state.setup))
        .rule_if(replaced, LIM_01);
    Ok(with_speed(event, false, state))
}
