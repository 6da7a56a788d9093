//! Generated programs reach data communication, inputs and outputs, user alarms and schedules: how many, how deep, and
//! every rule and alarm of them.

use std::collections::BTreeMap;

use turnspec_generator::{Case, case_from_seed};
use turnspec_oracle::vocabulary::rule_ids::*;
use turnspec_oracle::vocabulary::{Action, AlarmName, Event, RuleId};

use crate::citations::OF_ALL;
use crate::programs::cites;

/// The rules that events cite (input, output and schedules, section 7).
#[rustfmt::skip]
const CITED: &[RuleId] = &[
    RDWR_02, RDWR_04, GPUT_01, GPUT_03, IOV_02, IOV_03, IOV_07, VUACM_01, VUACM_02, VUACM_03, VUACM_04, VUACM_05, SVAR_14,
    TYPE_05, TYPE_06, TYPE_07, SDF_06, SDF_14, SDF_17, SDF_20, MCODE_04,
];

/// The alarms with the rules that they stand for.
#[rustfmt::skip]
const ALARMS: &[(AlarmName, RuleId)] = &[
    (AlarmName::AngleLookahead, ANG_05),
    (AlarmName::DeviceNoData, RDWR_05),
    (AlarmName::DeviceUnknown, RDWR_01),
    (AlarmName::DeviceUnknown, RDWR_02),
    (AlarmName::EqualSignMissing, SDF_13),
    (AlarmName::FieldLength, GPUT_01),
    (AlarmName::FieldLength, GPUT_07),
    (AlarmName::FieldTooSmall, GPUT_07),
    (AlarmName::FileMissing, SDF_07),
    (AlarmName::FileMissing, SDF_10),
    (AlarmName::FileNameMalformed, SDF_07),
    (AlarmName::FileNameMalformed, SDF_10),
    (AlarmName::FileWildcard, SDF_07),
    (AlarmName::ForbiddenCode, GPUT_10),
    (AlarmName::Format, GPUT_01),
    (AlarmName::Format, GPUT_07),
    (AlarmName::Format, GPUT_09),
    (AlarmName::Format, GPUT_10),
    (AlarmName::Format, RDWR_01),
    (AlarmName::Format, RDWR_02),
    (AlarmName::Format, SDF_06),
    (AlarmName::Format, SDF_17),
    (AlarmName::Format, SDF_20),
    (AlarmName::Format, VUACM_01),
    (AlarmName::IllegalCharacter, FMT_08),
    (AlarmName::MainEndMissing, SDF_09),
    (AlarmName::NoProgramEnd, PROG_02),
    (AlarmName::NumberMalformed, GPUT_10),
    (AlarmName::NumberMalformed, VUACM_04),
    (AlarmName::ProgramDuplicate, NAME_05),
    (AlarmName::ProgramMissing, SDF_08),
    (AlarmName::ProgramNameMalformed, NAME_01),
    (AlarmName::ProgramNameReserved, NAME_02),
    (AlarmName::ProgramUnknown, CALL_03),
    (AlarmName::ReadPointer, GPUT_05),
    (AlarmName::ReadTooLong, RDWR_05),
    (AlarmName::ReceivedNumber, GPUT_05),
    (AlarmName::RepetitionsRange, SDF_13),
    (AlarmName::ScheduleBlock, SDF_02),
    (AlarmName::ScheduleBlock, SDF_04),
    (AlarmName::ScheduleEndMissing, SDF_20),
    (AlarmName::ScheduleLeftSide, SDF_18),
    (AlarmName::ScheduleRightSide, SDF_19),
    (AlarmName::ScheduleStatement, SDF_02),
    (AlarmName::SequenceNameUnknown, GOTO_02),
    (AlarmName::StatementDelimiterMissing, CTL_03),
    (AlarmName::StringTooLong, GPUT_09),
    (AlarmName::StringTooLong, GPUT_10),
    (AlarmName::StringTooLong, VUACM_01),
    (AlarmName::SubprogramRtsMissing, SDF_12),
    (AlarmName::Unspecified, IOV_02),
    (AlarmName::Unspecified, SDF_07),
    (AlarmName::Unspecified, SDF_14),
    (AlarmName::Unspecified, VUACM_01),
    (AlarmName::Unspecified, VUACM_05),
    (AlarmName::UserAlarmA, VUACM_02),
    (AlarmName::UserAlarmB, VUACM_02),
    (AlarmName::UserAlarmC, VUACM_02),
    (AlarmName::UserTaskLevel, IOV_01),
    (AlarmName::UserTaskLevel, IOV_02),
    (AlarmName::UserTaskLevel, UT_03),
    (AlarmName::VariableRange, IOV_02),
    (AlarmName::VariableRange, IOV_03),
    (AlarmName::VariableRange, IOV_07),
    (AlarmName::VariableRange, SVTAB_01),
    (AlarmName::VariableReadOnly, IORD_01),
    (AlarmName::VariableReadOnly, IOV_01),
    (AlarmName::VariableReadOnly, SVTAB_01),
    (AlarmName::VariableSuffix, IORD_01),
    (AlarmName::VariableSuffix, IOV_01),
    (AlarmName::VariableSuffix, IOV_02),
    (AlarmName::VariableSuffix, SVTAB_01),
    (AlarmName::VariableSuffix, VUACM_01),
    (AlarmName::WriteAreaFull, GPUT_11),
];

