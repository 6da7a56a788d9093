//! G77 and G78: tapping with the main spindle (E100L-TAP-01 to -06).

use super::act::Act;
use super::motion::{Axis, Go, Manner};
use crate::fault::{Fault, Outcome};
use crate::modal::{Plan, active_feed};
use crate::state::State;
use crate::thread::Cited;
use crate::vocabulary::rule_ids::*;
use crate::vocabulary::{AlarmName, Part};

/// What a block does.
pub fn begin(plan: &Plan, state: &State) -> Outcome<Vec<Act>> {
    active_feed(state)?;
    if state.c_joined() {
        return Err(Fault::about(AlarmName::Unspecified, TAP_04, "c_axis"));
    }
    let word = |letter| plan.words.get(letter).unwrap_or(0);
    let present = state.frame.program();
    let base = |present| if plan.modes.incremental() { present } else { 0 };
    let (x, bottom) = (base(present.x) + word('X'), base(present.z) + word('Z'));
    let direction = (bottom - present.z).signum();
    if direction * (bottom - present.z) <= word('K') {
        return Err(Fault::about(AlarmName::Unspecified, TAP_02, "depth"));
    }
    let level = present.z + direction * word('K');
    let reverse = plan.one_shot == Some(78);
    // E100L-TAP-03, E100L-TAP-07: the senses are those of M03 and M04.
    let (inward, outward) = if reverse { (4, 3) } else { (3, 4) };
    let cited = Cited::rules(&[TAP_01, if reverse { TAP_03 } else { TAP_02 }]);
    let go = |axis, to, manner, part| Act::Go(Go::along(axis, to, manner, part, cited));
    Ok(vec![
        go(Axis::X, x, Manner::Rapid, Part::Position),
        Act::Start(inward, cited.and(Cited::rules(&[TAP_04]))),
        go(Axis::Z, level, Manner::Rapid, Part::Approach),
        Act::Pass,
        go(Axis::Z, bottom, Manner::Feed, Part::Cut),
        Act::Code(5, cited),
        Act::Code(outward, cited),
        go(Axis::Z, level, Manner::Feed, Part::Exit),
        go(Axis::Z, present.z, Manner::Rapid, Part::Return),
        Act::Code(5, cited.and(Cited::rules(&[TAP_06]))),
    ])
}
