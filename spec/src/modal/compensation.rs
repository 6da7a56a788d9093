//! What a block must satisfy for its plane and for radius compensation.

use super::check::{Before, Change, Plan};
use crate::controls::e100l::g_codes::GGroup;
use crate::fault::{Fault, Outcome, fail};
use crate::vocabulary::rule_ids::*;
use crate::vocabulary::{AlarmName, RuleId};

/// Check 6 of execution.md.
pub fn check(plan: &Plan, before: Before, c_joined: bool) -> Outcome<()> {
    plane(plan, before, c_joined)?;
    change(plan)?;
    one_shot(plan, before)?;
    meeting(plan)
}

/// E100L-CRC-02, E100L-CRC-13, E100L-CRC-14.
fn plane(plan: &Plan, before: Before, c_joined: bool) -> Outcome<()> {
    let words = &plan.words;
    let of_rotary_tool = words.has_g(17) || words.has_g(119);
    if of_rotary_tool && !c_joined {
        return fail(AlarmName::CAxisNotJoined, CRC_02);
    }
    let in_compensation = before.modes.compensating() && plan.compensation != Change::Ends;
    if (of_rotary_tool || words.has_g(18)) && in_compensation {
        return fail(AlarmName::PlaneChangeInCompensation, CRC_13);
    }
    let turning = plan.modes.get(GGroup::Plane) == 18;
    match ["G41", "G42"].into_iter().zip([41, 42]).find(|(_, code)| words.has_g(*code)) {
        Some((code, _)) if !turning => Err(Fault::about(AlarmName::NotModelled, CRC_14, code)),
        _ => Ok(()),
    }
}

/// The block that begins compensation (E100L-NRC-19, E100L-NRC-24), and the one that ends it (E100L-NRC-72,
/// E100L-NRC-70).
fn change(plan: &Plan) -> Outcome<()> {
    let (linear, imaginary): (RuleId, RuleId) = match plan.compensation {
        Change::Stays => return Ok(()),
        Change::Begins => (NRC_19, NRC_24),
        Change::Ends => (NRC_72, NRC_70),
    };
    if !matches!(plan.motion(), 0 | 1 | 101) {
        return fail(AlarmName::CompensationNotLinear, linear);
    }
    let zero = |letter| plan.words.get(letter).unwrap_or(0) == 0;
    if plan.words.has_any("IK") && zero('I') && zero('K') {
        return fail(AlarmName::CompensationImaginaryPoint, imaginary);
    }
    Ok(())
}

/// E100L-NRC-81, E100L-NRC-20: one-shot codes that compensation does not go with.
fn one_shot(plan: &Plan, before: Before) -> Outcome<()> {
    let in_force = plan.modes.compensating();
    match plan.one_shot {
        Some(50) if in_force && plan.words.has_any("XZCW") => fail(AlarmName::CompensationNotAllowed, NRC_81),
        Some(4 | 28 | 29 | 50) if plan.compensation == Change::Begins => {
            Err(Fault::about(AlarmName::Unspecified, NRC_20, "start_up"))
        }
        Some(22) if in_force || before.modes.compensating() || before.left_over => {
            Err(Fault::about(AlarmName::Unspecified, NRC_81, "G22"))
        }
        _ => Ok(()),
    }
}

/// E100L-M100-04: the control does not read ahead while it stands at M100.
fn meeting(plan: &Plan) -> Outcome<()> {
    let refused = plan.words.m.contains(&100) && plan.modes.compensating();
    if refused { fail(AlarmName::CompensationNotAllowed, M100_04) } else { Ok(()) }
}
