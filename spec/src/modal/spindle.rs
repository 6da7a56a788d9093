//! Spindle speeds (E100L-CSS-01 to -05, E100L-SMAX-01, E100L-SMAX-02, E100L-SPD-01 to -05, E100L-SB-01 to -04).

use std::cmp::Ordering;

use crate::emission::Emission;
use crate::quantity::{Exact, narrow, round_narrow, whole};
use crate::real::{self, Interval};
use crate::state::State;
use crate::vocabulary::rule_ids::*;
use crate::vocabulary::{
    Action, CuttingSpeed, Label, ReadingSet, RuleSet, Speed, SpeedClamp, SpeedLimit, Spindle, SpindleName,
    SpindleState,
};

/// A computed speed and what limited it.
#[derive(Clone, Copy, Debug)]
pub struct MotionSpeed {
    /// The speed.
    pub speed: Speed,
    limit: Option<SpeedLimit>,
    clamp_reading: SpeedClamp,
}

impl MotionSpeed {
    /// The rules of its limit.
    pub fn rules(&self) -> RuleSet {
        match self.limit {
            None => RuleSet::EMPTY,
            Some(SpeedLimit::Clamp) => RuleSet::of(&[SMAX_01]),
            Some(_) => RuleSet::of(&[CSS_04]),
        }
    }

    /// E100L-SMAX-02: the reading of the clamp, where it acted.
    pub fn readings(&self) -> ReadingSet {
        match self.limit {
            Some(SpeedLimit::Clamp) => ReadingSet::default().with(self.clamp_reading),
            _ => ReadingSet::default(),
        }
    }
}

/// The speed that G96 commands at a diameter in nanometres; none in G97.
pub fn motion_speed(diameter: i64, state: &State) -> Option<MotionSpeed> {
    state.modes.cutting_speed().then(|| speed(diameter, state))
}

/// The commanded speed of the main spindle while it turns.
pub fn turning_speed(state: &State) -> Option<MotionSpeed> {
    let turns = matches!(state.spindle.main, SpindleState::Clockwise | SpindleState::CounterClockwise);
    turns.then(|| speed(state.reference_x(), state))
}

/// The speed of the turning main spindle.
fn speed(diameter: i64, state: &State) -> MotionSpeed {
    let cutting_speed = state.modes.cutting_speed();
    let mut turning =
        if cutting_speed { commanded(diameter, state) } else { Turning::Whole(state.spindle.speed) };
    let mut limit = None;
    if cutting_speed {
        // E100L-CSS-04.
        let (minimum, maximum) = gear_range(state);
        if turning.compare(maximum).is_gt() {
            (turning, limit) = (Turning::Whole(maximum), Some(SpeedLimit::GearMaximum));
        } else if turning.compare(minimum).is_lt() {
            (turning, limit) = (Turning::Whole(minimum), Some(SpeedLimit::GearMinimum));
        }
    }
    // E100L-SMAX-01, E100L-SMAX-02.
    let reading = state.setup.readings.speed_clamp;
    let acts = reading == SpeedClamp::Always || cutting_speed;
    if let Some(clamp) = state.spindle.clamp.filter(|_| acts)
        && turning.compare(clamp).is_gt()
    {
        (turning, limit) = (Turning::Whole(clamp), Some(SpeedLimit::Clamp));
    }
    MotionSpeed { speed: Speed(turning.rounded()), limit, clamp_reading: reading }
}

/// A speed in thousandths of a revolution per minute, before it is rounded.
enum Turning {
    /// A whole number of them.
    Whole(i64),
    /// This number divided by π.
    OverPi(Exact),
    /// More than every bound.
    Unbounded,
}

impl Turning {
    fn over_pi(number: &Exact, precision: usize) -> Interval {
        Interval::of(number, precision).div(&real::pi(precision))
    }

    fn compare(&self, bound: i64) -> Ordering {
        match self {
            Self::Whole(speed) => speed.cmp(&bound),
            Self::OverPi(number) => {
                let bound = whole(bound);
                real::sign(|precision| Self::over_pi(number, precision).sub(&Interval::of(&bound, precision)))
            }
            Self::Unbounded => Ordering::Greater,
        }
    }