/// What the programs of many seeds did.
#[derive(Default)]
struct Reached {
    /// Programs with words of data communication, inputs, outputs or user alarms, and those of them that ended.
    talking: [u64; 2],
    /// How the programs ended whose set-up has devices, inputs or tool interference data.
    endings: BTreeMap<&'static str, u64>,
    /// Schedules, those of them that ended, those that selected a program, and programs selected in all.
    schedules: [u64; 4],
    /// Events by their kind.
    outputs: u64,
    messages: u64,
    received: u64,
}

impl Reached {
    fn add(&mut self, case: &Case) {
        let (mut selected, mut last) = (0, None);
        turnspec_oracle::run(&case.program, &case.setup, &mut |event: &Event| {
            self.outputs += u64::from(matches!(event.action, Action::Output { .. }));
            self.messages += u64::from(matches!(event.action, Action::Message { .. }));
            self.received += u64::from(cites(event, GPUT_01));
            selected += u64::from(matches!(event.action, Action::Select { .. }));
            last = Some(*event);
        });
        let ended = last.is_some_and(|event| matches!(event.action, Action::End { .. }));
        if talks(case) {
            self.talking[0] += 1;
            self.talking[1] += u64::from(ended);
        }
        let inputs = &case.setup.inputs;
        if !case.setup.devices.is_empty()
            || !inputs.vdin.is_empty()
            || !case.setup.system_variables.is_empty()
        {
            let alarm = match last.map(|event| event.action) {
                Some(Action::Alarm(alarm)) => alarm.name.as_str(),
                _ => "end",
            };
            *self.endings.entry(alarm).or_default() += 1;
        }
        let header =
            String::from_utf8_lossy(&case.program).lines().next().is_some_and(|line| line.contains(".SDF%"));
        if header || case.setup.schedule {
            for (count, more) in
                self.schedules.iter_mut().zip([1, u64::from(ended), u64::from(selected > 0), selected])
            {
                *count += more;
            }
        }
    }
}

/// Whether a program has words of data communication, inputs, outputs or user alarms.
fn talks(case: &Case) -> bool {
    let texts = case.setup.library.values().map(|text| &text.0).chain([&case.program]);
    texts.into_iter().any(|text| {
        let text =
            String::from_utf8_lossy(&turnspec_generator::decode(text, case.setup.tape.code)).into_owned();
        ["READ", "WRITE", "GET", "PUT", "VDIN", "VDOUT", "VIRD", "VORD", "VUACM"]
            .iter()
            .any(|word| text.contains(word))
    })
}

/// Of a hundred programs about seven have such words, one way or another, and six are schedules; most of them end.
#[test]
fn programs_with_input_and_output_and_schedules_are_many_and_deep() {
    const SOME: u64 = 6_000;
    let mut reached = Reached::default();
    (0..SOME).map(case_from_seed).for_each(|case| reached.add(&case));
    let [talking, ended] = reached.talking;
    let [schedules, schedules_ended, selecting, selected] = reached.schedules;
    println!("{talking} with input and output, {ended} of them ended");
    println!("those with devices or inputs: {:?}", reached.endings);
    println!("{schedules} schedules, {schedules_ended} ended, {selecting} selected {selected} programs");
    println!(
        "{} outputs, {} messages, {} numbers received",
        reached.outputs, reached.messages, reached.received
    );
    assert!((SOME / 16..SOME / 6).contains(&talking), "{talking} with input and output");
    assert!(ended * 100 > talking * 40, "{ended} of {talking} ended");
    let with_devices: u64 = reached.endings.values().sum();
    let ended = reached.endings.get("end").copied().unwrap_or_default();
    assert!(ended * 100 > with_devices * 60, "{ended} of {with_devices} ended");
    assert!((SOME / 22..SOME / 12).contains(&schedules), "{schedules} schedules");
    assert!(schedules_ended * 100 > schedules * 60, "{schedules_ended} of {schedules} schedules ended");
    assert!(selecting * 100 > schedules * 70, "{selecting} of {schedules} schedules selected");
    assert!(selected > 3 * selecting, "{selected} programs were selected");
    for (what, count) in
        [("outputs", reached.outputs), ("messages", reached.messages), ("numbers", reached.received)]
    {
        assert!(count > 50, "{count} {what}");
    }
}

/// Every rule of these families that an event cites, and every alarm of them with the rule that it stands for.
#[test]
fn every_rule_and_alarm_of_input_and_output_is_reached() {
    OF_ALL.demand(CITED, ALARMS);
}
