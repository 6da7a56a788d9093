//! Faults of machines with two turrets or two saddles, and of turret codes on the others.

use turnspec_oracle::vocabulary::MachineType;

use super::Fault;
use crate::builder::Builder;

/// Blocks with codes of a turret that the machine does not have.
const MISSING: &[&str] =
    &["G14", "G96 G111 S100", "G111", "G14 X5", "G=10+4", "G13 G111", "G91 G14", "G14 T0101 M08"];

/// Blocks of two turrets on one saddle that are found at their form or at a code.
const TURRETS: &[(Fault, &[&str])] = &[
    (Fault::GCodesConflict, &["G13 G14", "G14 G14", "G13 X5 G13", "G14 M02 G13"]),
    (Fault::NumberMalformed, &["G14 X", "G13 X1.2.3"]),
    (Fault::NotModelled, &["M21", "M25", "P10", "G00 X5 P10"]),
    (Fault::AngleLookahead, &["G01 A30 F1\nG13", "G01 A30 F1\nG14", "G01 A30 F1\nM100"]),
];

/// Blocks of two saddles.
#[rustfmt::skip]
const SADDLES: &[(Fault, &[&str])] = &[
    (Fault::SidesDiffer, &[
        "M03", "S500", "G97 S100", "M00", "M41", "G50 S100", "G110", "M01 G00 X5", "M40", "G96 S100 M04", "G111", "M19 M100",
        "G50 X5 S100", "M05 T0101", "M03 X99999999",
    ]),
    (Fault::Unspecified, &[
        "M110", "G00 X5 M110", "M110 M110", "V1=5", "X=V1", "G00 X=V001+5", "VZOFX=5", "Z=VSIOZ", "GOTO N1",
        "IF [1] N1", "CALL O1", "RTS", "MODIN O1", "MODOUT", "READ 0", "PUT 'A'", "GET 5", "WRITE 0", "NOEX AB=1", "END",
        "VSET V1=5", "PSELECT A", "VUACM[1]='A'", "VTOFX[1]=5", "X=VTOFX[V1]", "VDOUT[1]=1",
    ]),
    (Fault::Unspecified, &[
        "G13 X5", "G14 M08", "G14 X5", "X5 G13", "G=10+3", "G=10+4", "G13 G14", "G14 G00", "M08 G14 P10",
    ]),
    (Fault::AddressRange, &[
        "P10000", "G00 X5 P10000", "P-1", "P=9999.4+0.2", "P=-0.4", "P9999.5", "P=1-2", "P99999999 X5", "P=9999.1",
    ]),
    (Fault::SequenceNameDuplicate, &["N1 M65\nN1 M65", "NAB\nM08\nNAB M65", "N7 P5\nN7 G00 X5"]),
    (Fault::ProgramNameMisplaced, &["O99", ":7", "OA (SECOND)"]),
    (Fault::NotModelled, &["M21", "M25", "M21 P10"]),
    (Fault::AngleLookahead, &["G01 A30 F1\nP10 X5 Z9", "G01 A30 F1\nM100 X5 Z9", "G01 A30 F1\nX5 Z9 P10"]),
    (Fault::VariableNumber, &["V201=1", "X=V0", "G00 X=V999"]),
    (Fault::SystemVariableUnknown, &["VNONE=1", "X=VABC"]),
    (Fault::StatementMisplaced, &["X5 GOTO N1", "M08 CALL O1"]),
];

