//! `fuzz`: a campaign of generated programs against another implementation.

use std::io::{BufWriter, Write, stdout};
use std::num::NonZeroUsize;
use std::path::{Path, PathBuf};

use indicatif::{ProgressBar, ProgressStyle};
use turnspec::campaign::{self, Campaign, Finding, Group, Plan};
use turnspec_conformance::RunError;

use super::book::Book;
use super::implementation::UnderTest;
use super::{Failure, Verdict, exit_status};

/// Rules of a finding that are shown, the most likely ones to be broken.
const RULES_SHOWN: usize = 4;

/// Run generated programs with another implementation until it disagrees with the reference.
///
/// The implementation reads a case and writes a trace as conformance/PROTOCOL.md describes. Programs stay within
/// the features that it declares. Each kind of disagreement is shown once, with the smallest program that was
/// found for it. With --out the findings are saved as conformance cases, and the campaign can be interrupted: the
/// same command carries on with it, after the last program whose result was finished. A disagreement that is being
/// made smaller at the interruption is met again then.
#[derive(clap::Args)]
#[command(after_help = concat!(
    "Examples:\n  turnspec fuzz --impl ./mylathe --declare mylathe.toml --runs 1000\n  \
     turnspec fuzz --impl 'python3 conformance/toys/wrong.py' --declare conformance/toys/wrong.toml\n  \
     turnspec fuzz --impl ./mylathe --seed 7 --runs 1000000 --jobs 8 --out campaign\n\n",
    exit_status!()
))]
pub struct Arguments {
    #[command(flatten)]
    under_test: UnderTest,
    /// Where the programs come from: the same seed, the same programs.
    #[arg(long, value_name = "S", default_value_t = 1)]
    seed: u64,
    /// How many programs, those of earlier parts of the campaign included.
    #[arg(long, value_name = "N", default_value_t = 1000)]
    runs: u64,
    /// Where the campaign and its findings are kept.
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
    /// Stop at this number of findings, at once: of further disagreements no smallest program is sought.
    #[arg(long, value_name = "N")]
    max_findings: Option<NonZeroUsize>,
}

/// Carries out the campaign.
pub fn carry_out(arguments: &Arguments) -> Result<Verdict, Failure> {
    let implementation = arguments.under_test.implementation()?;
    let (declaration, text) = arguments.under_test.declaration()?;
    let directory = arguments.out.as_deref();
    let mut campaign = Campaign::new(&arguments.under_test.command, &text, arguments.seed);
    if let Some(directory) = directory {
        campaign = campaign.resumed(directory).map_err(|error| Failure::Usage(error.to_string()))?;
    }
    let plan = Plan {
        implementation: &implementation,
        declaration: &declaration,
        seed: arguments.seed,
        runs: arguments.runs,
        jobs: arguments.under_test.jobs(),
        max_findings: arguments.max_findings.map_or(0, usize::from),
    };
    let bar = bar(arguments.runs, campaign.done);
    let progress = |campaign: &Campaign| {
        bar.set_position(campaign.done);
        bar.set_message(format!("{} findings", campaign.findings.len()));
    };
    let outcome = campaign::carry_on(&mut campaign, &plan, directory, progress);
    bar.finish_and_clear();
    outcome.map_err(|failure| failure_of(&failure, campaign.done, directory))?;
    write(&campaign, directory)?;
    Ok(Verdict::fault_if(!campaign.findings.is_empty()))
}

/// Why the campaign did not go on, and what becomes of it.
fn failure_of(failure: &campaign::Failure, done: u64, directory: Option<&Path>) -> Failure {
    match (failure, directory) {
        (campaign::Failure::Run(RunError::Interrupted), Some(directory)) if done > 0 => {
            Failure::Usage(format!(
                "interrupted; {done} programs are kept in {}, from where the same command carries on",
                directory.display()
            ))
        }
        (campaign::Failure::Run(RunError::Interrupted), Some(_)) => {
            Failure::Usage("interrupted before the first program was finished; nothing is kept".to_owned())
        }
        (campaign::Failure::Run(RunError::Interrupted), None) => {
            Failure::Usage(format!("interrupted after {done} programs; without --out nothing is kept"))
        }
        (campaign::Failure::Run(error), _) => Failure::about("--impl", error),
        (campaign::Failure::State(error), _) => Failure::Usage(error.to_string()),
    }
}

/// A bar on standard error, on a terminal only.
fn bar(runs: u64, done: u64) -> ProgressBar {
    let bar = ProgressBar::new(runs).with_position(done);
    if let Ok(style) = ProgressStyle::with_template("{bar:30} {pos} of {len} programs, {eta} left, {msg}") {
        bar.set_style(style);
    }
    bar.reset_eta();
    bar
}

fn write(campaign: &Campaign, directory: Option<&Path>) -> Result<(), Failure> {
    let book = Book::open()?;
    let mut out = BufWriter::new(stdout().lock());
    let waived: u64 = campaign.waived.values().sum();
    writeln!(
        out,
        "{} programs: {} agree, {} disagree, {waived} diverge as waivers permit, {} are not supported",
        campaign.done,
        campaign.agreed,
        campaign.disagreed(),
        campaign.unsupported
    )?;
    for (reason, count) in &campaign.waived {
        writeln!(out, "{count:>8}  waived: {reason}")?;
    }
    for group in campaign.groups() {
        write_group(&mut out, campaign, &group, &book, directory)?;
    }
    out.flush()?;
    Ok(())
}

/// Findings that point to one rule.
fn write_group(
    out: &mut impl Write,
    campaign: &Campaign,
    group: &Group<'_>,
    book: &Book,
    directory: Option<&Path>,
) -> Result<(), Failure> {
    let heading = group.rule.map_or("no trace to compare".to_owned(), |rule| book.heading(rule));
    writeln!(out, "\n{heading}: {} disagreements", group.count())?;
    for finding in &group.findings {
        write_finding(out, campaign, finding, book, directory)?;
    }
    Ok(())
}

fn write_finding(
    out: &mut impl Write,
    campaign: &Campaign,
    finding: &Finding,
    book: &Book,
    directory: Option<&Path>,
) -> Result<(), Failure> {
    writeln!(out, "\n  {} ({} times, first in run {})", finding.signature, finding.count(), finding.run)?;
    for line in finding.program().lines() {
        writeln!(out, "    | {}", line.escape_debug())?;
    }
    writeln!(out, "    expected: {}", finding.expected)?;
    writeln!(out, "    got:      {}", finding.actual)?;
    for difference in &finding.differences {
        writeln!(out, "      {difference}")?;
    }
    for rule in campaign.suspects(finding).into_iter().take(RULES_SHOWN) {
        writeln!(out, "    {}", book.heading(rule))?;
    }
    if let Some(directory) = directory {
        writeln!(out, "    {}", directory.join(finding.file_name()).display())?;
    }
    Ok(())
}
