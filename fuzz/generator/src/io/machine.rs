//! What a set-up says of devices, inputs and tool interference data.

use turnspec_oracle::vocabulary::{EndCode, Feature, Length, ProgramText, Setup};

use super::interference::{Holds, NAMES};
use super::transmission;
use crate::choices::Choices;
use crate::profile::Profile;

/// Gives a set-up something to read, as far as a profile allows it.
pub(crate) fn machine(setup: &mut Setup, choices: &mut Choices<'_, '_>, profile: &Profile) {
    let allows = |feature| profile.allows(feature);
    let system = allows(Feature::SystemVariable);
    if allows(Feature::Communication) {
        setup.parameters.end_code = choices.weighted(&[(75, EndCode::Percent), (25, EndCode::Null)]);
        devices(setup, choices);
    }
    if allows(Feature::InputOutput) && system && choices.chance(80) {
        inputs(setup, choices);
    }
    let io = allows(Feature::Communication) || allows(Feature::InputOutput) || allows(Feature::UserAlarm);
    if system && io && choices.chance(40) {
        setup.options.tools = choices.pick(&[12, 20, 96]);
        setup.options.tool_groups = choices.pick(&[12, 20, 24]);
        interference_data(setup, choices);
    }
}

/// Texts of up to three devices.
fn devices(setup: &mut Setup, choices: &mut Choices<'_, '_>) {
    for _ in 0..=choices.below(3) {
        let channel = choices.below(10).min(choices.below(10));
        let count = choices.below(4);
        let texts = (0..count).map(|_| ProgramText(transmission(choices, setup.parameters.end_code)));
        let texts = texts.collect();
        setup.devices.insert(format!("CN{channel}"), texts);
    }
}

/// Values of inputs, some of which always show the same.
fn inputs(setup: &mut Setup, choices: &mut Choices<'_, '_>) {
    for _ in 0..=choices.below(6) {
        let (number, most) = match choices.below(6) {
            0 => (10, 31),
            1 => (choices.within(1_000, 1_004), i64::from(i32::MAX)),
            2 => (choices.within(1_235, 1_250), 255),
            3 => (choices.within(21, 24), 1),
            _ => (choices.pick(&[0, 10, 30]) + choices.within(1, 8), 1),
        };
        let least = if most > 255 && choices.chance(90) { 0 } else { most / 2 };
        let most = if most > 255 && choices.chance(90) { 1_000 } else { most };
        let values =
            list(choices, |choices| i32::try_from(choices.within(least.min(most), most)).unwrap_or_default());
        setup.inputs.vdin.insert(u16::try_from(number).unwrap_or(1), values);
    }
    for bits in [&mut setup.inputs.vird, &mut setup.inputs.vord] {
        for _ in 0..choices.below(3) {
            let address = choices.pick(&[0, 17, 1_234, 9_999]);
            bits.insert(address, list(choices, |choices| u8::from(choices.chance(60))));
        }
    }
}

fn list<T>(choices: &mut Choices<'_, '_>, value: impl Fn(&mut Choices<'_, '_>) -> T) -> Vec<T> {
    (0..=choices.below(4)).map(|_| value(choices)).collect()
}

fn interference_data(setup: &mut Setup, choices: &mut Choices<'_, '_>) {
    for _ in 0..choices.below(5) {
        let (name, group, holds, low, high) = choices.pick(NAMES);
        let most = if group { setup.options.tool_groups } else { setup.options.tools };
        let number = choices.within(1, most.into());
        let unit = if holds == Holds::Whole { 1_000_000 } else { 1_000 };
        let value = choices.within(low, high) * unit;
        setup.system_variables.insert(format!("{name}[{number}]"), Length(value));
    }
}
