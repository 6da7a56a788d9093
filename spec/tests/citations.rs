//! What an event must not cite: rules and readings that have nothing to do with it. The examples of the rule
//! texts name what an event must cite.

use turnspec_oracle::vocabulary::{Event, RuleId, Setup, UnitSystem};

/// The event with this ordinal.
fn event(program: &str, setup: &Setup, ordinal: usize) -> Event {
    let mut trace = Vec::new();
    turnspec_oracle::run(program.as_bytes(), setup, &mut |event: &Event| trace.push(*event));
    trace[ordinal - 1]
}

fn cites(event: &Event, rule: &str) -> bool {
    let rule = RuleId::parse(rule);
    assert!(rule.is_some());
    event.rules.as_slice().iter().any(|cited| Some(*cited) == rule)
}

/// E100L-TOOL-05 is about tool number 00: T0100 has tool number 01.
#[test]
fn a_tool_number_is_not_the_rule_of_number_zero() {
    let setup = Setup::default();
    assert!(cites(&event("T0032\nM02\n", &setup, 1), "E100L-TOOL-05"));
    assert!(!cites(&event("T0100\nM02\n", &setup, 1), "E100L-TOOL-05"));
}

/// E100L-INCH-02 is about lengths: a block with an angle alone, or in millimetres, depends on no conversion.
#[test]
fn only_lengths_in_inches_are_converted() {
    let inch = Setup { unit_system: UnitSystem::Inch, ..Setup::default() };
    for (setup, words, converted) in [
        (&inch, "X1", true),
        (&inch, "C90", false),
        (&Setup::default(), "X1", false),
        (&Setup::default(), "C90", false),
    ] {
        let event = event(&format!("M110\nG00 {words}\nM02\n"), setup, 2);
        assert_eq!(cites(&event, "E100L-INCH-02"), converted, "{words}");
        assert_eq!(
            event.readings.iter().any(|reading| reading.as_str().starts_with("inch_conversion")),
            converted,
            "{words}"
        );
    }
}
