//! Where one pass of G31, G32, G33, G71 or G72 goes (execution of threads, 5; E100L-G33-04 to E100L-G33-09).

use turnspec_oracle::vocabulary::rule_ids as rules;
use turnspec_oracle::vocabulary::{AlarmName, LeadAxis, TaperReference, ThreadShift};

use crate::engine::Interpreter;
use crate::engine::angle::{self, HALF_TURN};
use crate::engine::exact::round;
use crate::engine::fault::Fault;
use crate::engine::planted::{self, Bug};

use super::axis::Axes;
use super::exit::{Exit, Run};
use super::lead::Lead;
use super::unspecified;

/// The taper of a thread.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Taper {
    /// The level at the end less that at the start; zero without taper.
    Amount(i64),
    /// The inclination in micro-degrees.
    Angle(i64),
}

/// What a pass is given by. Coordinates are program coordinates.
#[derive(Clone, Copy, Debug)]
pub struct Pass {
    pub axes: Axes,
    /// The cycle start: along the lead axis, and its level.
    pub start: (i64, i64),
    /// The end along the lead axis.
    pub end: i64,
    pub level: i64,
    /// The side on which the cycle start lies: 1 above the level, -1 below it.
    pub side: i64,
    pub taper: Taper,
    /// The word that shifts the start.
    pub shift: i64,
    /// The shift along the lead axis as a whole.
    pub flank: i64,
    pub lead: Lead,
    /// The L word.
    pub run_out: Option<i64>,
}

/// Where a pass goes: along the lead axis, and its level.
#[derive(Clone, Copy, Debug)]
pub struct Route {
    pub approach: (i64, i64),
    /// The end of the cut.
    pub cut: (i64, i64),
    pub exit: Option<Exit>,
    /// Where the lead axis stands when the other one withdraws.
    pub end: i64,
    /// Whether the level changes along the thread.
    pub tapers: bool,
}

impl Interpreter<'_> {
    /// Computes a pass; its alarms come before its first motion.
    pub(super) fn route(&mut self, pass: &Pass) -> Result<Route, Fault> {
        let Pass { axes, start: (start, start_level), end, level, side, lead, flank, .. } = *pass;
        let direction = end.saturating_sub(start).signum();
        if direction == 0 {
            return Err(unspecified(rules::G33_04, "length"));
        }
        let begin = match self.setup.readings.thread_shift {
            ThreadShift::TowardEnd => start.saturating_add(direction.saturating_mul(pass.shift)),
            ThreadShift::Coordinate => start.saturating_add(pass.shift),
        };
        if end.saturating_sub(begin).signum() != direction {
            return Err(unspecified(rules::G33_04, "length"));
        }
        let from = if planted::is(Bug::TaperFromCycleStart) { start } else { begin };
        let taper = self.taper(pass, end.saturating_sub(from))?;
        let (first, last) = match self.setup.readings.taper_reference {
            TaperReference::Start => (level, level.saturating_add(taper)),
            TaperReference::End => (level.saturating_sub(taper), level),
        };
        let clear = |level: i64| start_level.saturating_sub(level).signum() == side;
        if side == 0 || !clear(first) || !clear(last) {
            return Err(unspecified(rules::G33_04, "side"));
        }
        if !planted::is(Bug::LastLeadUntested) {
            lead.check_end(axes.twice_length(begin, end))?;
        }
        let (begin, end) = (begin.saturating_add(flank), end.saturating_add(flank));
        let exit = if self.state.thread.chamfer {
            let run = Run { axes, begin, end, first, last, side, start_level, direction, lead };
            self.exit(&run, pass.run_out)?
        } else {
            None
        };
        Ok(Route {
            approach: (begin, first),
            cut: exit.as_ref().map_or((end, last), |exit| exit.begin),
            exit,
            end,
            tapers: taper != 0,
        })
    }

    /// How much the level changes over a way along the lead axis, latched.
    fn taper(&mut self, pass: &Pass, along: i64) -> Result<i64, Fault> {
        let angle = match pass.taper {
            Taper::Amount(amount) => return Ok(amount),
            Taper::Angle(angle) => angle,
        };
        let to_x = pass.axes.lead == LeadAxis::Z;
        let parallel = if to_x { HALF_TURN / 2 } else { 0 };
        if angle.rem_euclid(HALF_TURN) == parallel {
            return Fault::raise(AlarmName::AngleNoIntersection, rules::G33_06);
        }
        Ok(round(&angle::Taper { from: 0, along, angle, to_x }, &mut self.slow))
    }
}
