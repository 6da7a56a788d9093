//! G136 and G137 (E100L-CSC-01, E100L-CSC-05, E100L-CSC-09, E100L-CSC-10).

use crate::controls::e100l::g_codes::GGroup;
use crate::emission::Emission;
use crate::fault::{Outcome, fail};
use crate::frame::TravelLimit;
use crate::integer::turn;
use crate::modal::{Plan, mode};
use crate::state::{Modes, State};
use crate::vocabulary::rule_ids::*;
use crate::vocabulary::{Action, AlarmName, Angle, RuleSet};

/// Carries G136 or G137 out.
pub fn convert(code: u16, plan: &Plan, state: &mut State, emissions: &mut Vec<Emission>) -> Outcome<()> {
    if code == 137 {
        emissions.push(begin(plan.words.get('C').unwrap_or(0), state)?);
    } else {
        end(state, emissions);
    }
    Ok(())
}

/// Conversion mode begins, in this direction; it is reported also if it was in force.
fn begin(direction: i64, state: &mut State) -> Outcome<Emission> {
    let at = state.frame.machine;
    if is_at(&state.limits.x, at.x) || is_at(&state.limits.z, at.z) {
        return fail(AlarmName::ConversionAtLimit, CSC_10);
    }
    let direction = turn::within(direction);
    let previous = state.modes.get(GGroup::Conversion);
    state.modes.set(GGroup::Conversion, 137);
    // E100L-CSC-05.
    state.modes.set(GGroup::Motion, Modes::NO_CODE);
    state.contour.begin_conversion(direction);
    let mut action = mode(GGroup::Conversion, 137, previous);
    if let Action::Mode { angle, .. } = &mut action {
        *angle = Some(Angle(direction));
    }
    Ok(Emission::new(action, RuleSet::of(&[GCODE_02, CSC_01])))
}

/// E100L-CSC-10: whether an axis stands at the end of its travel, or beyond it.
fn is_at(limit: &TravelLimit, place: i64) -> bool {
    limit.positive.is_some_and(|limit| place >= limit) || limit.negative.is_some_and(|limit| place <= limit)
}

/// Conversion mode ends; E100L-CGS-07: so does the mode of the side.
fn end(state: &mut State, emissions: &mut Vec<Emission>) {
    if state.modes.converting() {
        state.modes.set(GGroup::Conversion, 136);
        let rules = RuleSet::of(&[GCODE_02, CSC_01, CSC_09]);
        emissions.push(Emission::new(mode(GGroup::Conversion, 136, 137), rules));
    }
    if state.modes.get(GGroup::Plane) == 119 {
        state.modes.set(GGroup::Plane, 18);
        emissions.push(Emission::new(mode(GGroup::Plane, 18, 119), RuleSet::of(&[CGS_07])));
    }
}
