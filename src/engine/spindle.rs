//! S, SA, SB and the spindle speed (execution, chapter 8).

use std::cmp::Ordering;

use turnspec_oracle::vocabulary::rule_ids::*;
use turnspec_oracle::vocabulary::{
    Action, CuttingSpeed, Label, ReadingSet, RuleSet, Sink, Speed, SpeedClamp, SpeedLimit, Spindle,
    SpindleName, SpindleState,
};

use super::Interpreter;
use super::arithmetic::speed::{SpeedChoice, surface, thousandths};
use super::block::{OneShot, Plan};
use super::exact::{Formula, Real, round, sign};
use super::fault::Fault;
use super::planted::{self, Bug};
use super::sides::Common;
use super::words::{Address, Words};

/// Thousandths of a revolution per minute at a cutting speed (µm/min) on a diameter (nm), less a speed:
/// 10^6 v / (π x) - n.
struct CuttingRate {
    surface: i64,
    diameter: i64,
    less: i64,
}

impl Formula for CuttingRate {
    fn value<R: Real>(&self, precision: R::Precision) -> R {
        let path = R::integer(i128::from(self.surface) * 1_000_000, precision);
        let circumference = R::integer(self.diameter.into(), precision).times(&R::pi(precision));
        path.over(&circumference).minus(&R::integer(self.less.into(), precision))
    }
}

/// The label of an active gear, empty for none.
fn gear_label(code: u16) -> Label {
    if code == 0 { Label::default() } else { Label::of_code(b'M', code) }
}