impl Builder<'_, '_, '_> {
    /// Adds blocks with this fault.
    pub(super) fn turret_fault(&mut self, fault: Fault) -> bool {
        match self.state.setup.machine.r#type {
            MachineType::OneTurret if fault == Fault::TurretMissing => self.one_of(MISSING),
            MachineType::OneTurret => fault == Fault::CompensationNotAllowed && self.m100_in_compensation(30),
            MachineType::TwoTurrets => self.fault_of_turrets(fault),
            MachineType::TwoSaddles => self.fault_of_saddles(fault),
        }
    }

    fn fault_of_turrets(&mut self, fault: Fault) -> bool {
        match fault {
            Fault::TurretChange => self.change_forbidden(),
            Fault::Unspecified if self.choices.chance(70) => self.change_not_described(),
            Fault::CompensationNotAllowed => self.m100_in_compensation(40),
            _ => self.choices.chance(60) && self.one_listed(TURRETS, fault),
        }
    }

    fn fault_of_saddles(&mut self, fault: Fault) -> bool {
        match fault {
            Fault::CompensationNotAllowed => self.m100_in_compensation(80),
            Fault::Unspecified if self.choices.chance(20) => {
                self.in_force("");
                self.one_of(&["P9000", "G40 G00 X5 P9000", "G00 Z5 P=9000"])
            }
            _ => self.choices.chance(85) && self.one_listed(SADDLES, fault),
        }
    }

    /// One of the blocks of a fault.
    fn one_listed(&mut self, list: &[(Fault, &'static [&'static str])], fault: Fault) -> bool {
        let texts: Vec<_> = list.iter().filter(|(name, _)| *name == fault).map(|(_, texts)| *texts).collect();
        !texts.is_empty() && {
            let texts = self.choices.pick(&texts);
            self.one_of(texts)
        }
    }

    /// The code of the turret that is not selected.
    fn other_code(&self) -> &'static str {
        if self.state.turrets.is_mirrored() { "G13" } else { "G14" }
    }

    /// G41, G42, G91 or G96 at a change; a reversal behind it (E100L-MIRR-08, E100L-MIRR-09).
    fn change_forbidden(&mut self) -> bool {
        let other = self.other_code();
        let (own, foreign) = if self.state.turrets.is_mirrored() { (111, 110) } else { (110, 111) };
        let compensation = &self.state.compensation;
        let bound = compensation.is_on() || self.state.incremental || self.state.cutting_speed;
        if bound || compensation.left_over || self.state.joined {
            return self.blocks(&[other]);
        }
        let start = self.choices.pick(&["M03", "M04"]);
        match self.choices.below(6) {
            0 => self.blocks(&["G91", other]),
            1 => self.blocks(&[&format!("G96 G{own} S100"), other]),
            2 => {
                self.in_force("");
                self.blocks(&[other])
            }
            3 => {
                self.blocks(&["M05", start, other, &format!("G{foreign}"), "S5", &format!("G00 Z5 {start}")])
            }
            4 => self.blocks(&["M19", start, other, "M65", start]),
            _ => self.blocks(&["M05", start, other, &format!("{start} T0101 X5")]),
        }
    }

    /// Codes by expression, G96 with the other turret, the C axis and turret B, a displacement left over.
    fn change_not_described(&mut self) -> bool {
        let other = self.other_code();
        let mirrored = self.state.turrets.is_mirrored();
        let foreign = if mirrored { 110 } else { 111 };
        match self.choices.below(7) {
            0 => self.one_of(&["G=10+4", "G=13+0", "G00 G=10+3 X5", "G=7*2"]),
            1 => self.blocks(&[&format!("G96 S100 G{foreign}")]),
            2 => self.blocks(&[&format!("G{foreign}"), "G96 S100"]),
            3 if mirrored => self.blocks(&["M110"]),
            3 | 4 => self.blocks(&["M110", other]),
            _ => {
                self.in_force("");
                let end = self.choices.pick(&["G40", "G40 G01", "G40 M08"]);
                self.blocks(&["G90", end, other])
            }
        }
    }

    /// M100 where G41 or G42 is in force, by its own block or before.
    fn m100_in_compensation(&mut self, percent: usize) -> bool {
        if !self.choices.chance(percent) {
            return false;
        }
        if self.state.compensation.is_on() || self.choices.chance(50) {
            self.in_force("");
            return self.one_of(&["M100", "G91 G01 Z-5 M100", "M08 M100", "G41 M100"]);
        }
        self.one_of(&["G18 G42 G01 X5 F1 M100", "G18 G41 M100"])
    }
}
