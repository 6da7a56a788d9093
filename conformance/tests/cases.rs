//! Every case is well formed, and both implementations satisfy it.

use turnspec_conformance::{Case, Flag, cases, features_of};
use turnspec_oracle::vocabulary::{Event, Feature, RuleId, Setup, notation::Expectation};

type Outcome = Result<(), String>;

#[test]
fn cases_are_well_formed() -> Outcome {
    report(well_formed)
}

#[test]
fn the_oracle_satisfies_every_case() -> Outcome {
    report(|case| {
        case.check(&trace(case, |program, setup, mut sink| {
            turnspec_oracle::run(program, setup, &mut sink);
        })?)
    })
}

#[test]
fn the_engine_satisfies_every_case() -> Outcome {
    report(|case| {
        case.check(&trace(case, |program, setup, mut sink| {
            turnspec::engine::run(program, setup, &mut sink);
        })?)
    })
}

#[test]
fn every_case_lists_the_features_that_it_needs() -> Outcome {
    report(|case| {
        let trace = trace(case, |program, setup, mut sink| {
            turnspec_oracle::run(program, setup, &mut sink);
        })?;
        let setup = case.setup().map_err(|error| error.to_string())?;
        let features: Vec<Feature> =
            features_of(case.program.as_bytes(), &setup, &trace).into_iter().collect();
        let names: Vec<&str> = features.iter().map(|feature| feature.as_str()).collect();
        ensure(features == case.features, &format!("the features are {names:?}"))
    })
}

/// Applies a check to every case; all failures are reported together.
fn report(check: impl Fn(&Case) -> Outcome) -> Outcome {
    let cases = cases()?;
    assert!(!cases.is_empty());
    let failures: Vec<String> = cases
        .iter()
        .filter_map(|case| check(case).err().map(|reason| format!("{}: {reason}", case.id)))
        .collect();
    assert!(failures.is_empty(), "{}", failures.join("\n"));
    Ok(())
}

fn trace(case: &Case, run: impl FnOnce(&[u8], &Setup, &mut dyn FnMut(&Event))) -> Result<Vec<Event>, String> {
    let mut events = Vec::new();
    let setup = case.setup().map_err(|error| error.to_string())?;
    let program = case.program_bytes().ok_or("the program has a character above U+00FF")?;
    run(&program, &setup, &mut |event: &Event| events.push(*event));
    Ok(events)
}

/// What the schema cannot say: the set-up is possible, the expected trace is complete, ends as a trace
/// ends, cites rules that exist, and flags the readings that it names; figures refer to its events.
fn well_formed(case: &Case) -> Outcome {
    case.setup().map_err(|error| error.to_string())?;
    let expectation = Expectation::parse(&case.expect.join("\n"));
    let lines = expectation.lines();
    ensure(lines == case.expect, "a line of `expect` is empty, a remark or not trimmed")?;
    ensure(lines.iter().all(|line| line != "..."), "`expect` leaves events out")?;
    let last = lines.last().map_or("", |line| line.as_str());
    ensure(last.starts_with("end ") || last.starts_with("alarm "), "`expect` does not end the trace")?;
    for line in lines {
        let rules = field(line, "rules").ok_or(format!("`{line}` cites no rule"))?;
        for id in rules.split('+') {
            ensure(RuleId::parse(id).is_some(), &format!("`{line}`: unknown rule {id}"))?;
        }
    }
    let names_reading = lines.iter().any(|line| field(line, "readings").is_some());
    ensure(names_reading == case.flags.contains(&Flag::Reading), "the flag `reading` is wrong")?;
    ensure(!case.rules.is_empty() && !case.derivation.is_empty(), "no rules or no derivation")?;
    for figure in &case.stated {
        let ordinals = [figure.event, figure.since];
        let exist = ordinals.iter().flatten().all(|n| (1..=lines.len() as u64).contains(n));
        ensure(exist, &format!("{}: no such event", figure.what))?;
        ensure(figure.event.is_some() != figure.field.is_empty(), &format!("{}: no field", figure.what))?;
    }
    Ok(())
}

fn field<'a>(line: &'a str, key: &str) -> Option<&'a str> {
    line.split_whitespace()
        .find_map(|word| word.split_once('=').filter(|(name, _)| *name == key))
        .map(|(_, value)| value)
}

fn ensure(holds: bool, otherwise: &str) -> Outcome {
    if holds { Ok(()) } else { Err(otherwise.to_owned()) }
}
