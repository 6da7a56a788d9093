//! What codes, variables and the values of a set-up need of an implementation.

use turnspec_oracle::vocabulary::{
    AxisAmounts, CycleReturn, Feature, G184Tapping, Length, MachineType, PlaneAmounts, Setup, TapeCode,
    UnitSystem,
};

use crate::contour;
use crate::io::INTERFERENCE;
use crate::lap;
use crate::profile::Features;

/// What an M code needs that is not known.
pub(crate) const ANY_M_CODE: &[Feature] = &[
    Feature::Aux,
    Feature::CAxis,
    Feature::Coolant,
    Feature::Gear,
    Feature::MTool,
    Feature::OptionalStop,
    Feature::Spindle,
    Feature::TimeOver,
    Feature::Turret,
    Feature::TwoTurrets,
    Feature::TwoSaddles,
];

/// What the passes of a thread need: they position and withdraw.
pub(crate) const PASSES: &[Feature] = &[Feature::Thread, Feature::Rapid, Feature::Linear];

/// What grooves and taps need, and cycles of driven tools.
pub(crate) const GROOVES: &[Feature] = &[Feature::Grooving, Feature::Rapid, Feature::Linear];
pub(crate) const TAPS: &[Feature] = &[Feature::Grooving, Feature::Rapid, Feature::Linear, Feature::Spindle];
pub(crate) const DRIVEN: &[Feature] =
    &[Feature::DrivenCycle, Feature::CAxis, Feature::MTool, Feature::Rapid, Feature::Linear];

/// What an M code needs on a machine.
pub(crate) fn of_m_code(code: i64, machine: MachineType) -> &'static [Feature] {
    match code {
        0 | 1 => &[Feature::OptionalStop],
        2 | 30 => &[],
        3 | 4 | 5 | 19 => &[Feature::Spindle],
        8 | 9 => &[Feature::Coolant],
        12..=14 | 152 | 153 | 240..=244 => &[Feature::MTool],
        15 | 16 | 109 | 110 | 146 | 147 => &[Feature::CAxis],
        40..=44 => &[Feature::Gear, Feature::Spindle],
        100 if machine == MachineType::TwoSaddles => &[Feature::TwoSaddles],
        100 => &[Feature::TwoTurrets],
        124 | 125 => &[Feature::TimeOver],
        21 | 25 => &[Feature::Aux, Feature::Barrier],
        203 => &[Feature::Turret],
        321..=325 | 341..=360 => &[Feature::MacroCode, Feature::Subprogram],
        _ => &[Feature::Aux],
    }
}

/// What a G code needs by itself on a machine.
pub(crate) fn of_g_code(code: i64, machine: MachineType) -> &'static [Feature] {
    match code {
        0 => &[Feature::Rapid],
        1 => &[Feature::Linear],
        2 | 3 => &[Feature::Arc],
        4 => &[Feature::Dwell],
        13 if machine == MachineType::TwoSaddles => &[Feature::TwoSaddles],
        14 | 111 => match machine {
            MachineType::OneTurret => &[Feature::Alarm],
            MachineType::TwoTurrets => &[Feature::TwoTurrets],
            MachineType::TwoSaddles => &[Feature::TwoSaddles],
        },
        13 | 110 => &[Feature::Turret],
        17 | 18 | 40 | 41 | 42 | 119 => &[Feature::RadiusCompensation],
        22 | 28 | 29 => &[Feature::Torque],
        31..=33 | 71 | 72 => PASSES,
        34 | 35 => &[Feature::Thread],
        73 | 74 => GROOVES,
        77 | 78 => TAPS,
        178..=190 => DRIVEN,
        80..=84 => &[Feature::Lap],
        85..=87 => &[Feature::Lap, Feature::Rapid, Feature::Linear],
        88 => &[Feature::Lap, Feature::Thread, Feature::Rapid, Feature::Linear],
        50 => &[],
        64 | 65 => &[Feature::Aux],
        101..=103 | 132 | 133 | 136 | 137 => &[Feature::ContourGeneration],
        75 => &[Feature::Chamfer],
        76 => &[Feature::Rounding],
        90 => &[Feature::Absolute],
        91 => &[Feature::Incremental],
        94 | 95 => &[Feature::Feed],
        96 | 97 => &[Feature::CuttingSpeed],
        161..=170 => &[Feature::MacroCode, Feature::ModalCall],
        171 | 205..=214 => &[Feature::MacroCode, Feature::Subprogram],
        _ => &[Feature::Alarm],
    }
}

