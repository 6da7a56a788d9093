//! What an event must not cite: rules and readings that have nothing to do with it. The examples of the rule
//! texts name what an event must cite.

use turnspec_oracle::vocabulary::notation::render;
use turnspec_oracle::vocabulary::{Chamfering, Event, Length, NoseRadius, RuleId, Setup, UnitSystem};

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

/// E100L-BARR-01 and E100L-BARR-08 are about motions that a barrier looked at: of X or Z, while it is on; the path of a
/// positioning is no matter of a cut.
#[test]
fn only_what_a_barrier_looked_at_is_cited() {
    let program = "M110\nG00 X10\nM25\nX20\nC90\nG01 Z10 F0.2\nM24\nZ20\nM02\n";
    for (ordinal, watched, positioning) in
        [(2, false, false), (4, true, true), (5, false, false), (7, true, false), (9, false, false)]
    {
        let event = event(program, &Setup::default(), ordinal);
        assert_eq!(cites(&event, "E100L-BARR-01"), watched, "{ordinal}");
        assert_eq!(cites(&event, "E100L-BARR-08"), positioning, "{ordinal}");
        let reading = event.readings.iter().any(|reading| reading.as_str() == "barrier_path=line");
        assert_eq!(reading, positioning, "{ordinal}");
    }
}

/// Every motion cites the rules of radius compensation that made its end what it is, and no others.
#[test]
fn motions_cite_the_rules_of_their_ends() {
    let program = "G00 X100 Z100 T010101\nG42 X80\nG01 Z50 F0.2\nX120\nX120\nM08\nG03 X160 Z30 K-20\nG01 Z10\n\
                   M08\nM09\nX200\nG41 Z-20\nG40 X300 I10\nX310\nM02\n";
    let expected = [
        "rapid",
        "mode 01",
        "rapid 07 14 15",
        "mode",
        "linear 07 26 42",
        "linear 07 42 45",
        // The point repeated, one block between, and a tangential arc.
        "linear 07 42 43 46 49",
        "coolant",
        "mode",
        "arc 07 48 49 60",
        "mode",
        "linear 07 42 44",
        "coolant",
        "coolant",
        // The extra motion.
        "linear 07 26 42 46",
        "linear 07 26 42 62",
        "mode 01 61",
        "linear 07 26 42 69",
        "mode 01",
        "linear 66",
        "linear",
        "mode",
        "end",
    ];
    let entry = NoseRadius { number: 1, x: Length(800_000), z: Length(800_000) };
    let setup = Setup { nose_radius: vec![entry], ..Setup::default() };
    let mut found = Vec::new();
    turnspec_oracle::run(program.as_bytes(), &setup, &mut |event: &Event| {
        let text = render(event);
        let rules = event.rules.as_slice().iter().filter_map(|rule| rule.as_str().strip_prefix("E100L-NRC-"));
        let kind = text.split(' ').next().unwrap_or_default().to_owned();
        found.push(rules.fold(kind, |line, rule| line + " " + rule));
    });
    found.retain(|line| line != "tool");
    assert_eq!(found, expected);
}

/// E100L-CHAM-13 is about increments: an absolute block behind a basic chamfer depends on no reading of it.
#[test]
fn only_increments_depend_on_the_corner_before() {
    let mut setup = Setup::default();
    setup.parameters.chamfering = Chamfering::Basic;
    for (mode, depends) in [("G90", false), ("G91", true)] {
        let program = format!("G00 X0 Z0\nG01 G75 Z-20 L2 F0.2\n{mode} X10\nM02\n");
        let mut trace = Vec::new();
        turnspec_oracle::run(program.as_bytes(), &setup, &mut |event: &Event| trace.push(*event));
        let behind = trace.iter().find(|event| event.block.line == 3 && cites(event, "E100L-G01-01"));
        let reading = |event: &Event| {
            event.readings.iter().any(|reading| reading.as_str().starts_with("incremental_after_chamfer"))
        };
        assert_eq!(behind.map(reading), Some(depends), "{mode}");
    }
}
