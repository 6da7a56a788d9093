//! Set-ups of machines with two turrets or two saddles.

use turnspec_oracle::vocabulary::{
    Barriers, Feature, Length, MachineType, PlaneAmounts, PlaneLimits, Setup, TurretB,
};

use crate::choices::Choices;
use crate::compensation::nose_radii;
use crate::profile::Profile;
use crate::setup::{length, limit, tool_offsets};

/// The machine of a program: most have one turret.
pub(crate) fn machine_type(choices: &mut Choices<'_, '_>, profile: &Profile) -> MachineType {
    let machine = choices.weighted(&[
        (84, MachineType::OneTurret),
        (8, MachineType::TwoTurrets),
        (8, MachineType::TwoSaddles),
    ]);
    let allowed = match machine {
        MachineType::OneTurret => true,
        MachineType::TwoTurrets => profile.allows(Feature::TwoTurrets),
        MachineType::TwoSaddles => profile.allows(Feature::TwoSaddles),
    };
    if allowed { machine } else { MachineType::OneTurret }
}

/// Makes a set-up one of that machine.
pub(crate) fn set_up(
    setup: &mut Setup,
    machine: MachineType,
    choices: &mut Choices<'_, '_>,
    profile: &Profile,
) {
    if machine == MachineType::OneTurret {
        return;
    }
    setup.machine.r#type = machine;
    setup.barriers = Barriers::default();
    if machine == MachineType::TwoSaddles {
        setup.options.w_axis = false;
        setup.schedule = false;
    }
    if choices.chance(85) {
        setup.turret_b = turret_b(setup, choices, profile);
    }
}

/// Data of turret B, or of saddle B, drawn like those of A.
fn turret_b(setup: &Setup, choices: &mut Choices<'_, '_>, profile: &Profile) -> TurretB {
    let tool = profile.allows(Feature::Tool);
    let mut b = TurretB::default();
    if choices.chance(50) && profile.allows(Feature::ZeroShift) {
        b.zero_offset = PlaneAmounts { x: length(choices, 400), z: length(choices, 800) };
    }
    if choices.chance(60) && tool {
        b.tool_offset = tool_offsets(choices);
    }
    if choices.chance(60) && tool {
        b.nose_radius = nose_radii(choices, setup.options.offset_sets);
    }
    if setup.machine.r#type == MachineType::TwoTurrets {
        return b;
    }
    if choices.chance(60) {
        b.start = PlaneAmounts {
            x: Length(b.zero_offset.x.0 + choices.within(0, 300_000) * 1_000),
            z: Length(b.zero_offset.z.0 + choices.within(-200_000, 200_000) * 1_000),
        };
    }
    if profile.allows(Feature::Limits) {
        b.limits = PlaneLimits { x: limit(choices, b.start.x), z: limit(choices, b.start.z) };
    }
    b
}
