//! Faults: for every alarm that a program can raise, blocks that should raise it here.
//!
//! A fault returns false when the set-up or the state does not let it happen.

mod barrier;
mod compensation;
mod contour;
mod contour_texts;
mod control;
mod cutter;
mod cutter_texts;
mod cycle_texts;
mod cycles;
mod io;
mod lap;
mod lap_texts;
mod motion;
mod schedule;
mod state;
mod statement;
mod text;
mod thread_texts;
mod threads;
mod turrets;

use turnspec_oracle::vocabulary::{AlarmName, Chamfering, MachineType, Setup, TapeCode, UserAlarmC};

use crate::builder::Builder;
use crate::choices::Choices;
use crate::setup;

/// A fault is named by the alarm that it should raise.
pub(crate) type Fault = AlarmName;

/// Alarms that statements raise in many ways.
const STATEMENTS: &[Fault] = &[
    Fault::Format,
    Fault::Format,
    Fault::WordWithoutFunction,
    Fault::StatementMisplaced,
    Fault::StatementDelimiterMissing,
    Fault::LocalNameMalformed,
    Fault::Unspecified,
    Fault::AngleLookahead,
];

/// A fault of any family; often one that only a set-up like this one lets happen.
pub(crate) fn choose(choices: &mut Choices<'_, '_>, setup: &Setup) -> Fault {
    if setup.barriers != Setup::default().barriers && choices.chance(30) {
        return Fault::Barrier;
    }
    match setup.machine.r#type {
        MachineType::TwoTurrets if choices.chance(25) => return Fault::TurretChange,
        MachineType::TwoSaddles if choices.chance(25) => return Fault::SidesDiffer,
        _ => {}
    }
    if choices.chance(8) {
        return choices.pick(STATEMENTS);
    }
    let special = special(setup);
    if !special.is_empty() && choices.chance(20) {
        choices.pick(&special)
    } else {
        let generated: Vec<_> = AlarmName::ALL.iter().copied().filter(is_generated).collect();
        choices.pick(&generated)
    }
}

/// Alarms of families that name their own faults: threads, cycles, LAP, contours, cutters.
#[rustfmt::skip]
const OF_FAMILIES: &[Fault] = &[
    Fault::ThreadInConstantSpeed, Fault::ThreadLeadRange, Fault::ThreadData, Fault::CycleIncremental, Fault::CycleWord,
    Fault::CycleFeedMode, Fault::CycleCancelMissing, Fault::CycleApproachNegative, Fault::CycleDepthOverdetermined,
    Fault::LapLevel, Fault::LapData, Fault::LapStartPoint, Fault::LapAllowance, Fault::BlankFirstElement,
    Fault::ContourMalformed, Fault::ContourDirection, Fault::DescendingSlopes, Fault::ContourXNotPositive,
    Fault::ContourArcZ, Fault::ContourXChanged, Fault::ProfileGeneration, Fault::ContourCommandUnusable,
    Fault::ConversionIncremental, Fault::ConversionAxisMissing, Fault::ConversionAtLimit, Fault::MotionCodeMissing,
];

/// Whether any program is made to raise it.
fn is_generated(fault: &Fault) -> bool {
    !OF_FAMILIES.contains(fault)
}

/// The alarms that need something unusual of the set-up, where this one has it.
fn special(setup: &Setup) -> Vec<Fault> {
    let chamfering = setup.parameters.chamfering;
    let list = [
        (setup.tape.code != TapeCode::Ascii, Fault::ParityError),
        (setup.switches.block_delete, Fault::SequenceNameDuplicate),
        (!setup.nose_radius.is_empty(), Fault::CompensationNotLinear),
        (!setup.nose_radius.is_empty(), Fault::Unspecified),
        (!setup.nose_radius.is_empty(), Fault::TravelLimitNegative),
        (!setup.nose_radius.is_empty(), Fault::TravelLimitPositive),
        (setup.machine.r#type == MachineType::TwoTurrets, Fault::TurretChange),
        (setup.machine.r#type == MachineType::TwoTurrets, Fault::Unspecified),
        (setup.options.user_task == 1, Fault::UserTaskLevel),
        (setup.parameters.call_depth != 8, Fault::CallDepth),
        (setup.barriers != Setup::default().barriers, Fault::Barrier),
        (!setup.devices.is_empty(), Fault::DeviceNoData),
        (!setup.devices.is_empty(), Fault::ReadPointer),
        (!setup.devices.is_empty(), Fault::ReceivedNumber),
        (setup.readings.user_alarm_c == UserAlarmC::Stops, Fault::UserAlarmC),
        (!setup.inputs.turret_clamp_confirmed, Fault::TurretClamp),
        (setup::is_over_time(setup), Fault::StmOver),
        (setup.parameters.torque_limit_upper < 100, Fault::TorqueLimitRange),
        (chamfering == Chamfering::Off, Fault::ChamferDisabled),
        (chamfering == Chamfering::AnyAngle, Fault::ChamferCorner),
        (chamfering == Chamfering::AnyAngle, Fault::AngleLookahead),
        (chamfering == Chamfering::Basic, Fault::AngleUnderdetermined),
    ];
    list.into_iter().filter(|(unusual, _)| *unusual).map(|(_, fault)| fault).collect()
}

/// Whether it must be the first line of the program.
pub(crate) fn is_first(fault: Fault) -> bool {
    matches!(
        fault,
        Fault::HeaderMalformed
            | Fault::ProgramNameMalformed
            | Fault::ProgramNameReserved
            | Fault::ProgramNameNotAlone
            | Fault::ProgramKind
    )
}

/// Whether it happens only near the beginning, before an F word was given or the C axis joined.
pub(crate) fn is_early(fault: Fault) -> bool {
    fault == Fault::NoFeed
}

/// Whether a text has a character that EIA lacks.
pub(crate) fn lacks_codes(line: &str) -> bool {
    line.contains(['=', '[', ']', '$', '*', ':', '\'', '^', '?'])
}

impl Builder<'_, '_, '_> {
    /// Adds the blocks of a fault.
    pub(crate) fn fault(&mut self, fault: Fault) -> bool {
        self.begin();
        self.cutter_fault(fault)
            || self.lap_fault(fault)
            || self.contour_fault(fault)
            || self.thread_fault(fault)
            || self.cycle_fault(fault)
            || self.turret_fault(fault)
            || self.io_fault(fault)
            || self.control_fault(fault)
            || self.barrier_fault(fault)
            || self.compensation_fault(fault)
            || self.motion_fault(fault)
            || self.state_fault(fault)
            || self.text_fault(fault)
    }

    /// Adds one block of text a line; false when the tape code lacks a character of them.
    pub(crate) fn blocks(&mut self, lines: &[&str]) -> bool {
        if self.state.is_eia() && lines.iter().any(|line| lacks_codes(line)) {
            return false;
        }
        self.settle_label();
        self.state.control.jumps |= lines.iter().any(|line| line.contains("GOTO") || line.contains("IF"));
        for line in lines {
            self.raw(line.as_bytes());
        }
        true
    }
}
