//! Machines with two turrets or two saddles (E100L-MIRR-01, E100L-AX4-01): the set-up of a side, and the change of
//! the turret on one saddle.

mod saddles;
mod sections;
mod side;
mod turret;

pub use saddles::Saddles;
pub use sections::Section;
pub use side::{Common, SideRun};
pub use turret::{Turret, nose_radii, tool_offsets};

use turnspec_oracle::vocabulary::{AlarmName, Event, Label, MachineType, Setup, Side, rule_ids};

use super::Interpreter;
use super::codes::GGroup;
use super::fault::Fault;
use super::words::Words;

/// The side of a code G13 or G14, or of G110 or G111.
pub fn side_of(code: u16) -> Side {
    if matches!(code, 14 | 111) { Side::B } else { Side::A }
}

/// Whether the machine has more than one turret.
pub fn is_double(setup: &Setup) -> bool {
    setup.machine.r#type != MachineType::OneTurret
}

impl Interpreter<'_> {
    /// Gives an event its turret or saddle, on machines that have more than one.
    #[inline(always)]
    pub(super) fn name_side(&self, event: &mut Event) {
        if self.state.other_turret.is_some() {
            event.turret = Some(self.state.selected);
        } else if self.side.is_some() {
            event.saddle = Some(self.state.selected);
        }
    }

    /// G96 with the reference at the other turret (E100L-MIRR-19), tested behind check 2.
    pub(super) fn check_speed_turret(&self, words: &Words) -> Result<(), Fault> {
        if self.setup.machine.r#type != MachineType::TwoTurrets {
            return Ok(());
        }
        let word = words.code_of(GGroup::SpeedTurret);
        let speed = words.code_of(GGroup::CuttingSpeed);
        let constant = speed.map_or(self.state.constant_speed, |code| code == 96);
        let side = word.map_or(self.state.speed_side, side_of);
        if constant && (word.is_some() || speed == Some(96)) && side != self.state.selected {
            let detail = Label::of_code(b'G', if side == Side::A { 110 } else { 111 });
            return Err(Fault::about(AlarmName::Unspecified, rule_ids::MIRR_19, detail));
        }
        Ok(())
    }
}
