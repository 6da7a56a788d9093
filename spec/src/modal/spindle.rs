//! Spindle speeds (E100L-CSS-01 to -05, E100L-SMAX-01, E100L-SMAX-02, E100L-SPD-01 to -05, E100L-SB-01 to -04).

use crate::emission::Emission;
use crate::quantity::{Exact, round_narrow, whole};
use crate::real::{self, Interval};
use crate::state::State;
use crate::vocabulary::rule_ids::*;
use crate::vocabulary::{
    Action, CuttingSpeed, Label, ReadingSet, RuleSet, Speed, SpeedClamp, SpeedLimit, Spindle, SpindleName,
    SpindleState,
};

use super::words::code_label;

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

/// The speed of the turning main spindle.
fn speed(diameter: i64, state: &State) -> MotionSpeed {
    let (commanded, mut limit) = if state.modes.cutting_speed() {
        limited_to_gear(diameter, state)
    } else {
        (state.spindle.speed, None)
    };
    let reading = state.setup.readings.speed_clamp;
    let acts = reading == SpeedClamp::Always || state.modes.cutting_speed();
    let speed = match state.spindle.clamp {
        Some(clamp) if acts && commanded > clamp => {
            limit = Some(SpeedLimit::Clamp);
            clamp
        }
        _ => commanded,
    };
    MotionSpeed { speed: Speed(speed), limit, clamp_reading: reading }
}

/// E100L-CSS-01, E100L-CSS-04: n = v / (π d), held within the gear range; in thousandths of a revolution per
/// minute.
///
/// The clamp is a whole number of them, so that it may be compared after rounding only if rounding up to it
/// is no excess: a speed that rounds to the clamp is the clamp.
fn limited_to_gear(diameter: i64, state: &State) -> (i64, Option<SpeedLimit>) {
    let setup = &state.setup.spindle;
    let gear = state.active("gear");
    let entry = setup.gear.iter().find(|entry| Some(u16::from(entry.code)) == gear);
    let (minimum, maximum) =
        entry.map_or((setup.minimum, setup.maximum), |entry| (entry.minimum, entry.maximum));
    if diameter == 0 {
        return (maximum.0, Some(SpeedLimit::GearMaximum));
    }
    // v in µm/min, d in nm: v·1000/d turns a minute, times 1000.
    let times_pi = whole(state.spindle.surface) * whole(1_000_000) / whole(diameter.abs());
    let exact = |precision| turned(&times_pi, precision);
    let above = |bound: i64| {
        let bound = whole(bound);
        real::sign(|precision| exact(precision).sub(&Interval::of(&bound, precision)))
    };
    if above(maximum.0).is_gt() {
        (maximum.0, Some(SpeedLimit::GearMaximum))
    } else if above(minimum.0).is_lt() {
        (minimum.0, Some(SpeedLimit::GearMinimum))
    } else {
        let nearest = real::nearest_whole(exact);
        (crate::quantity::narrow(&nearest), None)
    }
}

fn turned(times_pi: &Exact, precision: usize) -> Interval {
    Interval::of(times_pi, precision).div(&real::pi(precision))
}

/// The event of a main spindle command: its state as it is now.
pub fn main_event(rules: RuleSet, with_motion: bool, state: &State) -> Emission {
    let turning = matches!(state.spindle.main, SpindleState::Clockwise | SpindleState::CounterClockwise);
    let computed = turning.then(|| speed(state.frame.program().x, state));
    let cutting_speed = state.modes.cutting_speed();
    let spindle = Spindle {
        spindle: SpindleName::Main,
        state: state.spindle.main,
        speed: computed.map_or(Speed(0), |computed| computed.speed),
        surface: cutting_speed.then_some(CuttingSpeed(state.spindle.surface)),
        limit: computed.and_then(|computed| computed.limit),
        gear: state.active("gear").map_or(Label::default(), |code| code_label('M', code)),
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
    let gear = state.active("tool_gear").map_or(Label::default(), |code| code_label('M', code));
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
