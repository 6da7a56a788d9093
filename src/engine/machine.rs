//! What the type of the machine makes of single codes (E100L-MIRR-01, E100L-MIRR-03, E100L-MIRR-20,
//! E100L-AX4-03, E100L-AX4-12).

use turnspec_oracle::vocabulary::rule_ids::*;
use turnspec_oracle::vocabulary::{AlarmName, Label, MachineType, Side};

use super::Interpreter;
use super::fault::Fault;

impl Interpreter<'_> {
    /// The G codes of turrets, as words of a block that is evaluated.
    #[inline]
    pub(super) fn check_turret_code(&self, code: u16) -> Result<(), Fault> {
        if !matches!(code, 13 | 14 | 111) {
            return Ok(());
        }
        let detail = Label::of_code(b'G', code);
        match (self.setup.machine.r#type, code) {
            (MachineType::OneTurret, 14 | 111) => {
                Err(Fault::about(AlarmName::TurretMissing, MIRR_01, detail))
            }
            // A plain number would make it a turret block.
            (MachineType::TwoTurrets, 13 | 14) => Err(Fault::about(AlarmName::Unspecified, MIRR_03, detail)),
            (MachineType::TwoSaddles, 13 | 14) => Err(Fault::about(AlarmName::Unspecified, AX4_03, detail)),
            _ => Ok(()),
        }
    }

    /// The M codes of the barriers and of the C axis, which are not described for every machine.
    #[inline]
    pub(super) fn check_machine_m_code(&self, code: u16) -> Result<(), Fault> {
        if !matches!(code, 21 | 25 | 110) || self.setup.machine.r#type == MachineType::OneTurret {
            return Ok(());
        }
        let detail = Label::of_code(b'M', code);
        match code {
            21 => Err(Fault::about(AlarmName::NotModelled, MCODE_09, detail)),
            25 => Err(Fault::about(AlarmName::NotModelled, MCODE_11, detail)),
            _ if self.saddle.is_some() => Err(Fault::about(AlarmName::Unspecified, AX4_12, detail)),
            _ if self.turret == Some(Side::B) => Err(Fault::about(AlarmName::Unspecified, MIRR_20, detail)),
            _ => Ok(()),
        }
    }
}
