//! T words (E100L-TOOL-01 to -06).

use crate::emission::Emission;
use crate::integer::tool::parts;
use crate::state::State;
use crate::vocabulary::rule_ids::*;
use crate::vocabulary::{Action, FrameCause, RuleSet};

/// Carries a T word out: nose radius, tool and offset number, two digits each.
pub fn command(number: i64, moves: bool, state: &mut State) -> (Emission, Option<Emission>) {
    let (nose, tool, offset) = parts(number);
    let before = state.frame.active_offset();
    // E100L-TOOL-05: tool number 00 keeps the station.
    let index = tool != 0 && tool != state.tool;
    if tool != 0 {
        state.tool = tool;
    }
    state.frame.offset_number = offset;
    // E100L-NRC-04, E100L-NRC-10: a short T word names nose radius 00.
    state.nose = nose;
    let event = Emission::new(Action::Tool { tool, offset, nose, index }, RuleSet::of(&[TOOL_02]))
        .rule_if(moves, TOOL_04)
        .rule_if(number < 100, TOOL_05)
        .rule_if(index, TOOL_06);
    let changed = state.frame.active_offset() != before;
    let frame = changed.then(|| {
        let event = Emission::new(state.frame.event(FrameCause::ToolOffset), RuleSet::of(&[TOOL_04]));
        event.reading(state.setup.readings.tool_offset)
    });
    (event, frame)
}