/// What a system variable needs.
pub(crate) fn of_system_variable(name: &[u8]) -> Features {
    let mut needs = Features::of(&[Feature::SystemVariable]);
    match name {
        b"VDIN" | b"VDOUT" | b"VIRD" | b"VORD" => needs.add(&[Feature::InputOutput]),
        b"VUACM" => needs.add(&[Feature::UserAlarm]),
        _ => {}
    }
    if INTERFERENCE.iter().any(|(known, ..)| known.as_bytes() == name) {
        return needs;
    }
    match name.get(..4).unwrap_or(name) {
        b"VZSH" => needs.add(&[Feature::ZeroShift]),
        b"VPVL" | b"VNVL" => needs.add(&[Feature::Limits]),
        b"VTOF" | b"VNSR" | b"VETF" | b"VETO" | b"VETL" => needs.add(&[Feature::Tool]),
        _ => {}
    }
    match name.last() {
        Some(b'C') => needs.add(&[Feature::CAxis]),
        Some(b'W') => needs.add(&[Feature::WAxis]),
        _ => {}
    }
    needs
}

/// What a set-up needs.
pub(crate) fn of_setup(setup: &Setup) -> Features {
    let plain = Setup::default();
    let axis = |amounts: AxisAmounts| (amounts.c.0 != 0, amounts.w.0 != 0);
    let (c_start, w_start) = axis(setup.start);
    let (c_zero, w_zero) = axis(setup.zero_offset);
    let (limits, b) = (&setup.limits, &setup.turret_b);
    let machine = setup.machine.r#type;
    let shown = &setup.inputs;
    let inputs = !shown.vdin.is_empty() || !shown.vird.is_empty() || !shown.vord.is_empty();
    let list = [
        (setup.unit_system != UnitSystem::Millimetre, Feature::Units),
        (setup.tape.code != TapeCode::Ascii, Feature::TapeCode),
        (setup.switches.block_delete, Feature::BlockDelete),
        (setup.switches.optional_stop, Feature::OptionalStop),
        (setup.options.w_axis || w_start || w_zero || limits.w != plain.limits.w, Feature::WAxis),
        (c_start || c_zero, Feature::CAxis),
        (machine == MachineType::TwoTurrets, Feature::TwoTurrets),
        (machine == MachineType::TwoSaddles, Feature::TwoSaddles),
        (setup.zero_offset != plain.zero_offset, Feature::ZeroShift),
        (b.zero_offset != PlaneAmounts::default(), Feature::ZeroShift),
        (setup.tool_offset != plain.tool_offset || setup.nose_radius != plain.nose_radius, Feature::Tool),
        (!b.tool_offset.is_empty() || !b.nose_radius.is_empty(), Feature::Tool),
        (b.limits != plain.turret_b.limits, Feature::Limits),
        (!b.torque_stops.is_empty(), Feature::Torque),
        ([limits.x, limits.z, limits.w] != [plain.limits.x, plain.limits.z, plain.limits.w], Feature::Limits),
        (limits.steps != plain.limits.steps, Feature::ControlStatement),
        (setup.barriers != plain.barriers, Feature::Barrier),
        (!setup.macros.is_empty(), Feature::MacroCode),
        (
            !setup.library.is_empty() || setup.parameters.call_depth != plain.parameters.call_depth,
            Feature::Subprogram,
        ),
        (setup.spindle != plain.spindle, Feature::Gear),
        (setup.parameters.thread_chamfer_feed != plain.parameters.thread_chamfer_feed, Feature::Thread),
        (setup.parameters.grooving_retract != plain.parameters.grooving_retract, Feature::Grooving),
        (driven_parameters(setup) != driven_parameters(&plain), Feature::DrivenCycle),
        (setup.parameters.m75_pattern != plain.parameters.m75_pattern, Feature::Thread),
        (setup.stm != plain.stm, Feature::TimeOver),
        (!setup.inputs.torque_stops.is_empty(), Feature::Torque),
        (!setup.inputs.turret_clamp_confirmed, Feature::Turret),
        (setup.inputs.restart, Feature::SystemVariable),
        (!setup.variables.is_empty(), Feature::Variable),
        (contour::is_set_up(setup), Feature::ContourGeneration),
        (lap::is_set_up(setup), Feature::Lap),
        (setup.schedule, Feature::Schedule),
        (!setup.devices.is_empty(), Feature::Communication),
        (setup.parameters.end_code != plain.parameters.end_code, Feature::Communication),
        (inputs, Feature::InputOutput),
        (!setup.system_variables.is_empty(), Feature::SystemVariable),
        (setup.options.tools != plain.options.tools, Feature::SystemVariable),
        (setup.options.tool_groups != plain.options.tool_groups, Feature::SystemVariable),
    ];
    let mut needs = Features::default();
    for (needed, feature) in list {
        if needed {
            needs.add(&[feature]);
        }
    }
    needs
}

/// The parameters of cycles of driven tools.
fn driven_parameters(setup: &Setup) -> (Length, CycleReturn, G184Tapping) {
    let parameters = &setup.parameters;
    (parameters.drilling_retract, parameters.cycle_return, parameters.g184_tapping)
}
