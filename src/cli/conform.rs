//! `conform`: another implementation on the corpus.

use std::fs;
use std::io::{Write, stdout};
use std::num::NonZeroUsize;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::thread;
use std::time::Duration;

use indicatif::{ProgressBar, ProgressStyle};
use signal_hook::consts::{SIGINT, SIGTERM};
use turnspec_conformance::report::{CaseReport, Detail, Report, html, json, junit, summary};
use turnspec_conformance::{Declaration, Exercise, Filter, Implementation, Runner, corpus};

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
    2  wrong usage, a command that does not start, a broken corpus or declaration, interrupted")]
pub struct Arguments {
    /// The command of the implementation, split as a shell does; no shell is started.
    #[arg(long = "impl", value_name = "COMMAND")]
    command: String,
    /// What the implementation declares; without it everything, exactly.
    #[arg(long, value_name = "FILE")]
    declare: Option<PathBuf>,
    /// A file or folder of cases instead of those that this program carries.
    #[arg(long, value_name = "PATH")]
    corpus: Option<PathBuf>,
    /// Only cases with this in their id, or whose id, rule, feature or flag matches (`*` and `?`); repeatable.
    #[arg(long, value_name = "PATTERN")]
    filter: Vec<String>,
    /// How many cases run at once; as many as there are processors if it is missing.
    #[arg(long, value_name = "N")]
    jobs: Option<NonZeroUsize>,
    /// The longest time of a case, in seconds.
    #[arg(long, value_name = "SECONDS", default_value = "10", value_parser = seconds)]
    timeout: Duration,
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

/// Reads a time; at least a millisecond, at most a day.
pub(super) fn seconds(text: &str) -> Result<Duration, String> {
    let time = text.parse().ok().and_then(|seconds| Duration::try_from_secs_f64(seconds).ok());
    let sensible = Duration::from_millis(1)..=Duration::from_secs(86_400);
    time.filter(|time| sensible.contains(time)).ok_or_else(|| "not a time from 0.001 to 86400 s".to_owned())
}

/// Runs the implementation.
pub fn carry_out(arguments: &Arguments, color: ColorChoice) -> Result<Verdict, Failure> {
    let declaration = declaration(arguments)?;
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
    let implementation = Implementation::new(&arguments.command)
        .map_err(|error| Failure::about("--impl", error))?
        .with_time_out(arguments.timeout)
        .with_output_limit(arguments.output_limit)
        .with_interrupt(interrupt()?);
    let runner = Runner {
        command: &arguments.command,
        implementation: &implementation,
        declaration: &declaration,
        filters: &filters,
        jobs: arguments.jobs.or_else(|| thread::available_parallelism().ok()).map_or(1, NonZeroUsize::get),
    };
    let report = with_progress(&exercises, &runner)?;
    let detail = if arguments.verbose { Detail::Full } else { Detail::Brief };
    let printed = stdout().write_all(summary(&report, detail, color.on_stdout()).as_bytes());
    write_reports(arguments, &report)?;
    printed?;
    Ok(Verdict::fault_if(!report.success))
}

/// The declaration file, or the declaration of everything under the name of the command.
fn declaration(arguments: &Arguments) -> Result<Declaration, Failure> {
    let Some(path) = &arguments.declare else { return Ok(Declaration::of_everything(&arguments.command)) };
    let text = fs::read_to_string(path).map_err(|error| Failure::about(path.display(), error))?;
    Declaration::from_toml(&text).map_err(|error| {
        let separator = if error.to_string().contains('\n') { "\n" } else { " " };
        Failure::Usage(format!("{}: broken declaration:{separator}{error}", path.display()))
    })
}

/// A flag that Ctrl-C and a request to end raise: every run ends and its processes are killed.
pub(super) fn interrupt() -> Result<Arc<AtomicBool>, Failure> {
    let flag = Arc::new(AtomicBool::new(false));
    for signal in [SIGINT, SIGTERM] {
        signal_hook::flag::register(signal, Arc::clone(&flag))
            .map_err(|error| Failure::about("Ctrl-C cannot be watched", error))?;
    }
    Ok(flag)
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

fn write_reports(arguments: &Arguments, report: &Report) -> Result<(), Failure> {
    if let Some(path) = &arguments.junit {
        write(path, junit(report).map_err(|error| Failure::about(path.display(), error))?)?;
    }
    if let Some(path) = &arguments.json {
        write(path, json(report)?)?;
    }
    if let Some(path) = &arguments.html {
        write(path, html(report))?;
    }
    Ok(())
}

fn write(path: &Path, text: String) -> Result<(), Failure> {
    fs::write(path, text).map_err(|error| Failure::about(path.display(), error))
}
