//! `conform`: another implementation on the corpus.

use std::fs;
use std::io::{self, Write, stdout};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicUsize, Ordering};

use indicatif::{ProgressBar, ProgressStyle};
use turnspec_conformance::report::{CaseReport, Detail, Report, html, json, junit, summary};
use turnspec_conformance::{Exercise, Filter, Implementation, Runner, corpus};

use super::implementation::UnderTest;
use super::{ColorChoice, Failure, Verdict};

/// Run another implementation on the conformance cases and say where it departs from the rules.
///
/// The command is started once for every case. It reads the case as JSON from standard input and writes its
/// trace as JSON Lines to standard output; conformance/PROTOCOL.md has the details. `turnspec answer` is such
/// an implementation.
#[derive(clap::Args)]
#[command(after_help = "Examples:\n  turnspec conform --impl 'python3 mylathe.py'\n  \
    turnspec conform --impl ./mylathe --declare mylathe.toml --filter 'E100L-G50-*' --verbose\n  \
    turnspec conform --impl ./mylathe --junit conform.xml --html conform.html\n  \
    turnspec conform --impl 'turnspec answer'\n\n\
    Exit status:\n  0  every case that was run passed, or its failure is waived\n  \
    1  a case failed, or a waiver is out of date\n  \
    2  wrong usage, a command that does not start, a broken corpus or declaration, a report that\n     \
    cannot be written, interrupted")]
pub struct Arguments {
    #[command(flatten)]
    under_test: UnderTest,
    /// A file or folder of cases instead of those that this program carries.
    #[arg(long, value_name = "PATH")]
    corpus: Option<PathBuf>,
    /// Only cases with this in their id, or whose id, rule, feature or flag matches (`*` and `?`); repeatable.
    #[arg(long, value_name = "PATTERN")]
    filter: Vec<String>,
    /// The most bytes that a case may write to standard output, and to standard error.
    #[arg(long, value_name = "BYTES", default_value_t = Implementation::OUTPUT_LIMIT)]
    output_limit: usize,
    /// Write the report as JUnit XML.
    #[arg(long, value_name = "FILE")]
    junit: Option<PathBuf>,
    /// Write the report as JSON.
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
    /// Write the report as a page.
    #[arg(long, value_name = "FILE")]
    html: Option<PathBuf>,
    /// Print every case, every failure and every rule.
    #[arg(long)]
    verbose: bool,
}

/// Runs the implementation.
pub fn carry_out(arguments: &Arguments, color: ColorChoice) -> Result<Verdict, Failure> {
    let (declaration, _) = arguments.under_test.declaration()?;
    let exercises = match &arguments.corpus {
        Some(path) => corpus::read(path),
        None => corpus::embedded(),
    };
    let exercises = exercises.map_err(|error| Failure::Usage(error.to_string()))?;
    let filters: Vec<Filter> = arguments.filter.iter().map(|text| Filter::new(text)).collect();
    let selected = |each: &Exercise| filters.iter().any(|filter| filter.selects(&each.case));
    if !filters.is_empty() && !exercises.iter().any(selected) {
        return Err(Failure::Usage("--filter selects no case".to_owned()));
    }
    let implementation = arguments.under_test.implementation()?.with_output_limit(arguments.output_limit);
    let runner = Runner {
        command: &arguments.under_test.command,
        implementation: &implementation,
        declaration: &declaration,
        filters: &filters,
        jobs: arguments.under_test.jobs(),
    };
    let report = with_progress(&exercises, &runner)?;
    let detail = if arguments.verbose { Detail::Full } else { Detail::Brief };
    let printed = stdout().write_all(summary(&report, detail, color.on_stdout()).as_bytes());
    write_reports(arguments, &report)?;
    printed?;
    Ok(Verdict::fault_if(!report.success))
}

/// Runs, with a progress bar on a terminal.
fn with_progress(exercises: &[Exercise], runner: &Runner) -> Result<Report, Failure> {
    let bar = ProgressBar::new(exercises.len() as u64);
    if let Ok(style) = ProgressStyle::with_template("{bar:40} {pos}/{len} cases, {msg} failed") {
        bar.set_style(style);
    }
    bar.set_message("0");
    let failures = AtomicUsize::new(0);
    let finished = |case: &CaseReport| {
        if case.verdict.is_failure() {
            let failed = failures.fetch_add(1, Ordering::Relaxed) + 1;
            bar.set_message(failed.to_string());
        }
        bar.inc(1);
    };
    let result = runner.run(exercises, &finished);
    bar.finish_and_clear();
    result.map_err(|error| Failure::Usage(error.to_string()))
}

/// Writes every report that can be written; the first fault of the others.
fn write_reports(arguments: &Arguments, report: &Report) -> Result<(), Failure> {
    let written = [
        arguments.junit.as_ref().map(|path| write(path, junit(report))),
        arguments.json.as_ref().map(|path| write(path, json(report).map_err(io::Error::from))),
        arguments.html.as_ref().map(|path| write(path, Ok(html(report)))),
    ];
    written.into_iter().flatten().collect()
}

fn write(path: &Path, text: io::Result<String>) -> Result<(), Failure> {
    text.and_then(|text| fs::write(path, text)).map_err(|error| Failure::about(path.display(), error))
}
