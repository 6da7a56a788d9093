//! Generated programs reach control flow: how many, how deep, and every rule and alarm of it.

use std::collections::{BTreeMap, BTreeSet};

use turnspec_generator::{Case, case_from_seed, decode};
use turnspec_oracle::vocabulary::rule_ids::*;
use turnspec_oracle::vocabulary::{Action, AlarmName, CallCause, Event, RuleId};

use crate::citations::OF_ALL;

/// The rules that events of control flow cite (execution, section "Rules that events cite").
#[rustfmt::skip]
const CITED: &[RuleId] = &[
    CALL_02, LVAR_04, LVAR_06, LVAR_08, LVAR_10, LVAR_11, LVAR_12, LVAR_13, MACRO_01, MACRO_02, MODIN_02, MODIN_06,
    MODIN_07, MODIN_09, RTS_02,
];

/// The alarms of statements (execution, chapters 3 to 5) and of chapter 9.
#[rustfmt::skip]
const ALARMS: &[(AlarmName, RuleId)] = &[
    (AlarmName::CallDepth, CALL_04),
    (AlarmName::EqualSignMissing, FMT_02),
    (AlarmName::Format, CALL_01),
    (AlarmName::Format, GOTO_01),
    (AlarmName::Format, IFST_01),
    (AlarmName::Format, MODIN_01),
    (AlarmName::Format, MODIN_04),
    (AlarmName::Format, RTS_01),
    (AlarmName::LocalCapacity, LVAR_03),
    (AlarmName::LocalNameMalformed, LVAR_01),
    (AlarmName::LocalUndefined, LVAR_05),
    (AlarmName::MacroUnassigned, MACRO_01),
    (AlarmName::MacroUnassigned, MACRO_02),
    (AlarmName::ModinDepth, MODIN_05),
    (AlarmName::ModoutWithoutModin, MODIN_04),
    (AlarmName::NoProgramEnd, PROG_02),
    (AlarmName::NoReturn, RTS_01),
    (AlarmName::ProgramDuplicate, NAME_05),
    (AlarmName::ProgramKind, PROG_01),
    (AlarmName::ProgramNameMalformed, NAME_01),
    (AlarmName::ProgramNameMisplaced, PROG_02),
    (AlarmName::ProgramNameReserved, NAME_02),
    (AlarmName::ProgramUnknown, CALL_03),
    (AlarmName::ReturnOutsideSubprogram, RTS_04),
    (AlarmName::SequenceNameUnknown, GOTO_02),
    (AlarmName::SequenceNameUnknown, IFST_03),
    (AlarmName::StatementDelimiterMissing, CTL_03),
    (AlarmName::StatementDelimiterMissing, CTL_06),
    (AlarmName::StatementMisplaced, GCODE_03),
    (AlarmName::StatementMisplaced, MACRO_01),
    (AlarmName::StatementMisplaced, MACRO_02),
    (AlarmName::StepLimit, GOTO_03),
    (AlarmName::Unspecified, ANG_05),
    (AlarmName::Unspecified, ANG_06),
    (AlarmName::Unspecified, MODIN_02),
    (AlarmName::Unspecified, MODIN_04),
    (AlarmName::Unspecified, MODIN_07),
    (AlarmName::Unspecified, MODIN_09),
    (AlarmName::UserTaskLevel, UT_03),
    (AlarmName::WordWithoutFunction, CALL_01),
    (AlarmName::WordWithoutFunction, MACRO_01),
    (AlarmName::WordWithoutFunction, MACRO_02),
    (AlarmName::WordWithoutFunction, MODIN_01),
    (AlarmName::WordWithoutFunction, NOEX_01),
];

/// What the programs of many seeds did.
#[derive(Default)]
struct Reached {
    programs: u64,
    ended: u64,
    /// Programs with statements, and those of them that ended.
    controlled: [u64; 2],
    /// Programs in which a block ran again, a program was called, called modally, by a macro code.
    again: u64,
    called: BTreeMap<&'static str, u64>,
    /// Programs in which an alarm was raised in a called program.
    faulty_below: u64,
    events: u64,
}

impl Reached {
    fn add(&mut self, case: &Case) {
        let (mut ended, mut depth, mut again) = (false, 0_u64, false);
        let (mut causes, mut last) = (BTreeSet::new(), (0, 0));
        turnspec_oracle::run(&case.program, &case.setup, &mut |event: &Event| {
            self.events += 1;
            ended |= matches!(event.action, Action::End { .. });
            again |= depth == 0 && last.0 == 0 && event.block.start < last.1;
            last = (depth, event.block.start);
            match event.action {
                Action::Call { cause, .. } => {
                    depth += 1;
                    causes.insert(name(cause));
                }
                Action::Return => depth = depth.saturating_sub(1),
                Action::Alarm(_) => self.faulty_below += u64::from(depth > 0),
                _ => {}
            }
        });
        let controlled = has_statements(case);
        self.programs += 1;
        self.ended += u64::from(ended);
        self.controlled[0] += u64::from(controlled);
        self.controlled[1] += u64::from(controlled && ended);
        self.again += u64::from(again);
        for cause in causes {
            *self.called.entry(cause).or_default() += 1;
        }
    }
}

fn name(cause: CallCause) -> &'static str {
    match cause {
        CallCause::Call => "call",
        CallCause::Modal => "modal",
        CallCause::Macro => "macro",
    }
}

/// Whether a program has statements that lead elsewhere, or codes that call.
fn has_statements(case: &Case) -> bool {
    const STATEMENTS: [&[u8]; 4] = [b"GOTO", b"IF", b"CALL", b"MODIN"];
    let text = decode(&case.program, case.setup.tape.code);
    let has = |keyword: &[u8]| text.windows(keyword.len()).any(|window| window == keyword);
    !case.setup.macros.is_empty() || STATEMENTS.iter().any(|keyword| has(keyword))
}

/// Of a hundred programs with everything allowed about thirty have statements, and most of those end.
#[test]
fn programs_with_control_flow_are_many_and_deep() {
    let mut reached = Reached::default();
    (0..6_000).map(case_from_seed).for_each(|case| reached.add(&case));
    let [controlled, ended] = reached.controlled;
    println!("{} programs, {} ended, {} events", reached.programs, reached.ended, reached.events);
    println!("{controlled} with statements, {ended} of them ended, {} ran blocks again", reached.again);
    println!("called {:?}, {} alarms in called programs", reached.called, reached.faulty_below);
    assert!((1_500..2_100).contains(&controlled), "{controlled} with statements");
    assert!(reached.ended * 100 > reached.programs * 70, "{} ended", reached.ended);
    assert!(ended * 100 > controlled * 65, "{ended} of {controlled} ended");
    assert!(reached.again > 300, "{} ran blocks again", reached.again);
    for cause in ["call", "modal", "macro"] {
        assert!(reached.called.get(cause).is_some_and(|programs| *programs > 60), "{cause}");
    }
    assert!(reached.faulty_below > 40, "{} alarms in called programs", reached.faulty_below);
}

/// Every rule of control flow that an event cites, and every alarm of it with the rule that it stands for.
#[test]
fn every_rule_and_alarm_is_reached() {
    OF_ALL.demand(CITED, ALARMS);
}
