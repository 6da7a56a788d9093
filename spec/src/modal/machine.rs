//! Codes that depend on the saddles and turrets of the machine.

use super::words::Words;
use crate::controls::e100l::g_codes::GGroup;
use crate::fault::{Fault, Outcome};
use crate::state::{Modes, State};
use crate::vocabulary::rule_ids::*;
use crate::vocabulary::{AlarmName, Label, MachineType, Setup, Side};

/// E100L-MIRR-01, E100L-MIRR-03, E100L-AX4-03: turret codes that a machine does not have, or not as a word among others.
pub fn has_g(code: u16, setup: &Setup) -> Outcome<()> {
    let (name, rule) = match (setup.machine.r#type, code) {
        (MachineType::OneTurret, 14 | 111) => (AlarmName::TurretMissing, MIRR_01),
        // Written as a plain number it makes its block another one.
        (MachineType::TwoTurrets, 13 | 14) => (AlarmName::Unspecified, MIRR_03),
        // On two saddles it divides the text, if it stands alone.
        (MachineType::TwoSaddles, 13 | 14) => (AlarmName::Unspecified, AX4_03),
        _ => return Ok(()),
    };
    Err(Fault::about(name, rule, Label::of_code(b'G', code).as_str()))
}

/// E100L-MIRR-20, E100L-AX4-12, E100L-MCODE-09, E100L-MCODE-11: C axis and barriers with more than one turret.
pub fn has_m(code: u16, state: &State) -> Outcome<()> {
    let (name, rule) = match (state.setup.machine.r#type, code) {
        (MachineType::TwoTurrets, 110) if state.turret() == Side::B => (AlarmName::Unspecified, MIRR_20),
        (MachineType::TwoSaddles, 110) => (AlarmName::Unspecified, AX4_12),
        (MachineType::TwoTurrets | MachineType::TwoSaddles, 21) => (AlarmName::NotModelled, MCODE_09),
        (MachineType::TwoTurrets | MachineType::TwoSaddles, 25) => (AlarmName::NotModelled, MCODE_11),
        _ => return Ok(()),
    };
    Err(Fault::about(name, rule, Label::of_code(b'M', code).as_str()))
}

/// E100L-MIRR-19: G96 takes the X of the turret that is selected.
pub fn check_reference(words: &Words, modes: Modes, setup: &Setup) -> Outcome<()> {
    let decides = [96, 110, 111].into_iter().any(|code| words.has_g(code)) && modes.cutting_speed();
    let own = if modes.get(GGroup::Turret) == 14 { 111 } else { 110 };
    let code = modes.get(GGroup::CssTurret);
    if setup.machine.r#type == MachineType::TwoTurrets && decides && code != own {
        return Err(Fault::about(AlarmName::Unspecified, MIRR_19, Label::of_code(b'G', code).as_str()));
    }
    Ok(())
}
