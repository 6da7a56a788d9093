//! The oracle and the engine agree on generated programs, on raw bytes, and on every regression.
//!
//! `TURNSPEC_DIFFERENTIAL_BLOCKS` sets how many blocks the seeded run carries out (20 000 by default);
//! `cargo run --release --example differential` runs longer.

#![allow(clippy::panic)]

#[allow(dead_code)]
mod support;

use proptest::prelude::*;
use support::campaign::{self, Summary};
use support::regression;
use turnspec::differential::compare;
use turnspec_generator::{
    Case, arcs_and_chamfers, case_from_seed, compensated, expressions, straight_line, with_nose,
};
use turnspec_oracle::vocabulary::{Action, AlarmName, Event, RuleSet, Setup};

/// From this size on a run has to meet every alarm.
const LARGE: u64 = 500_000;

fn wanted_blocks() -> u64 {
    let variable = std::env::var("TURNSPEC_DIFFERENTIAL_BLOCKS").ok();
    variable.and_then(|text| text.parse().ok()).unwrap_or(20_000)
}

#[test]
fn seeded_programs_agree() {
    let wanted = wanted_blocks();
    let mut summary = Summary::default();
    for seed in 0.. {
        if let Err(failure) = campaign::run_seed(seed, &mut summary) {
            panic!("{}", report(&campaign::smallest(*failure)));
        }
        if summary.blocks >= wanted {
            break;
        }
    }
    println!("{summary}");
    assert!(summary.percent_ended() > 50.0, "only {:.1} % ran to the end", summary.percent_ended());
    if wanted >= LARGE {
        let never: Vec<_> =
            AlarmName::ALL.iter().filter(|name| !summary.alarms.contains_key(name.as_str())).collect();
        assert!(never.is_empty(), "alarms that no program raised: {never:?}");
    }
}

/// A failure as the two files of a regression.
fn report(failure: &campaign::Failure) -> String {
    let name = format!("seed-{}", failure.seed);
    let setup = regression::setup_text(&failure.case.setup).unwrap_or_else(|message| message);
    let program = failure.case.program.escape_ascii();
    format!(
        "seed {}\n{}\nregression fuzz/regressions/{name}.min (escaped):\n{program}\n\
         fuzz/regressions/{name}.setup.toml:\n{setup}",
        failure.seed, failure.message
    )
}

/// The generator is measured with the oracle alone, so that its depth does not depend on an agreement.
#[test]
fn most_programs_run_to_their_end() {
    let (mut ended, mut events) = (0, 0_u64);
    const PROGRAMS: u64 = 400;
    for seed in 0..PROGRAMS {
        let case = case_from_seed(seed);
        turnspec_oracle::run(&case.program, &case.setup, &mut |event: &Event| {
            events += 1;
            ended += u64::from(matches!(event.action, Action::End { .. }));
        });
    }
    assert!(ended * 10 > PROGRAMS * 6, "{ended} of {PROGRAMS} programs reached M02 or M30");
    assert!(events > PROGRAMS * 10, "{events} events of {PROGRAMS} programs");
}

/// A trace is the same after a way through JSON, and no event cites more rules than a set holds.
#[test]
fn traces_read_back_from_json() -> Result<(), serde_json::Error> {
    for seed in 0..400 {
        let case = case_from_seed(seed);
        let mut trace = Vec::new();
        turnspec_oracle::run(&case.program, &case.setup, &mut |event: &Event| trace.push(*event));
        for event in trace {
            assert!(event.rules.as_slice().len() < RuleSet::CAPACITY, "{event:?}");
            let text = serde_json::to_string(&event)?;
            assert_eq!(serde_json::from_str::<Event>(&text)?, event, "{text}");
        }
    }
    Ok(())
}

#[test]
fn benchmark_programs_run_without_an_alarm() {
    let plain = Setup::default;
    for blocks in [2, 3, 50, 501] {
        for (program, setup) in [
            (straight_line(blocks), plain()),
            (arcs_and_chamfers(blocks), plain()),
            (expressions(blocks), plain()),
            (compensated(blocks), with_nose()),
        ] {
            let text = String::from_utf8_lossy(&program).into_owned();
            assert_eq!(text.lines().count(), blocks);
            match compare(&program, &setup) {
                Ok(agreement) => assert_eq!(agreement.alarm, None, "{text}"),
                Err(disagreement) => panic!("{disagreement}"),
            }
        }
    }
}

#[test]
fn regressions_agree() -> Result<(), String> {
    for (name, case) in regression::all()? {
        compare(&case.program, &case.setup).map_err(|disagreement| format!("{name}\n{disagreement}"))?;
    }
    Ok(())
}

#[test]
fn a_setup_text_gives_the_setup_back() -> Result<(), String> {
    for seed in 0..300 {
        let setup = case_from_seed(seed).setup;
        let text = regression::setup_text(&setup)?;
        assert_eq!(Setup::from_toml(&text).map_err(|error| format!("{error}\n{text}"))?, setup);
    }
    Ok(())
}

/// Bytes that make up programs, and some that do not belong there.
fn program_bytes() -> impl Strategy<Value = Vec<u8>> {
    let common = b"GGGMMXXZZIKLFSTNOVAC0123456789..--=\n\n\n/()[]+*,$% \t\rSINATANDROUNDEQMOD".to_vec();
    let byte = prop_oneof![20 => prop::sample::select(common), 1 => any::<u8>()];
    prop::collection::vec(byte, 0..200)
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 300, failure_persistence: None, max_shrink_iters: 0, ..ProptestConfig::default() })]

    #[test]
    fn structured_programs_agree(bytes in prop::collection::vec(any::<u8>(), 0..3000)) {
        let mut bytes = arbitrary::Unstructured::new(&bytes);
        if let Ok(case) = <Case as arbitrary::Arbitrary>::arbitrary(&mut bytes) {
            agree(&case)?;
        }
    }

    #[test]
    fn raw_bytes_agree(setup in prop::collection::vec(any::<u8>(), Case::SETUP_BYTES), program in program_bytes()) {
        let mut bytes = setup;
        bytes.extend(program);
        agree(&Case::from_raw(&bytes))?;
    }

    #[test]
    fn raw_programs_agree_on_the_default_setup(program in program_bytes()) {
        agree(&Case { setup: Setup::default(), program })?;
    }
}

/// Compares a case; a failure is shrunk by the generator's own means, which know lines and words.
fn agree(case: &Case) -> Result<(), TestCaseError> {
    campaign::verdict(case).map(drop).map_err(|message| {
        let failure = campaign::Failure { seed: 0, case: case.clone(), message };
        TestCaseError::fail(report(&campaign::smallest(failure)))
    })
}
