//! The extra motion that returns to the corner after blocks without X/Z motion (E100L-NRC-46).

use super::ending::{Pending, Spot};
use crate::controls::e100l::g_codes::GGroup;
use crate::emission::Emission;
use crate::fault::Outcome;
use crate::modal::active_feed;
use crate::path::{LINEAR, Shape, event, standing, with_speed};
use crate::state::State;
use crate::vocabulary::rule_ids::*;
use crate::vocabulary::{Place, RuleSet};

/// The motion as it would be at the end of a block: what is in force there.
#[derive(Clone, Debug)]
pub struct Back {
    /// P.
    pub spot: Spot,
    /// The motion, or why it is none.
    pub motion: Outcome<Pending>,
}

impl Back {
    /// At the end of the present block.
    pub fn present(place: Place, state: &State) -> Self {
        let motion = back(state).map(|event| Pending::new(event, 0, place, state));
        Self { spot: Spot::present(place, state), motion: motion.map_err(|fault| fault.of_block(place)) }
    }
}

fn back(state: &State) -> Outcome<Emission> {
    let rapid = state.modes.get(GGroup::Motion) == 0;
    let (shape, own) = if rapid { (Shape::Rapid, RuleSet::of(&[G00_01])) } else { (Shape::Line, LINEAR) };
    let feed = if rapid { None } else { Some(active_feed(state)?) };
    let dimension = if state.modes.incremental() { ABS_02 } else { ABS_01 };
    let rules = own.union(RuleSet::of(&[COORD_03, dimension, NRC_07, NRC_46]));
    let rules = if rapid { rules } else { rules.with(NRC_42) };
    let event = event(shape, standing(None, state), feed, state.frame.machine, rules, state);
    Ok(with_speed(event, rapid, state))
}
