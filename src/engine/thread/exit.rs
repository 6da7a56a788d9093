//! The run-out chamfer at the end of a pass (E100L-TCHM-02 to E100L-TCHM-04; execution of threads, 5).
//!
//! Lengths along the lead axis are doubled, so that half a diameter is whole.

use turnspec_oracle::vocabulary::rule_ids as rules;
use turnspec_oracle::vocabulary::{SpeedLimit, SpindleState};

use crate::engine::Interpreter;
use crate::engine::arithmetic::run_out;
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
    pub(super) fn exit(&mut self, run: &Run, word: Option<i64>) -> Result<Option<Exit>, Fault> {
        let length = word.map_or(i128::from(run.lead.start), |length| PICO * i128::from(length));
        if length == 0 {
            return Ok(None);
        }
        if run_out::is_too_long(length, run.axes.twice_length(run.begin, run.end)) {
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
        let from = run_out::begin(end, way, length, axes.lead_halves());
        let (whole, rest) = (axes.twice_length(self.begin, end), axes.twice_length(from, end));
        let level = run_out::level_at(self.first, self.last, whole, rest);
        let pitch = lead.at(if planted::is(Bug::ChamferOfFirstLead) { 0 } else { whole - rest });
        let unit = run_out::unit(rate, axes.level_halves());
        let (rise, turn) = (run_out::rise(unit, rest), run_out::turn(speed, pitch));
        let room = side * (i128::from(start_level) - i128::from(level));
        if !run_out::reaches_start(room, rise, turn) || planted::is(Bug::ChamferBeyondStart) {
            let above = side * (i128::from(level) - i128::from(self.last));
            if run_out::is_deeper(above, rise, turn) && !planted::is(Bug::OpeningTaperAllowed) {
                return Err(unspecified(rules::TCHM_04, "taper"));
            }
            let first = ((end, run_out::withdrawn(level, side, rise, turn)), pitch);
            return Ok(Exit { begin: (from, level), first, second: None, clamped: false });
        }
        let reached = run_out::reached(from, way, room, turn, unit, axes.lead_halves());
        let later = lead.at(axes.twice_length(self.begin, reached));
        Ok(Exit {
            begin: (from, level),
            first: ((reached, start_level), pitch),
            second: Some(((end, start_level), later)),
            clamped: false,
        })
    }
}