    fn rounded(&self) -> i64 {
        match self {
            Self::Whole(speed) => *speed,
            Self::OverPi(number) => {
                narrow(&real::nearest_whole(|precision| Self::over_pi(number, precision)))
            }
            Self::Unbounded => i64::MAX,
        }
    }
}

/// E100L-CSS-01: n = 1000 v / (π d).
fn commanded(diameter: i64, state: &State) -> Turning {
    let surface = state.spindle.surface;
    match (surface, diameter) {
        (0, _) => Turning::Whole(0),
        (_, 0) => Turning::Unbounded,
        // v in µm/min, d in nm: 1000 v / d turns a minute, times 1000.
        _ => Turning::OverPi(whole(surface) * whole(1_000_000) / whole(diameter.abs())),
    }
}

/// Lowest and highest speed of the active gear (E100L-SPD-05), of the spindle without one.
fn gear_range(state: &State) -> (i64, i64) {
    let setup = &state.setup.spindle;
    let gear = state.active("gear");
    let entry = setup.gear.iter().find(|entry| Some(u16::from(entry.code)) == gear);
    let (minimum, maximum) =
        entry.map_or((setup.minimum, setup.maximum), |entry| (entry.minimum, entry.maximum));
    (minimum.0, maximum.0)
}

/// The event of a main spindle command: its state as it is now.
pub fn main_event(rules: RuleSet, with_motion: bool, state: &State) -> Emission {
    let computed = turning_speed(state);
    let cutting_speed = state.modes.cutting_speed();
    let spindle = Spindle {
        spindle: SpindleName::Main,
        state: state.spindle.main,
        speed: computed.map_or(Speed(0), |computed| computed.speed),
        surface: cutting_speed.then_some(CuttingSpeed(state.spindle.surface)),
        limit: computed.and_then(|computed| computed.limit),
        gear: state.active("gear").map_or(Label::default(), |code| Label::of_code(b'M', code)),
        clamp: None,
        with_motion,
    };
    let event = Emission::new(Action::Spindle(spindle), rules).rule_if(cutting_speed, CSS_01);
    match computed {
        Some(computed) => {
            let rules = event.rules.union(computed.rules());
            Emission { rules, ..event }.readings(computed.readings())
        }
        None => event,
    }
}

/// The event of `G50 S`: as a main spindle command, with the new clamp.
pub fn clamp_event(rules: RuleSet, state: &State) -> Emission {
    let mut event = main_event(rules, false, state);
    if let Action::Spindle(spindle) = &mut event.action {
        spindle.clamp = state.spindle.clamp.map(Speed);
    }
    event
}

/// The event of a rotary tool command.
pub fn tool_event(rules: RuleSet, state: &State) -> Emission {
    let turning = state.spindle.tool != SpindleState::Stop;
    let gear = state.active("tool_gear").map_or(Label::default(), |code| Label::of_code(b'M', code));
    plain_event(
        SpindleName::Tool,
        state.spindle.tool,
        if turning { state.spindle.tool_speed } else { 0 },
        gear,
        rules,
    )
}

/// E100L-CAX-08: the event of SA.
pub fn c_axis_event(speed: i64) -> Emission {
    plain_event(SpindleName::CAxis, SpindleState::Stop, speed, Label::default(), RuleSet::of(&[CAX_08]))
}

fn plain_event(
    spindle: SpindleName,
    state: SpindleState,
    speed: i64,
    gear: Label,
    rules: RuleSet,
) -> Emission {
    let spindle = Spindle {
        spindle,
        state,
        speed: Speed(speed),
        surface: None,
        limit: None,
        gear,
        clamp: None,
        with_motion: false,
    };
    Emission::new(Action::Spindle(spindle), rules)
}

/// E100L-SPD-01: S is a cutting speed in G96, a speed in G97.
pub fn store_s(value: i64, state: &mut State) {
    if state.modes.cutting_speed() {
        let unit = crate::controls::e100l::units::cutting_speed(state.setup.unit_system);
        state.spindle.surface = round_narrow(&(whole(value) * unit));
    } else {
        state.spindle.speed = value * 1_000;
    }
}
