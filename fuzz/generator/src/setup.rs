//! Set-ups: the default one often, else machines with other units, options, offsets, limits and readings.

use turnspec_oracle::vocabulary::{
    Angle, ArcOneCoordinate, AxisAmounts, BarrierPath, ChamferLeg, Chamfering, Duration, Feature, FeedLength,
    Gear, InchConversion, IncrementalAfterChamfer, Length, Limit, PutReal, Readings, Setup, Speed,
    SpeedClamp, TapeCode, ToolOffset, ToolOffsetSign, UnitSystem, UserAlarmC,
};

use crate::barriers::barriers;
use crate::choices::Choices;
use crate::compensation::nose_radii;
use crate::io::machine;
use crate::profile::Profile;
use crate::schedule;
use crate::turrets;

/// A set-up that passes [`Setup::validate`].
pub fn setup(choices: &mut Choices<'_, '_>, profile: &Profile) -> Setup {
    let mut setup = Setup::default();
    let machine = turrets::machine_type(choices, profile);
    if !choices.chance(25) {
        unusual(&mut setup, choices, profile);
    }
    turrets::set_up(&mut setup, machine, choices, profile);
    if profile.has_basic_corners() && setup.parameters.chamfering == Chamfering::AnyAngle {
        setup.parameters.chamfering = Chamfering::Basic;
    }
    setup
}

/// Values other than the default ones, each where the profile allows it.
fn unusual(setup: &mut Setup, choices: &mut Choices<'_, '_>, profile: &Profile) {
    let allows = |feature| profile.allows(feature);
    let unit_system = choices.weighted(&[
        (50, UnitSystem::Millimetre),
        (15, UnitSystem::Micrometre),
        (10, UnitSystem::TenMicrometre),
        (12, UnitSystem::TenThousandthInch),
        (13, UnitSystem::Inch),
    ]);
    setup.unit_system = if allows(Feature::Units) { unit_system } else { UnitSystem::Millimetre };
    parameters(setup, choices, profile);
    amounts(setup, choices, profile);
    limits(setup, choices, profile);
    spindle(setup, choices, profile);
    if choices.chance(18) && allows(Feature::Barrier) {
        setup.barriers = barriers(choices);
    }
    setup.readings = if profile.allows_readings() { readings(choices) } else { Readings::default() };
    setup.switches.block_delete = choices.chance(25) && allows(Feature::BlockDelete);
    setup.switches.optional_stop = choices.chance(40) && allows(Feature::OptionalStop);
    let code = choices.weighted(&[(80, TapeCode::Ascii), (12, TapeCode::Iso), (8, TapeCode::Eia)]);
    setup.tape.code = if allows(Feature::TapeCode) { code } else { TapeCode::Ascii };
    setup.inputs.turret_clamp_confirmed = !(choices.chance(20) && allows(Feature::Turret));
    setup.inputs.restart = choices.chance(10) && allows(Feature::SystemVariable);
    let variables = if allows(Feature::Variable) { choices.below(4) } else { 0 };
    for _ in 0..variables {
        let value = choices.within(-99_999, 99_999) as f64 / 64.0;
        setup.variables.insert(format!("V{}", choices.within(1, 9)), value);
    }
    if choices.chance(10) {
        machine(setup, choices, profile);
    }
    setup.schedule = choices.chance(9) && schedule::is_within(profile);
}

/// Whether an S, T or M function takes longer than the time check allows (E100L-STM-01).
#[must_use]
pub fn is_over_time(setup: &Setup) -> bool {
    let stm = &setup.stm;
    stm.enabled && [stm.s, stm.t, stm.m].iter().any(|time| *time > stm.limit)
}

fn parameters(setup: &mut Setup, choices: &mut Choices<'_, '_>, profile: &Profile) {
    let allows = |feature| profile.allows(feature);
    let parameters = &mut setup.parameters;
    parameters.circular_radius_tolerance =
        Length(choices.pick(&[20_000, 20_000, 5_000, 1_000, 0, 1_000_000]));
    parameters.chamfering =
        choices.weighted(&[(50, Chamfering::AnyAngle), (35, Chamfering::Basic), (15, Chamfering::Off)]);
    if profile.allows(Feature::Torque) {
        parameters.torque_limit_upper = choices.pick(&[100, 80, 50, 1]);
        parameters.torque_monitor_delay = choices.pick(&[0, 0, 0, 1, 10, 9_999]);
    }
    if profile.allows(Feature::Subprogram) {
        parameters.call_depth = choices.pick(&[8, 8, 8, 8, 1, 2, 3, 126]);
    }
    let options = &mut setup.options;
    options.nose_radius_compensation = !(choices.chance(10) && profile.allows(Feature::Tool));
    options.offset_sets = choices.pick(&[32, 64, 96]);
    options.w_axis = choices.chance(35) && profile.allows(Feature::WAxis);
    let level_2 = [Feature::Boolean, Feature::Function, Feature::Subprogram];
    let tasks = level_2.into_iter().any(allows);
    options.user_task = if choices.chance(12) && tasks { 1 } else { 2 };
}

