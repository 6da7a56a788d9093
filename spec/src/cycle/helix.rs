//! Threads with the C axis, G185 to G188 (E100L-CTHR-01 to -05).

use super::act::Act;
use super::block::{CycleBlock, Role, is_chain};
use super::cited::{of_block, of_cycle};
use super::kept::Mode;
use super::motion::{Axis, Go, Manner, Turn};
use crate::fault::{Fault, Outcome};
use crate::modal::Plan;
use crate::quantity::{round_narrow, whole};
use crate::state::State;
use crate::thread::{Cited, measure};
use crate::vocabulary::rule_ids::*;
use crate::vocabulary::{AlarmName, Part, RuleId};

/// What a block does; its words are kept.
pub fn begin(block: CycleBlock, mode: &mut Mode, plan: &Plan, state: &State) -> Outcome<Vec<Act>> {
    let CycleBlock { code, role } = block;
    let kept = mode.words;
    let (axis, approach, taper) = match code {
        185 | 187 => (Axis::Z, kept.k, kept.i),
        _ => (Axis::X, kept.i, kept.k),
    };
    let cycle_start = state.frame.to_program(mode.start);
    let start = (axis.of(cycle_start), axis.other().of(cycle_start));
    let words = match axis {
        Axis::X => (kept.x, kept.z),
        Axis::Z => (kept.z, kept.x),
    };
    let (end, level) = (words.0.unwrap_or(start.0), words.1.unwrap_or(start.1));
    let all = of_block(block, state.setup);
    let mut acts = Vec::new();
    let from = if is_chain(code) && role == Role::FollowUp {
        let present = axis.of(state.frame.program());
        if mode.direction * (end - present) <= 0 {
            return Err(depth(if code == 187 { CTHR_04 } else { CTHR_05 }));
        }
        present
    } else {
        let (direction, approach) = ((end - start.0).signum(), approach.unwrap_or(0));
        if direction * (end - start.0) <= approach {
            return Err(depth(MCYC_05));
        }
        mode.direction = direction;
        let from = start.0 + direction * approach;
        // The first block without a C word leaves C where it is.
        let named = role == Role::FollowUp || plan.words.get('C').is_some();
        let c = named.then_some(Turn::To(mode.c));
        let cited = all.and(Cited::rules(&[MCYC_05]));
        acts.push(in_plane(axis, (from, level), c, Manner::Rapid, Part::Position, cited));
        from
    };
    if role == Role::First {
        acts.push(Act::Code(13, of_cycle(code, state.setup).and(Cited::rules(&[MCYC_10]))));
    }
    let to = (end, level + taper.unwrap_or(0));
    acts.extend([Act::Pass, thread(axis, from, to, all, state)]);
    if !is_chain(code) {
        let rapid = |axis, to, part| Act::Go(Go::along(axis, to, Manner::Rapid, part, all));
        acts.push(rapid(axis.other(), start.1, Part::Retract));
        acts.push(rapid(axis, start.0, Part::Return));
    }
    Ok(acts)
}

/// E100L-CTHR-01: the thread from a coordinate of the lead axis to a point (on the lead axis, on the other one).
fn thread(axis: Axis, from: i64, to: (i64, i64), all: Cited, state: &State) -> Act {
    let lead = state.feed.map_or(1, |feed| feed.per_revolution).max(1);
    let length = measure(axis == Axis::X, state.setup) * whole((to.0 - from).abs());
    // Nanometres, picometres per revolution.
    let turned = round_narrow(&(length * whole(360_000_000_000_i64) / whole(lead)));
    let turned = if state.is_active(15) { turned } else { -turned };
    // Thousandths of a revolution per minute.
    let speed = whole(state.spindle.c_axis_speed.unwrap_or(0));
    let feed = round_narrow(&(whole(lead) * speed / whole(1_000)));
    let on_x = Cited::default().reading(state.setup.readings.feed_length);
    let cited = all.and(Cited::rules(&[CTHR_01, CAX_08])).and_if(axis == Axis::X, on_x);
    in_plane(axis, to, Some(Turn::By(turned)), Manner::Helix { axis, lead, feed }, Part::Cut, cited)
}

/// A motion to a point, on the lead axis and on the other one.
fn in_plane(axis: Axis, to: (i64, i64), c: Option<Turn>, manner: Manner, part: Part, cited: Cited) -> Act {
    let (x, z) = match axis {
        Axis::X => (to.0, to.1),
        Axis::Z => (to.1, to.0),
    };
    Act::Go(Go { x: Some(x), z: Some(z), c, point: None, manner, part, pass: None, cited })
}

fn depth(rule: RuleId) -> Fault {
    Fault::about(AlarmName::Unspecified, rule, "depth")
}
