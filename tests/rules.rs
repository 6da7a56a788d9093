//! The engine satisfies every example of the rule texts, as the oracle does.

#![allow(clippy::panic)]

use turnspec_oracle::book;
use turnspec_oracle::vocabulary::Event;
use turnspec_oracle::vocabulary::notation::Expectation;

#[test]
fn the_engine_satisfies_every_example() {
    let rules = book::e100l().unwrap_or_else(|fault| panic!("{fault}"));
    let mut faults = Vec::new();
    let mut examples = 0;
    for rule in &rules {
        for example in &rule.examples {
            let place = format!("spec/rules/{}:{} ({})", rule.file, example.line, rule.id);
            let setup = example.setup().unwrap_or_else(|fault| panic!("{place}: {fault}"));
            let mut trace = Vec::new();
            turnspec::engine::run(&example.program, &setup, &mut |event: &Event| trace.push(*event));
            if let Err(divergence) = Expectation::parse(&example.trace).matches(&trace) {
                faults.push(format!("{place}: {divergence}"));
            }
            examples += 1;
        }
    }
    assert!(faults.is_empty(), "{} of {examples} examples:\n{}", faults.len(), faults.join("\n"));
    assert!(examples > 700, "only {examples} examples were found");
}
