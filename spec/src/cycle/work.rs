//! Step 7 of a block of the cycles: its acts, up to each cutting pass, which but for the first is a step of the run
//! (E100L-GOTO-03).

use std::collections::VecDeque;

use super::act::Act;
use super::block::{CycleBlock, Role, is_chain, is_thread};
use super::cited::of_cycle;
use super::groove::Groove;
use super::hole::Holes;
use super::motion::{Go, Manner};
use super::{helix, tapping};
use crate::emission::Emission;
use crate::fault::{Outcome, fail};
use crate::modal::{Plan, active_feed};
use crate::state::State;
use crate::vocabulary::rule_ids::*;
use crate::vocabulary::{AlarmName, Part};

/// What a block has to do yet.
#[derive(Clone, Debug)]
pub struct Work {
    acts: VecDeque<Act>,
    rest: Rest,
    /// Whether the first pass was cut.
    begun: bool,
}

/// What makes further acts.
#[derive(Clone, Debug)]
enum Rest {
    /// Nothing.
    Nothing,
    /// Grooves.
    Grooves(Box<Groove>),
    /// Holes.
    Holes(Box<Holes>),
}

impl Work {
    /// What a block does, before its first motion.
    pub fn begin(plan: &Plan, state: &mut State) -> Outcome<Self> {
        let (acts, rest) = match (plan.one_shot, plan.cycle) {
            (Some(73 | 74), _) => (Vec::new(), Rest::Grooves(Box::new(Groove::begin(plan, state)?))),
            (Some(77 | 78), _) => (tapping::begin(plan, state)?, Rest::Nothing),
            (_, Some(block)) => of_cycle_block(block, plan, state)?,
            (_, None) => (Vec::new(), Rest::Nothing),
        };
        if !acts.is_empty() || !matches!(rest, Rest::Nothing) {
            // It counts from the present point: a corner of before (E100L-CHAM-13) is left behind.
            state.base = None;
        }
        Ok(Self { acts: acts.into(), rest, begun: false })
    }

    /// Carries the next pass out, with what comes before and behind it; whether one is left then.
    pub fn go_on(&mut self, plan: &Plan, state: &mut State, emissions: &mut Vec<Emission>) -> Outcome<bool> {
        // Of a pass that is not the first the run has made the step already.
        let mut in_pass = self.begun;
        while let Some(act) = self.next() {
            if matches!(act, Act::Pass) {
                if in_pass {
                    return Ok(true);
                }
                (in_pass, self.begun) = (true, true);
            }
            emissions.extend(act.carry_out(plan, state)?);
        }
        Ok(false)
    }

    fn next(&mut self) -> Option<Act> {
        loop {
            if let Some(act) = self.acts.pop_front() {
                return Some(act);
            }
            let acts = match &mut self.rest {
                Rest::Nothing => None,
                Rest::Grooves(grooves) => grooves.next(),
                Rest::Holes(holes) => holes.next(),
            };
            self.acts.extend(acts?);
        }
    }
}

/// A block of a cycle mode, or the one that ends it.
fn of_cycle_block(block: CycleBlock, plan: &Plan, state: &mut State) -> Outcome<(Vec<Act>, Rest)> {
    if block.role == Role::Cancel {
        return Ok((cancel(block.code, state), Rest::Nothing));
    }
    let machines = block.machines(&plan.words);
    if machines {
        is_free(state)?;
        active_feed(state)?;
    }
    let (present, c) = (state.frame.machine, state.frame.program().c);
    let mut mode = state.cycle.keep(&plan.words, block, present, c, state.setup);
    if !machines {
        return Ok((Vec::new(), Rest::Nothing));
    }
    let begun = if is_thread(block.code) {
        (helix::begin(block, &mut mode, plan, state)?, Rest::Nothing)
    } else {
        (Vec::new(), Rest::Holes(Box::new(Holes::begin(block, &mut mode, plan, state)?)))
    };
    state.cycle.mode = Some(mode);
    Ok(begun)
}

/// E100L-MCYC-11.
fn is_free(state: &State) -> Outcome<()> {
    if !state.c_joined() {
        return fail(AlarmName::CAxisNotJoined, MCYC_11);
    }
    if state.is_active(147) {
        return fail(AlarmName::CAxisClamped, MCYC_11);
    }
    Ok(())
}

/// G180: the mode ends. E100L-CTHR-04, E100L-CTHR-05: behind a chain the axes go back to where it began.
fn cancel(code: u16, state: &mut State) -> Vec<Act> {
    state.cycle.spent = false;
    let Some(mode) = state.cycle.mode.take() else { return Vec::new() };
    if !is_chain(code) {
        return Vec::new();
    }
    let start = state.frame.to_program(mode.start);
    vec![Act::Go(Go {
        x: Some(start.x),
        z: Some(start.z),
        c: None,
        point: None,
        manner: Manner::Rapid,
        part: Part::Return,
        pass: None,
        cited: of_cycle(code, state.setup),
    })]
}
