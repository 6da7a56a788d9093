//! The comparison of oracle and engine finds bugs: every known-wrong variant of the engine is found within a
//! stated number of generated programs, and without one the same programs agree.
//!
//! The table is printed (`--nocapture`) and kept in `evidence/planted.json`; with `TURNSPEC_WRITE_EVIDENCE=1` the
//! test writes that file.

#![allow(clippy::panic, clippy::unwrap_used)]

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;
use std::sync::atomic::{AtomicU64, Ordering};

use serde_json::{Value as Json, json};
use turnspec::audit::Tree;
use turnspec::audit::evidence::State;
use turnspec::audit::planted::DEPENDS_ON;
use turnspec::differential::compare;
use turnspec::engine::{self, planted, planted::Bug};
use turnspec_generator::{Case, case_from_seed};
use turnspec_oracle::vocabulary::{Action, Event, Value};

/// No bug may need more programs than that.
const MOST: u64 = 60_000;
const THREADS: u64 = 2;
/// A bug that was not found yet.
const NEVER: u64 = u64::MAX;

#[test]
fn every_planted_bug_is_found_in_time() {
    let found = search();
    print(&found);
    let late = |(bug, needed): &&(Bug, u64)| *needed > bug.entry().bound;
    let late: Vec<_> = found.iter().filter(late).map(|(bug, needed)| (bug.entry().name, *needed)).collect();
    assert!(late.is_empty(), "not found within their bounds: {late:?}");
    check_evidence(&found);
}

#[test]
fn every_bug_is_described_once() {
    for bug in Bug::ALL {
        let entry = bug.entry();
        assert!((1..=MOST).contains(&entry.bound), "{entry:?}");
        assert!(!entry.rules.is_empty() && entry.description.ends_with('.'), "{entry:?}");
        let twins = Bug::ALL.iter().filter(|other| other.entry().description == entry.description);
        assert_eq!(twins.count(), 1, "{entry:?}");
    }
}

/// For every bug the number of programs that it takes, seeds from 0 on.
fn search() -> Vec<(Bug, u64)> {
    let found: Vec<AtomicU64> = Bug::ALL.iter().map(|_| AtomicU64::new(NEVER)).collect();
    std::thread::scope(|scope| {
        let found = &found;
        let workers: Vec<_> =
            (0..THREADS).map(|thread| scope.spawn(move || search_part(thread, found))).collect();
        for worker in workers {
            if let Err(panic) = worker.join() {
                std::panic::resume_unwind(panic);
            }
        }
    });
    let needed = found.iter().map(|seed| seed.load(Ordering::Relaxed).saturating_add(1));
    Bug::ALL.iter().copied().zip(needed).collect()
}

/// Every so many seeds against the bugs that no earlier seed finds.
fn search_part(first: u64, found: &[AtomicU64]) {
    for seed in (first..MOST).step_by(THREADS as usize) {
        let open = |(_, earliest): &(&Bug, &AtomicU64)| earliest.load(Ordering::Relaxed) > seed;
        let open: Vec<_> = Bug::ALL.iter().zip(found).filter(open).collect();
        if open.is_empty() {
            return;
        }
        let case = case_from_seed(seed);
        planted::plant(None);
        if let Err(disagreement) = compare(&case.program, &case.setup) {
            panic!("seed {seed} disagrees without a planted bug\n{disagreement}");
        }
        let sound = trace(&case);
        for (bug, earliest) in open {
            planted::plant(Some(*bug));
            // What differs from the sound engine has to be what the comparison with the oracle finds.
            if !same(&trace(&case), &sound) && is_found(&case) {
                earliest.fetch_min(seed, Ordering::Relaxed);
            }
        }
    }
}

/// Whether the comparison finds the planted bug in a case.
fn is_found(case: &Case) -> bool {
    let verdict = catch_unwind(AssertUnwindSafe(|| compare(&case.program, &case.setup)));
    !matches!(verdict, Ok(Ok(_)))
}

/// The events of the engine, none after a panic.
fn trace(case: &Case) -> Vec<Event> {
    let mut events = Vec::new();
    let run = || engine::run(&case.program, &case.setup, &mut |event: &Event| events.push(*event));
    if catch_unwind(AssertUnwindSafe(run)).is_err() {
        events.clear();
    }
    events
}

/// Whether two traces are the same, signs of zero included.
fn same(a: &[Event], b: &[Event]) -> bool {
    let bits = |event: &Event| match event.action {
        Action::Variable { value: Value::Real(real), .. } => real.to_bits(),
        _ => 0,
    };
    a.len() == b.len() && a.iter().zip(b).all(|(a, b)| a == b && bits(a) == bits(b))
}

fn print(found: &[(Bug, u64)]) {
    println!("{:<24} {:<12} {:>8} {:>8}  rules: what it does", "bug", "family", "programs", "bound");
    for (bug, needed) in found {
        let entry = bug.entry();
        let rules: Vec<_> = entry.rules.iter().map(|rule| rule.as_str()).collect();
        let (name, family, bound) = (entry.name, entry.family, entry.bound);
        let needed = if *needed == NEVER { "never".to_owned() } else { needed.to_string() };
        println!(
            "{name:<24} {family:<12} {needed:>8} {bound:>8}  {}: {}",
            rules.join(" "),
            entry.description
        );
    }
}

/// The rows of the table as they are kept: the same for the same engine and generator.
fn rows(found: &[(Bug, u64)]) -> Json {
    let row = |(bug, needed): &(Bug, u64)| {
        let entry = bug.entry();
        let rules: Vec<_> = entry.rules.iter().map(|rule| rule.as_str()).collect();
        json!({
            "bug": entry.name,
            "family": entry.family,
            "description": entry.description,
            "rules": rules,
            "programs": needed,
            "bound": entry.bound,
        })
    };
    found.iter().map(row).collect()
}

/// Compares the rows with those that are kept, whatever state of the sources the file names: the audit tells
/// whether that is the present one.
fn check_evidence(found: &[(Bug, u64)]) {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let path = root.join("evidence/planted.json");
    let rows = rows(found);
    if std::env::var_os("TURNSPEC_WRITE_EVIDENCE").is_some() {
        let tree = Tree::open(root, Path::new("audit")).unwrap();
        let state = State::of(&tree, &DEPENDS_ON).unwrap();
        let table = json!({ "state": state, "seeds_from": 0, "most_programs": MOST, "bugs": rows });
        std::fs::write(&path, serde_json::to_string_pretty(&table).unwrap() + "\n").unwrap();
    }
    let kept = std::fs::read_to_string(&path).unwrap_or_default();
    let kept: Json = serde_json::from_str(&kept).unwrap_or_default();
    assert!(kept["bugs"] == rows, "{} is not current; TURNSPEC_WRITE_EVIDENCE=1 writes it", path.display());
}
