//! Tries every mutant that `cargo mutants --list --json` names, in one build (README.md).

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::sync::Mutex;

use clap::Parser;
use serde_json::{Value, json};

mod build;
mod fault;
mod list;
mod rewrite;
mod subject;
mod trial;

use build::Workshop;
use fault::Fault;
use list::Mutant;
use subject::Package;
use trial::{Judged, Tests};

/// Tries the mutants of a package in one build.
#[derive(Parser)]
struct Cli {
    /// The package.
    #[arg(long)]
    package: Package,
    /// What `cargo mutants --package … --list --json` says of it.
    #[arg(long)]
    list: PathBuf,
    /// The folder to work in; it is kept, so that the next run compiles less.
    #[arg(long)]
    work: PathBuf,
    /// Where the outcomes go, as cargo-mutants writes them. The names of those that are left to it go to standard output.
    #[arg(long)]
    outcomes: PathBuf,
    /// Only mutants whose name contains this; several times: one of these.
    #[arg(long)]
    only: Vec<String>,
    /// The version of cargo-mutants that wrote the list; it goes into the outcomes.
    #[arg(long)]
    version: String,
    /// How many tests run at once.
    #[arg(long, default_value_t = 2)]
    jobs: usize,
}

fn main() -> ExitCode {
    match attempt(&Cli::parse()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(fault) => {
            eprintln!("mutation: {fault}");
            ExitCode::from(2)
        }
    }
}

fn attempt(cli: &Cli) -> Result<(), Fault> {
    let mutants = list::read(&cli.list)?;
    let named = |name: &str| cli.only.iter().any(|only| name.contains(only));
    let wanted = |number: &usize| cli.only.is_empty() || named(&mutants[*number].name);
    if !(0..mutants.len()).any(|number| wanted(&number)) {
        return write(cli, &Report::default());
    }
    let tree = Path::new(".");
    let shop = Workshop::new(cli.package.subject(), tree, &cli.work, &mutants)?;
    let built = shop.fill(tree, &mutants)?;
    eprintln!(
        "{} mutants, {} in the build, {} do not compile",
        mutants.len(),
        built.placed.len(),
        built.unviable.len()
    );
    let tests = Tests::build(&shop)?;
    eprintln!("{} tests", tests.count());
    let numbers: Vec<usize> = built.placed.iter().copied().filter(wanted).collect();
    let report = Mutex::new(Report::default());
    let note = |number: usize, summary: &'static str, test: &str| {
        if let Ok(mut report) = report.lock() {
            report.add(&mutants[number], summary, test);
        }
    };
    tests.attempt(&numbers, cli.jobs, &|number, judged| match judged {
        Judged::Caught(test) => note(number, "CaughtMutant", test),
        Judged::Timeout(test) => note(number, "Timeout", test),
        Judged::Missed => note(number, "MissedMutant", "reached"),
        Judged::NotReached => note(number, "MissedMutant", "not reached"),
    });
    built.unviable.iter().filter(|number| wanted(number)).for_each(|number| note(*number, "Unviable", ""));
    let all = (0..mutants.len()).filter(wanted);
    let left: Vec<usize> =
        all.filter(|number| !built.placed.contains(number) && !built.unviable.contains(number)).collect();
    left.iter().for_each(|number| println!("{}", mutants[*number].name));
    let report = report.into_inner().unwrap_or_default();
    eprintln!("{:?}, {} left", report.counts, left.len());
    write(cli, &report)
}

fn write(cli: &Cli, report: &Report) -> Result<(), Fault> {
    let text = json!({ "outcomes": report.outcomes, "cargo_mutants_version": cli.version }).to_string();
    fs::write(&cli.outcomes, text).map_err(|error| Fault::about(cli.outcomes.display(), error))
}

/// The outcomes, as cargo-mutants writes them.
#[derive(Default)]
struct Report {
    outcomes: Vec<Value>,
    counts: BTreeMap<&'static str, usize>,
}

impl Report {
    fn add(&mut self, mutant: &Mutant, summary: &'static str, test: &str) {
        if matches!(summary, "MissedMutant" | "Timeout") {
            eprintln!("{summary} ({test}): {}", mutant.name);
        }
        *self.counts.entry(summary).or_default() += 1;
        self.outcomes.push(json!({
            "scenario": {"Mutant": {"name": mutant.name, "function": mutant.function}},
            "summary": summary,
            "test": test,
        }));
    }
}
