//! G31, G32 and G33: each block cuts one pass of a cycle (E100L-G33-01 to -10, E100L-G32-01 to -04).

use super::kept::Cycle;
use super::lead::Lead;
use super::motion::{Cited, Thread};
use super::pass::{Citations, Pass, Spot};
use super::taper::Taper;
use crate::emission::Emission;
use crate::fault::Outcome;
use crate::modal::Plan;
use crate::state::State;
use crate::vocabulary::rule_ids::*;
use crate::vocabulary::{LeadAxis, Setup};

/// Cuts the pass of a block.
pub fn cut(plan: &Plan, lead: Lead, state: &mut State, emissions: &mut Vec<Emission>) -> Outcome<()> {
    let axis = if plan.motion() == 32 { LeadAxis::X } else { LeadAxis::Z };
    let follows = state.thread.cycle.is_some();
    let cycle = data(plan, axis, state);
    state.thread.cycle = Some(cycle);
    let present = state.frame.program();
    let start = Spot::of((present.x, present.z), axis);
    let Spot { lead: end, level } = Spot::of((cycle.x, cycle.z), axis);
    let lead = lead.changing(cycle.change);
    let pass = Pass {
        thread: Thread { lead, axis, start_angle: cycle.start_angle },
        start,
        end,
        level,
        side: (start.level - level).signum(),
        taper: cycle.taper,
        shift: cycle.shift,
        flank: 0,
        chamfer: cycle.chamfer,
        number: cycle.passes,
        citations: citations(plan.motion(), follows, cycle.start_angle, state.setup),
    };
    pass.cut(plan, state, emissions)
}

/// The data of a cycle with those of a block: what it does not say stays (E100L-G33-03, E100L-G32-04).
fn data(plan: &Plan, axis: LeadAxis, state: &State) -> Cycle {
    let words = &plan.words;
    let kept = state.thread.cycle;
    let present = state.frame.program();
    let coordinate = |letter, present: i64| {
        words.get(letter).map(|word| if plan.modes.incremental() { present + word } else { word })
    };
    // A first block has X and Z.
    let before = kept.unwrap_or(Cycle {
        x: present.x,
        z: present.z,
        taper: Taper::None,
        shift: 0,
        chamfer: None,
        change: 0,
        // E100L-G33-10: that of the first block holds.
        start_angle: words.get('C').unwrap_or(0),
        passes: 0,
    });
    let (amount, shift) = match axis {
        LeadAxis::Z => ('I', 'K'),
        LeadAxis::X => ('K', 'I'),
    };
    Cycle {
        x: coordinate('X', present.x).unwrap_or(before.x),
        z: coordinate('Z', present.z).unwrap_or(before.z),
        taper: Taper::of(words.get(amount), words.get('A'), axis).unwrap_or(before.taper),
        shift: words.get(shift).unwrap_or(before.shift),
        chamfer: words.get('L').or(before.chamfer),
        change: words.get('E').unwrap_or(before.change),
        passes: before.passes.saturating_add(1),
        ..before
    }
}

fn citations(motion: u16, follows: bool, start_angle: i64, setup: &Setup) -> Citations {
    let all = match motion {
        // E100L-G33-02: it moves as G33 does.
        31 => Cited::rules(&[G33_04, G33_02]),
        32 => Cited::rules(&[G32_02]),
        _ => Cited::rules(&[G33_04]),
    };
    let kept = Cited::rules(&[if motion == 32 { G32_04 } else { G33_03 }]);
    let along = match motion {
        32 => Cited::rules(&[G32_03]).reading(setup.readings.feed_length),
        // E100L-G33-08: on a taper too.
        _ => Cited::rules(&[G33_08]),
    };
    Citations {
        all: all.and_if(follows, kept),
        thread: along.and_if(start_angle != 0, Cited::rules(&[G33_10])),
        ..Citations::default()
    }
}