/// Start position, zero offset, tool data.
fn amounts(setup: &mut Setup, choices: &mut Choices<'_, '_>, profile: &Profile) {
    let tool = profile.allows(Feature::Tool);
    if choices.chance(50) && profile.allows(Feature::ZeroShift) {
        setup.zero_offset = AxisAmounts {
            x: length(choices, 400),
            z: length(choices, 800),
            c: Angle(choices.within(-360, 360) * 1_000_000),
            w: length(choices, 300),
        };
    }
    if choices.chance(60) {
        let zero = setup.zero_offset;
        setup.start = AxisAmounts {
            x: Length(zero.x.0 + choices.within(0, 300_000) * 1_000),
            z: Length(zero.z.0 + choices.within(-200_000, 200_000) * 1_000),
            c: Angle(choices.within(0, 359_999) * 1_000),
            w: Length(zero.w.0 + choices.within(-200_000, 200_000) * 1_000),
        };
    }
    if !profile.allows(Feature::CAxis) {
        (setup.start.c, setup.zero_offset.c) = (Angle(0), Angle(0));
    }
    if !profile.allows(Feature::WAxis) {
        (setup.start.w, setup.zero_offset.w) = (Length(0), Length(0));
    }
    if choices.chance(60) && tool {
        setup.tool_offset = tool_offsets(choices);
    }
    if choices.chance(60) && tool {
        setup.nose_radius = nose_radii(choices, setup.options.offset_sets);
    }
}

/// An amount of at most so many millimetres.
pub(crate) fn length(choices: &mut Choices<'_, '_>, most: i64) -> Length {
    let grid = choices.pick(&[1_000_000, 1_000]);
    Length(choices.within(-most * 1_000_000 / grid, most * 1_000_000 / grid) * grid)
}

/// Tool offsets 1 to 4.
pub(crate) fn tool_offsets(choices: &mut Choices<'_, '_>) -> Vec<ToolOffset> {
    let offset = |number| {
        let (x, z) = (length(choices, 60), length(choices, 60));
        ToolOffset { number, x, z }
    };
    (1..=4).map(offset).collect()
}

/// A limit on each side, or not, that leaves room around a start.
pub(crate) fn limit(choices: &mut Choices<'_, '_>, start: Length) -> Limit {
    let away = |choices: &mut Choices<'_, '_>| choices.within(60_000, 500_000) * 1_000;
    Limit {
        positive: choices.chance(25).then(|| Length(start.0 + away(choices))),
        negative: choices.chance(25).then(|| Length(start.0 - away(choices))),
    }
}

/// Limits that leave room around the start.
fn limits(setup: &mut Setup, choices: &mut Choices<'_, '_>, profile: &Profile) {
    if !profile.allows(Feature::Limits) {
        return;
    }
    let starts = [setup.start.x, setup.start.z, setup.start.w];
    let axes = [&mut setup.limits.x, &mut setup.limits.z, &mut setup.limits.w];
    for (axis, start) in axes.into_iter().zip(starts) {
        *axis = limit(choices, start);
    }
    if !profile.allows(Feature::WAxis) {
        setup.limits.w = Limit::default();
    }
}

fn spindle(setup: &mut Setup, choices: &mut Choices<'_, '_>, profile: &Profile) {
    if choices.chance(40) && profile.allows(Feature::Gear) {
        setup.spindle.minimum = Speed(choices.pick(&[0, 50_000, 123_456]));
        setup.spindle.maximum = Speed(choices.pick(&[4_500_000, 6_000_000, 65_535_000]));
        for code in 40..=44 {
            if choices.chance(40) {
                let minimum = Speed(choices.within(0, 500) * 1_000);
                let maximum = Speed(minimum.0 + choices.within(0, 5_000) * 1_000);
                setup.spindle.gear.push(Gear { code, minimum, maximum });
            }
        }
    }
    if choices.chance(25) && profile.allows(Feature::TimeOver) {
        let stm = &mut setup.stm;
        stm.enabled = !choices.chance(20);
        stm.limit = Duration(choices.within(0, 600) * 100_000);
        let time = |choices: &mut Choices<'_, '_>| {
            Duration(choices.pick(&[0, stm.limit.0, stm.limit.0, stm.limit.0 / 2, stm.limit.0 + 1]))
        };
        let times = [time(choices), time(choices), time(choices)];
        [stm.s, stm.t, stm.m] = times;
    }
}

fn readings(choices: &mut Choices<'_, '_>) -> Readings {
    if choices.chance(50) {
        return Readings::default();
    }
    Readings {
        inch_conversion: choices.pick(&[InchConversion::MetricIncrement, InchConversion::InchIncrement]),
        arc_one_coordinate: choices.pick(&[ArcOneCoordinate::Quadrant, ArcOneCoordinate::Start]),
        chamfer_leg: choices.pick(&[ChamferLeg::Leg, ChamferLeg::Face]),
        incremental_after_chamfer: choices
            .pick(&[IncrementalAfterChamfer::Corner, IncrementalAfterChamfer::End]),
        feed_length: choices.pick(&[FeedLength::Radius, FeedLength::Diameter]),
        tool_offset: choices.pick(&[ToolOffsetSign::Added, ToolOffsetSign::Subtracted]),
        barrier_path: choices.pick(&[BarrierPath::Line, BarrierPath::Ends]),
        put_real: choices.pick(&[PutReal::Fixed, PutReal::Shortest]),
        user_alarm_c: choices.pick(&[UserAlarmC::Continues, UserAlarmC::Stops]),
        speed_clamp: choices.pick(&[SpeedClamp::Always, SpeedClamp::CuttingSpeed]),
        ..Readings::default()
    }
}
