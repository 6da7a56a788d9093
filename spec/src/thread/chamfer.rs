//! The run-out chamfer of M23 (E100L-TCHM-01 to -04).

use super::lead::{Lead, length, measure, sign};
use super::motion::{Cited, withdrawal_rate};
use super::pass::{Course, Pass, Spot};
use crate::fault::{Fault, Outcome};
use crate::modal::turning_speed;
use crate::quantity::{Exact, ratio, round_narrow, whole};
use crate::state::State;
use crate::vocabulary::rule_ids::*;
use crate::vocabulary::{AlarmName, LeadAxis};

/// A chamfer that is cut.
#[derive(Clone, Debug)]
pub struct Chamfer {
    /// Its length along the lead axis, in the measure of the lead.
    pub length: Exact,
    /// The speed of the spindle, in thousandths of a revolution per minute.
    speed: i64,
    /// What its events name.
    pub cited: Cited,
}

impl Chamfer {
    /// The chamfer of a pass, if it has one; `word` is L.
    pub fn of(word: Option<i64>, lead: Lead, thread: &Exact, state: &State) -> Outcome<Option<Self>> {
        // E100L-TCHM-01.
        if !state.is_active(23) {
            return Ok(None);
        }
        // E100L-TCHM-02: without L one lead.
        let length = word.map_or_else(|| ratio(lead.first, 1_000), whole);
        if length.is_zero() {
            return Ok(None);
        }
        if length > *thread {
            return Err(Fault::about(AlarmName::Unspecified, TCHM_02, "chamfer"));
        }
        // E100L-TCHM-03.
        let Some(turning) = turning_speed(state).filter(|turning| turning.speed.0 != 0) else {
            return Err(Fault::about(AlarmName::Unspecified, TCHM_03, "speed"));
        };
        let cited = Cited::rules(&[TCHM_01, TCHM_02, TCHM_03, TCHM_04])
            .reading(state.setup.readings.feed_length)
            .and(Cited { rules: turning.rules(), readings: turning.readings() });
        Ok(Some(Self { length, speed: turning.speed.0, cited }))
    }

    /// E100L-TCHM-03: by how much the other axis withdraws on a way of the lead axis, in the measure of a feed.
    fn withdrawal(&self, way: &Exact, lead: i64, state: &State) -> Exact {
        // Thousandths of a revolution per minute.
        let feed = whole(lead) * whole(self.speed) / whole(1_000);
        whole(withdrawal_rate(state.setup)) * way / feed
    }
}

/// E100L-TCHM-04: the motions from the point where the chamfer begins: their ends, and their leads where they begin.
pub fn exits(
    pass: &Pass,
    course: &Course,
    begin: Spot,
    chamfer: &Chamfer,
    state: &State,
) -> Outcome<Vec<(Spot, i64)>> {
    let (axis, lead) = (pass.thread.axis, pass.thread.lead);
    let way = |from, to| length(axis, from, to, state.setup);
    let first_lead = lead.at(&way(course.from.lead, begin.lead));
    let withdrawn = chamfer.withdrawal(&way(begin.lead, course.to.lead), first_lead, state);
    // As a difference of coordinates.
    let rise = withdrawn / measure(axis == LeadAxis::Z, state.setup);
    let side = whole(pass.side);
    let level = whole(begin.level) + &side * &rise;
    if sign(&(&side * (whole(pass.start.level) - &level))) > 0 {
        if sign(&(&side * (&level - whole(course.to.level)))) < 0 {
            return Err(Fault::about(AlarmName::Unspecified, TCHM_04, "taper"));
        }
        return Ok(vec![(Spot { lead: course.to.lead, level: round_narrow(&level) }, first_lead)]);
    }
    // The level of the cycle start is reached on the way.
    let rest = whole(course.to.lead - begin.lead);
    let share = side * whole(pass.start.level - begin.level) / rise;
    let reached = round_narrow(&(whole(begin.lead) + rest * share));
    let last_lead = lead.at(&way(course.from.lead, reached));
    let level = pass.start.level;
    Ok(vec![(Spot { lead: reached, level }, first_lead), (Spot { lead: course.to.lead, level }, last_lead)])
}
