//! `check`: every fault of some programs.

use std::io::{Write, stderr, stdout};
use std::path::PathBuf;

use serde::Serialize;
use turnspec_oracle::vocabulary::{AlarmName, Label, Place, RuleSet, Setup};
use turnspec_oracle::{Diagnostic, check};

use super::book::Book;
use super::format::Format;
use super::input::Program;
use super::options::SetupOptions;
use super::report::Reporter;
use super::sources::Sources;
use super::{ColorChoice, Failure, Verdict, exit_status, setup_help};

/// Find the faults of programs: those of each block's grammar, and the alarm of the run.
///
/// A run is followed for 1,000,000 blocks at most. The text goes to standard error; JSON, an array of faults, goes to standard output.
#[derive(clap::Args)]
#[command(after_help = concat!(
    "Examples:\n  turnspec check shaft.min\n  turnspec check --setup lathe.toml *.min\n  \
     turnspec check --format json shaft.min | jq '.[].alarm.name'\n\n",
    setup_help!(), "\n\n", exit_status!()
))]
pub struct Arguments {
    /// The programs; `-` is standard input.
    #[arg(required = true, value_name = "PROGRAM")]
    programs: Vec<PathBuf>,
    #[command(flatten)]
    setup: SetupOptions,
    /// How the faults are printed.
    #[arg(long, value_enum, default_value_t = Format::Text)]
    format: Format,
}

/// How many blocks of a run are looked at.
const STEPS: u64 = 1_000_000;

/// A fault in JSON.
#[derive(Serialize)]
struct Fault {
    file: String,
    block: Place,
    span: Span,
    alarm: Alarm,
    rules: RuleSet,
}

#[derive(Serialize)]
struct Span {
    start: u32,
    end: u32,
}

#[derive(Serialize)]
struct Alarm {
    name: &'static str,
    #[serde(skip_serializing_if = "Option::is_none")]
    number: Option<u16>,
    text: &'static str,
    #[serde(skip_serializing_if = "Label::is_empty")]
    detail: Label,
}

impl Fault {
    fn new(file: &str, diagnostic: &Diagnostic) -> Self {
        let Diagnostic { alarm, rules, block, span } = diagnostic;
        let alarm = Alarm {
            name: alarm.name.as_str(),
            number: alarm.number,
            text: alarm.name.text(),
            detail: alarm.detail,
        };
        let span = Span { start: span.start, end: span.end };
        Self { file: file.to_owned(), block: *block, span, alarm, rules: *rules }
    }
}

/// Checks the programs, one after the other.
pub fn carry_out(arguments: &Arguments, color: ColorChoice) -> Result<Verdict, Failure> {
    let book = Book::open()?;
    let mut faults = Vec::new();
    let mut count = 0;
    for path in &arguments.programs {
        let program = Program::read(Some(path))?;
        let setup = arguments.setup.setup(&program)?;
        let diagnostics = faults_of(&program, &setup);
        count += diagnostics.len();
        match arguments.format {
            Format::Text => {
                let sources = Sources::new(&program, &setup);
                let reporter = Reporter::new(&sources, &book, color.on_stderr());
                for Diagnostic { alarm, rules, block, span } in &diagnostics {
                    reporter.report(alarm, rules, block, span.clone());
                }
            }
            Format::Json => faults.extend(diagnostics.iter().map(|each| Fault::new(&program.name, each))),
        }
    }
    match arguments.format {
        Format::Json => writeln!(stdout(), "{}", serde_json::to_string_pretty(&faults)?)?,
        Format::Text if count > 0 => {
            let _ = writeln!(stderr(), "{}", summary(count, arguments.programs.len()));
        }
        Format::Text => {}
    }
    Ok(Verdict::fault_if(count > 0))
}

/// The faults of a program. Its run is followed for [`STEPS`] blocks at most; that it goes on is no fault.
fn faults_of(program: &Program, setup: &Setup) -> Vec<Diagnostic> {
    let mut followed = setup.clone();
    followed.limits.steps = setup.limits.steps.min(STEPS);
    let mut faults = check(&program.text, &followed);
    if followed.limits.steps < setup.limits.steps {
        faults.retain(|fault| fault.alarm.name != AlarmName::StepLimit);
    }
    faults
}

fn summary(faults: usize, programs: usize) -> String {
    let plural = |count: usize| if count == 1 { "" } else { "s" };
    format!("{faults} fault{} in {programs} program{}", plural(faults), plural(programs))
}
