//! What a block must satisfy for contours and coordinate conversion before anything of it is carried out.

use super::is_on_side;
use crate::controls::e100l::g_codes::{GCode, GGroup, g_code};
use crate::fault::{Fault, Outcome, fail};
use crate::modal::{Before, Change, Plan, Words};
use crate::state::{Modes, State};
use crate::vocabulary::rule_ids::*;
use crate::vocabulary::{AlarmName, Label, RuleId, Setup};

/// A block that is checked, before it is a plan.
#[derive(Clone, Copy)]
pub struct Asked<'w> {
    /// Its words.
    pub words: &'w Words,
    /// Its one-shot code.
    pub one_shot: Option<u16>,
    /// The modes that its G codes select.
    pub modes: Modes,
    /// Whether it begins or ends radius compensation.
    pub changes: bool,
    /// Whether it is one of a cycle, which moves in whatever motion mode.
    pub has_cycle: bool,
}

fn unspecified(rule: RuleId, code: u16) -> Fault {
    Fault::about(AlarmName::Unspecified, rule, Label::of_code(b'G', code).as_str())
}

fn motion_codes(words: &Words) -> impl Iterator<Item = u16> {
    words.g.iter().copied().filter(|code| g_code(*code) == GCode::Modelled(GGroup::Motion))
}

/// Check 2a. `converts`: the block is one in conversion mode; `moves`: it is one that moves in the motion mode.
pub fn check_conversion(asked: &Asked, converts: bool, moves: bool, state: &State) -> Outcome<()> {
    let Asked { words, one_shot, modes, changes, .. } = *asked;
    if converts && words.has_g(91) && !state.contour.has_point() {
        return fail(AlarmName::ConversionIncremental, CSC_08);
    }
    let motion = modes.get(GGroup::Motion);
    // E100L-CSC-05: G136 brings no motion code back, so that none may be in force behind it too.
    let moves = moves || converts && matches!(one_shot, Some(71 | 72));
    if motion == Modes::NO_CODE && (moves || changes) && one_shot != Some(137) {
        return fail(AlarmName::MotionCodeMissing, CSC_05);
    }
    if converts { used_in_conversion(asked, motion, state) } else { Ok(()) }
}

/// E100L-CSC-09: what does not go in conversion mode; E100L-CSC-06: its first point.
fn used_in_conversion(asked: &Asked, motion: u16, state: &State) -> Outcome<()> {
    let Asked { words, one_shot, has_cycle, .. } = *asked;
    let goes = |code: u16| match g_code(code) {
        GCode::Modelled(GGroup::Motion) => matches!(code, 0 | 1 | 101..=103),
        _ => !matches!(code, 71 | 72 | 75 | 76),
    };
    if let Some(code) = words.g.iter().copied().find(|code| !goes(*code)) {
        return Err(unspecified(CSC_09, code));
    }
    if one_shot == Some(50) && words.has_any("XC") {
        return Err(unspecified(CSC_09, 50));
    }
    if one_shot.is_some() || !words.has_any("XY") {
        return Ok(());
    }
    if motion == 1 && !has_cycle {
        return Err(unspecified(CSC_09, 1));
    }
    let both = words.get('X').is_some() && words.get('Y').is_some();
    if !both && !state.contour.has_point() {
        return fail(AlarmName::ConversionAxisMissing, CSC_06);
    }
    Ok(())
}

/// Check 3 of G137 (E100L-CSC-01, E100L-CSC-05, E100L-CSC-07).
pub fn check_beginning(words: &Words, modes: Modes) -> Outcome<()> {
    if words.get('C').is_none() {
        return fail(AlarmName::WordMissing, CSC_01);
    }
    if let Some(code) = motion_codes(words).next() {
        return Err(unspecified(CSC_05, code));
    }
    if modes.incremental() { fail(AlarmName::ConversionIncremental, CSC_07) } else { Ok(()) }
}

/// Check 4 of a contour block.
pub fn check_block(words: &Words, motion: u16, modes: Modes) -> Outcome<()> {
    let is_face_arc = matches!(motion, 102 | 103);
    if is_face_arc && words.get('Z').is_some() {
        return fail(AlarmName::ContourArcZ, CGF_05);
    }
    let (arc, mode): (RuleId, RuleId) = if is_on_side(motion) { (CGS_04, CGS_01) } else { (CGF_04, CGF_02) };
    if motion != 101 {
        match words.get('L') {
            None => return fail(AlarmName::WordMissing, arc),
            Some(radius) if radius <= 0 => return fail(AlarmName::ArcRadiusNotPositive, arc),
            Some(_) => {}
        }
    }
    if !modes.per_minute() {
        return Err(Fault::about(AlarmName::Unspecified, mode, "G95"));
    }
    Ok(())
}

/// Check 6: the mode of the side (E100L-CGS-08), and radius compensation.
pub fn check_plane(plan: &Plan, before: Before, setup: &Setup) -> Outcome<()> {
    let on_side =
        plan.is_contour() && is_on_side(plan.motion()) || plan.words.g.iter().copied().any(is_on_side);
    let plane = plan.modes.get(GGroup::Plane);
    if on_side && setup.parameters.side_contour_mode && plane != 119 {
        return fail(AlarmName::ContourCommandUnusable, CGS_08);
    }
    let (was, is) = (before.modes.compensating(), plan.modes.compensating());
    let mixed = || Err(Fault::about(AlarmName::Unspecified, CSC_09, "compensation"));
    if plan.one_shot == Some(137) && is {
        return fail(AlarmName::CompensationNotAllowed, NRC_81);
    }
    if matches!(plan.one_shot, Some(136 | 137)) && (was || before.left_over) {
        return mixed();
    }
    if plan.converts && plan.compensation == Change::Begins && plane != 17 {
        return mixed();
    }
    let concerned = plan.is_contour() || plan.motion() == 101 && plan.compensation != Change::Stays;
    // Compensation that was in force acts in the plane of before, whatever plane the block selects behind it.
    let was_turning = was && before.modes.get(GGroup::Plane) == 18;
    let begins_turning = plan.compensation == Change::Begins && plane == 18;
    if concerned && (was_turning || begins_turning || before.left_over) {
        let code = plan.motion();
        let rule: RuleId = if is_on_side(code) { CRC_07 } else { CRC_06 };
        return Err(unspecified(rule, code));
    }
    Ok(())
}
