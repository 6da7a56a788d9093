//! What a block must satisfy for its plane and for radius compensation.

use super::check::{Before, Change, Plan};
use crate::controls::e100l::g_codes::GGroup;
use crate::fault::{Fault, Outcome, fail};
use crate::state::{Modes, State};
use crate::vocabulary::rule_ids::*;
use crate::vocabulary::{AlarmName, Label, RuleId};

/// A plane in which the radius of a rotary tool is compensated (E100L-CRC-01).
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum CutterPlane {
    /// G17: the face.
    Face,
    /// G119: the developed side.
    Side,
}

impl CutterPlane {
    /// The plane in which G41 or G42 was in force, or is now, the block's own plane code included (E100L-CRC-11); none if
    /// that is the plane of turning.
    pub fn of(before: Modes, after: Modes) -> Option<Self> {
        let modes = [before, after].into_iter().find(Modes::compensating)?;
        match modes.get(GGroup::Plane) {
            17 => Some(Self::Face),
            119 => Some(Self::Side),
            _ => None,
        }
    }

    /// E100L-CRC-06, E100L-CRC-07: the motion codes that it takes.
    fn takes(self, motion: u16) -> bool {
        match self {
            Self::Face => matches!(motion, 0 | 1 | 101..=103),
            Self::Side => matches!(motion, 0 | 1 | 132 | 133),
        }
    }
}

/// Check 6 of execution.md.
pub fn check(plan: &Plan, before: Before, state: &State) -> Outcome<()> {
    plane(plan, before, state.c_joined())?;
    if let Some(plane) = plan.cutter {
        cutter(plane, plan, before, state.lap.definition.is_some())?;
    }
    change(plan)?;
    one_shot(plan, before)?;
    meeting(plan)
}

/// E100L-CRC-02, E100L-CRC-13.
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
    Ok(())
}

/// E100L-CRC-06, E100L-CRC-07, E100L-CRC-12, E100L-CRC-14, E100L-LAP-16: what is refused in the planes of rotary tools.
fn cutter(plane: CutterPlane, plan: &Plan, before: Before, in_definition: bool) -> Outcome<()> {
    let unspecified = |rule, detail: &str| Err(Fault::about(AlarmName::Unspecified, rule, detail));
    let words = &plan.words;
    if let Some(code) = words.g.iter().copied().find(|code| matches!(code, 41 | 42)) {
        if in_definition {
            return unspecified(LAP_16, Label::of_code(b'G', code).as_str());
        }
        let other = before.modes.compensating() && before.modes.get(GGroup::Compensation) != code;
        if other {
            return unspecified(CRC_12, "side");
        }
    }
    let moves = plan.moves && plan.one_shot != Some(22);
    if moves && !plane.takes(plan.motion()) {
        let rule: RuleId = if plane == CutterPlane::Face { CRC_06 } else { CRC_07 };
        return unspecified(rule, Label::of_code(b'G', plan.motion()).as_str());
    }
    let corner = [
        ("A", words.get('A').is_some()),
        ("QA", words.extended("QA").is_some()),
        ("G75", words.has_g(75)),
        ("G76", words.has_g(76)),
    ];
    if let Some((detail, _)) = corner.into_iter().find(|(_, has)| moves && *has) {
        return unspecified(CRC_14, detail);
    }
    let moves_in_plane = plan.moves_in(plane);
    match plan.compensation {
        _ if plan.one_shot == Some(22) => Ok(()),
        Change::Begins if !moves_in_plane || before.left_over => unspecified(CRC_14, "start_up"),
        Change::Ends if !moves_in_plane => unspecified(CRC_14, "cancel"),
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
    match plan.motion() {
        0 | 1 | 101 => {}
        102 | 103 | 132 | 133 if plan.cutter.is_some() => {
            let detail = if plan.compensation == Change::Begins { "start_up" } else { "cancel" };
            return Err(Fault::about(AlarmName::Unspecified, CRC_14, detail));
        }
        _ => return fail(AlarmName::CompensationNotLinear, linear),
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