impl Interpreter<'_> {
    /// The speed of the turning main spindle at a program diameter.
    pub(super) fn spindle_speed(&mut self, diameter: i64) -> SpeedChoice {
        let clamp = self.state.clamp;
        if !self.state.constant_speed {
            let acts = self.setup.readings.speed_clamp == SpeedClamp::Always;
            let equal = planted::is(Bug::ClampInclusive) && acts && clamp == Some(self.state.speed);
            let limit = equal.then_some(SpeedLimit::Clamp);
            let commanded = SpeedChoice { value: self.state.speed, limit };
            return commanded.clamped(clamp.filter(|_| acts));
        }
        let spindle = &self.setup.spindle;
        let gear = spindle.gear.iter().find(|gear| u16::from(gear.code) == self.state.gear);
        let (minimum, maximum) =
            gear.map_or((spindle.minimum, spindle.maximum), |gear| (gear.minimum, gear.maximum));
        let choice = |value, limit| SpeedChoice { value, limit };
        let geared = if self.compare_rate(diameter, maximum.0) == Ordering::Greater {
            choice(maximum.0, Some(SpeedLimit::GearMaximum))
        } else if self.compare_rate(diameter, minimum.0) == Ordering::Less
            && !planted::is(Bug::GearMinimumLost)
        {
            choice(minimum.0, Some(SpeedLimit::GearMinimum))
        } else if clamp.is_some_and(|clamp| self.compare_rate(diameter, clamp) == Ordering::Greater) {
            return choice(clamp.unwrap_or_default(), Some(SpeedLimit::Clamp));
        } else {
            if self.state.surface.0 == 0 {
                return choice(0, None);
            }
            let rate = self.rate(diameter, 0);
            return choice(round(&rate, &mut self.slow), None);
        };
        geared.clamped(clamp.filter(|_| !planted::is(Bug::ClampIgnored)))
    }

    fn rate(&self, diameter: i64, less: i64) -> CuttingRate {
        let diameter = i64::try_from(diameter.unsigned_abs()).unwrap_or(i64::MAX);
        CuttingRate { surface: self.state.surface.0, diameter, less }
    }

    /// Compares the unlimited speed with a bound; on the centre line it has no bound.
    fn compare_rate(&mut self, diameter: i64, bound: i64) -> Ordering {
        if self.state.surface.0 == 0 {
            return 0.cmp(&bound);
        }
        if diameter == 0 {
            return Ordering::Greater;
        }
        let rate = self.rate(diameter, bound);
        sign(&rate, &mut self.slow)
    }

    /// S, SA and SB.
    pub(super) fn speeds(&mut self, words: &Words, plan: Plan, sink: &mut impl Sink) -> Result<(), Fault> {
        if let Some(speed) = words.get(Address::S)
            && plan.one_shot != OneShot::ZeroShift
            && self.common() != Common::Done
        {
            let mut rules = const { RuleSet::of(&[SPD_01]) };
            if plan.moves {
                rules = rules.with(SPD_02);
            }
            if self.state.constant_speed {
                self.state.surface = CuttingSpeed(surface(speed, self.units.surface));
            } else {
                self.state.speed = thousandths(speed);
                rules = rules.with(CSS_02);
            }
            let (rules, with_motion) = answer(words, plan, rules);
            self.emit_main_spindle(sink, rules, with_motion, None);
            self.check_time(self.setup.stm.s)?;
        }
        if let Some(speed) = words.get(Address::SA) {
            self.state.cycle.c_speed = Some(speed);
            let spindle = plain(SpindleName::CAxis, SpindleState::Stop, speed, Label::default());
            self.emit(sink, const { RuleSet::of(&[CAX_08]) }, Action::Spindle(spindle));
        }
        if let Some(speed) = words.get(Address::SB) {
            self.state.tool_speed = thousandths(speed);
            self.emit_tool_spindle(sink, const { RuleSet::of(&[SB_01, SB_02]) });
        }
        Ok(())
    }

    /// A spindle event of the main spindle in its present state, of a common word of the block.
    pub(super) fn emit_main_spindle(
        &mut self,
        sink: &mut impl Sink,
        rules: RuleSet,
        with_motion: bool,
        clamp: Option<i64>,
    ) {
        let rules = if self.common() == Common::ForBoth { rules.with(AX4_06) } else { rules };
        self.show_main_spindle(sink, rules, with_motion, clamp);
    }

    /// A spindle event of the main spindle in its present state.
    pub(super) fn show_main_spindle(
        &mut self,
        sink: &mut impl Sink,
        mut rules: RuleSet,
        with_motion: bool,
        clamp: Option<i64>,
    ) {
        let turns = matches!(self.state.spindle, SpindleState::Clockwise | SpindleState::CounterClockwise);
        let choice = if turns {
            self.spindle_speed(self.reference_x())
        } else {
            SpeedChoice { value: 0, limit: None }
        };
        let constant = self.state.constant_speed;
        if constant {
            rules = rules.with(CSS_01);
        }
        let mut readings = ReadingSet::default();
        match choice.limit {
            Some(SpeedLimit::Clamp) => {
                rules = rules.with(SMAX_01);
                readings = self.known.clamp;
            }
            Some(_) => rules = rules.with(CSS_04),
            None => {}
        }
        let spindle = Spindle {
            spindle: SpindleName::Main,
            state: self.state.spindle,
            speed: Speed(choice.value),
            surface: constant.then_some(self.state.surface),
            limit: choice.limit,
            gear: gear_label(self.state.gear),
            clamp: clamp.map(Speed),
            with_motion,
        };
        self.emit_with(sink, rules, readings, Action::Spindle(spindle));
    }

    /// A spindle event of the rotary tool in its present state.
    pub(super) fn emit_tool_spindle(&mut self, sink: &mut impl Sink, rules: RuleSet) {
        let state = self.state.tool_spindle;
        let speed = if state == SpindleState::Stop { 0 } else { self.state.tool_speed };
        let spindle = plain(SpindleName::Tool, state, speed, gear_label(self.state.tool_gear));
        self.emit(sink, rules, Action::Spindle(spindle));
    }
}

fn plain(spindle: SpindleName, state: SpindleState, speed: i64, gear: Label) -> Spindle {
    Spindle {
        spindle,
        state,
        speed: Speed(speed),
        surface: None,
        limit: None,
        gear,
        clamp: None,
        with_motion: false,
    }
}

/// What M63 adds to a spindle event of its block, or its absence in a motion block.
pub fn answer(words: &Words, plan: Plan, rules: RuleSet) -> (RuleSet, bool) {
    if words.has_m(63) {
        (rules.with(M63_02), plan.moves || planted::is(Bug::AnswerWithoutMotion))
    } else if plan.moves {
        (rules.with(M63_01), false)
    } else {
        (rules, false)
    }
}
