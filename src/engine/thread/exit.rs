//! The run-out chamfer at the end of a pass (E100L-TCHM-02 to E100L-TCHM-04; execution of threads, 5).
//!
//! Lengths along the lead axis are doubled, so that half a diameter is whole.

use turnspec_oracle::vocabulary::rule_ids as rules;
use turnspec_oracle::vocabulary::{SpeedLimit, SpindleState};

use crate::engine::Interpreter;
use crate::engine::arithmetic::root::narrow;
use crate::engine::arithmetic::round::Rounding;
use crate::engine::fault::Fault;
use crate::engine::planted::{self, Bug};
use crate::engine::state::X;

use super::axis::Axes;
use super::lead::Lead;
use super::unspecified;

/// The thread that runs out: from where it begins to its end, with its levels there.
#[derive(Clone, Copy, Debug)]
pub struct Run {
    pub axes: Axes,
    pub begin: i64,
    pub end: i64,
    pub first: i64,
    pub last: i64,
    /// The side of the cycle start, and its level.
    pub side: i64,
    pub start_level: i64,
    /// 1 or -1 along the lead axis.
    pub direction: i64,
    pub lead: Lead,
}

/// A motion of the exit: where to, and the lead with which it begins.
pub type Leg = ((i64, i64), i64);

/// The run-out chamfer.
#[derive(Clone, Copy, Debug)]
pub struct Exit {
    /// Where it begins.
    pub begin: (i64, i64),
    pub first: Leg,
    /// When the level of the cycle start is reached before the end.
    pub second: Option<Leg>,
    /// Whether the clamp of G50 S lowered the speed.
    pub clamped: bool,
}

/// Picometres of a nanometre.
const PICO: i128 = 1000;

impl Interpreter<'_> {
    /// The exit of a thread, by its L word; none of no length.
    pub(super) fn exit(&mut self, run: &Run, run_out: Option<i64>) -> Result<Option<Exit>, Fault> {
        let length = run_out.map_or(i128::from(run.lead.start), |length| PICO * i128::from(length));
        if length == 0 {
            return Ok(None);
        }
        if 2 * length > PICO * run.axes.twice_length(run.begin, run.end) {
            return Err(unspecified(rules::TCHM_02, "chamfer"));
        }
        let turns = matches!(self.state.spindle, SpindleState::Clockwise | SpindleState::CounterClockwise);
        let choice = self.spindle_speed(self.state.program(X));
        if !turns || choice.value == 0 {
            return Err(unspecified(rules::TCHM_03, "speed"));
        }
        let feed = self.setup.parameters.thread_chamfer_feed;
        let rate = i128::from(if planted::is(Bug::RateOfParameterLost) { 640 } else { feed });
        let exit = run.exit(length, rate, choice.value)?;
        Ok(Some(Exit { clamped: choice.limit == Some(SpeedLimit::Clamp), ..exit }))
    }
}

impl Run {
    /// The exit over a length in picometres, at a parameter of the withdrawal rate and a speed in thousandths of a
    /// revolution per minute.
    fn exit(&self, length: i128, rate: i128, speed: i64) -> Result<Exit, Fault> {
        let Self { axes, end, side, start_level, direction, lead, .. } = *self;
        let (side, way) = (i128::from(side), i128::from(direction));
        let back = 2 * length / axes.lead_halves();
        let from = narrow(Rounding::HalfAway.divide(PICO * i128::from(end) - way * back, PICO));
        let rest = axes.twice_length(from, end);
        let level = self.level_at(rest);
        let along = axes.twice_length(self.begin, end) - rest;
        let pitch = lead.at(if planted::is(Bug::ChamferOfFirstLead) { 0 } else { along });
        // The withdrawal is `rise / turn`: 4.6875 mm/min are 4 687 500 nm/min, halved with the doubled length, and
        // 10^6 with the thousandths of a revolution and the picometres of the lead.
        let unit = 2_343_750_000_000 * rate * (2 / axes.level_halves());
        let (rise, turn) = (unit * rest, i128::from(speed) * i128::from(pitch));
        let room = side * (i128::from(start_level) - i128::from(level));
        if room.saturating_mul(turn) > rise || planted::is(Bug::ChamferBeyondStart) {
            let below = side * (i128::from(level) - i128::from(self.last));
            if below.saturating_mul(turn).saturating_add(rise) < 0 && !planted::is(Bug::OpeningTaperAllowed) {
                return Err(unspecified(rules::TCHM_04, "taper"));
            }
            let withdrawn = i128::from(level).saturating_mul(turn).saturating_add(side * rise);
            let first = ((end, narrow(Rounding::HalfAway.divide(withdrawn, turn))), pitch);
            return Ok(Exit { begin: (from, level), first, second: None, clamped: false });
        }
        // The level of the start is reached where rise and way have the same share of the whole.
        let whole = unit * axes.lead_halves();
        let reached = i128::from(from).saturating_mul(whole) + way * room.saturating_mul(turn);
        let reached = narrow(Rounding::HalfAway.divide(reached, whole));
        let later = lead.at(axes.twice_length(self.begin, reached));
        Ok(Exit {
            begin: (from, level),
            first: ((reached, start_level), pitch),
            second: Some(((end, start_level), later)),
            clamped: false,
        })
    }

    /// The level at twice a distance before the end, latched.
    fn level_at(&self, rest: i128) -> i64 {
        let whole = self.axes.twice_length(self.begin, self.end);
        let (first, last) = (i128::from(self.first), i128::from(self.last));
        narrow(Rounding::HalfAway.divide(first * whole + (last - first) * (whole - rest), whole))
    }
}
