//! Set-ups: the default one often, else machines with other units, options, offsets, limits and readings.

use turnspec_oracle::vocabulary::{
    Angle, ArcOneCoordinate, AxisAmounts, ChamferLeg, Chamfering, Duration, FeedLength, Gear, InchConversion,
    IncrementalAfterChamfer, Length, Limit, NoseRadius, Readings, Setup, Speed, SpeedClamp, TapeCode,
    ToolOffset, ToolOffsetSign, UnitSystem,
};

use crate::choices::Choices;

/// A set-up that passes [`Setup::validate`].
pub fn setup(choices: &mut Choices<'_, '_>) -> Setup {
    let mut setup = Setup::default();
    if choices.chance(25) {
        return setup;
    }
    setup.unit_system = choices.weighted(&[
        (50, UnitSystem::Millimetre),
        (15, UnitSystem::Micrometre),
        (10, UnitSystem::TenMicrometre),
        (12, UnitSystem::TenThousandthInch),
        (13, UnitSystem::Inch),
    ]);
    parameters(&mut setup, choices);
    amounts(&mut setup, choices);
    limits(&mut setup, choices);
    spindle(&mut setup, choices);
    setup.readings = readings(choices);
    setup.switches.block_delete = choices.chance(25);
    setup.switches.optional_stop = choices.chance(40);
    setup.tape.code = choices.weighted(&[(80, TapeCode::Ascii), (12, TapeCode::Iso), (8, TapeCode::Eia)]);
    setup.inputs.turret_clamp_confirmed = !choices.chance(20);
    setup.inputs.restart = choices.chance(10);
    for _ in 0..choices.below(4) {
        let value = choices.within(-99_999, 99_999) as f64 / 64.0;
        setup.variables.insert(format!("V{}", choices.within(1, 9)), value);
    }
    setup
}

/// Whether an S, T or M function takes longer than the time check allows (E100L-STM-01).
#[must_use]
pub fn is_over_time(setup: &Setup) -> bool {
    let stm = &setup.stm;
    stm.enabled && [stm.s, stm.t, stm.m].iter().any(|time| *time > stm.limit)
}

fn parameters(setup: &mut Setup, choices: &mut Choices<'_, '_>) {
    let parameters = &mut setup.parameters;
    parameters.circular_radius_tolerance =
        Length(choices.pick(&[20_000, 20_000, 5_000, 1_000, 0, 1_000_000]));
    parameters.chamfering =
        choices.weighted(&[(50, Chamfering::AnyAngle), (35, Chamfering::Basic), (15, Chamfering::Off)]);
    parameters.torque_limit_upper = choices.pick(&[100, 80, 50, 1]);
    parameters.torque_monitor_delay = choices.pick(&[0, 0, 0, 1, 10, 9_999]);
    let options = &mut setup.options;
    options.nose_radius_compensation = !choices.chance(25);
    options.offset_sets = choices.pick(&[32, 64, 96]);
    options.w_axis = choices.chance(35);
    options.user_task = if choices.chance(12) { 1 } else { 2 };
}

/// Start position, zero offset, tool data.
fn amounts(setup: &mut Setup, choices: &mut Choices<'_, '_>) {
    let length = |choices: &mut Choices<'_, '_>, most: i64| {
        let grid = choices.pick(&[1_000_000, 1_000]);
        Length(choices.within(-most * 1_000_000 / grid, most * 1_000_000 / grid) * grid)
    };
    if choices.chance(50) {
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
    if choices.chance(60) {
        for number in 1..=4 {
            let (x, z) = (length(choices, 60), length(choices, 60));
            setup.tool_offset.push(ToolOffset { number, x, z });
        }
    }
    if choices.chance(20) {
        setup.nose_radius.push(NoseRadius { number: 1, x: Length(-800_000), z: Length(-800_000) });
    }
}

/// Limits that leave room around the start.
fn limits(setup: &mut Setup, choices: &mut Choices<'_, '_>) {
    let starts = [setup.start.x, setup.start.z, setup.start.w];
    let axes = [&mut setup.limits.x, &mut setup.limits.z, &mut setup.limits.w];
    for (limit, start) in axes.into_iter().zip(starts) {
        let away = |choices: &mut Choices<'_, '_>| choices.within(60_000, 500_000) * 1_000;
        *limit = Limit {
            positive: choices.chance(25).then(|| Length(start.0 + away(choices))),
            negative: choices.chance(25).then(|| Length(start.0 - away(choices))),
        };
    }
}

fn spindle(setup: &mut Setup, choices: &mut Choices<'_, '_>) {
    if choices.chance(40) {
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
    if choices.chance(25) {
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
        speed_clamp: choices.pick(&[SpeedClamp::Always, SpeedClamp::CuttingSpeed]),
    }
}
