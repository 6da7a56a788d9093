//! G34 and G35: one length of thread from the present point (E100L-G34-01 to -05).

use super::lead::{Lead, length};
use super::motion::{Cited, Step, Thread, Work, carry_out};
use crate::emission::Emission;
use crate::fault::{Fault, Outcome};
use crate::modal::Plan;
use crate::path::{Ahead, Axes, End, Origin, Point, line_end, target_of_next};
use crate::state::State;
use crate::vocabulary::rule_ids::*;
use crate::vocabulary::{AlarmName, LeadAxis};

/// Cuts it, and stays at its end.
pub fn cut(
    plan: &Plan,
    lead: Lead,
    ahead: &[Ahead],
    state: &mut State,
    emissions: &mut Vec<Emission>,
) -> Outcome<()> {
    let words = &plan.words;
    let origin = Origin::present(state);
    let end = line_end(plan, origin, state.angle_target.take(), ahead)?;
    state.angle_target = target_of_next(plan, origin.incremental, ahead);
    // E100L-G34-02.
    let change = words.get('E').unwrap_or(0);
    let lead = lead.changing(if plan.motion() == 35 { -change } else { change });
    // E100L-G34-04: M27 holds for its own block.
    let axis = if words.m.contains(&27) { LeadAxis::X } else { LeadAxis::Z };
    let way = length(axis, on(axis, origin.start), on(axis, end.point), state.setup);
    if way.is_zero() {
        return Err(Fault::about(AlarmName::Unspecified, G34_04, "length"));
    }
    lead.check_end(&way)?;
    // E100L-G34-05: the spindle is not waited for within a run.
    let start_angle = if state.thread.chain { 0 } else { words.get('C').unwrap_or(0) };
    state.thread.chain = true;
    let thread = Thread { lead, axis, start_angle };
    let angle = words.get('A').is_some();
    let axes = Axes {
        x: angle || words.get('X').is_some(),
        z: angle || words.get('Z').is_some(),
        ..Axes::default()
    };
    let cited = cited(plan, &thread, &end, state);
    let step = Step { end: end.point, axes, work: Work::Thread(lead.first), part: None, cited };
    emissions.push(carry_out(&step, &thread, plan, state)?);
    Ok(())
}

fn on(axis: LeadAxis, (x, z): Point) -> i64 {
    match axis {
        LeadAxis::X => x,
        LeadAxis::Z => z,
    }
}

fn cited(plan: &Plan, thread: &Thread, end: &End, state: &State) -> Cited {
    let Thread { lead, axis, start_angle } = *thread;
    let along_x = Cited::default().reading(state.setup.readings.feed_length);
    Cited::rules(&[G34_01, G34_04])
        .and(Cited { rules: end.rules, readings: end.readings })
        .and_if(axis == LeadAxis::X, along_x)
        .and_if(lead.divided, Cited::rules(&[THRD_06]))
        .and_if(lead.change != 0, Cited::rules(&[G33_09, G34_02]))
        .and_if(start_angle != 0, Cited::rules(&[G34_05]))
        // E100L-G34-03: F stays what it was, whatever the lead has become.
        .and_if(plan.words.feed.is_none(), Cited::rules(&[G34_03]))
}
