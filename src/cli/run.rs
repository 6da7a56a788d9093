//! `run`: the trace of a program.

use std::io::{BufWriter, Write, stderr, stdout};
use std::path::PathBuf;

use turnspec::engine::Interpreter;
use turnspec_oracle::Run;
use turnspec_oracle::vocabulary::{Action, Event, Setup, notation};

use super::book::Book;
use super::excerpt::block_text;
use super::input::Program;
use super::lockstep::{Mismatch, compare};
use super::machine::Machine;
use super::options::SetupOptions;
use super::report::Reporter;
use super::sources::Sources;
use super::trace::{Format, TraceWriter};
use super::{ColorChoice, Failure, Verdict, exit_status, setup_help};

/// Run a program and print what the control does.
///
/// An alarm is the last event of the trace; it is also explained on standard error.
#[derive(clap::Args)]
#[command(after_help = concat!(
    "Examples:\n  turnspec run shaft.min\n  turnspec run --format jsonl shaft.min | head\n  \
     turnspec run --with both --setup lathe.toml shaft.min\n  \
     turnspec run --library subprograms --set V1=10 shaft.min\n  \
     printf 'G00 X50 Z100\\nM02\\n' | turnspec run\n\n",
    setup_help!(), "\n\n", exit_status!()
))]
pub struct Arguments {
    /// The program; standard input if it is missing or `-`.
    program: Option<PathBuf>,
    #[command(flatten)]
    setup: SetupOptions,
    /// Which implementation runs: the reference, the fast one, or both, compared event by event.
    #[arg(long, value_enum, default_value_t = Implementation::Engine)]
    with: Implementation,
    /// How the trace is printed.
    #[arg(long, value_enum, default_value_t = Format::Table)]
    format: Format,
}

#[derive(Clone, Copy, PartialEq, Eq, Debug, clap::ValueEnum)]
enum Implementation {
    Oracle,
    Engine,
    Both,
}

/// Runs the program.
pub fn carry_out(arguments: &Arguments, color: ColorChoice) -> Result<Verdict, Failure> {
    let program = Program::read(arguments.program.as_deref())?;
    let setup = arguments.setup.setup(&program)?;
    let sources = Sources::new(&program, &setup);
    let out = BufWriter::with_capacity(1 << 16, stdout().lock());
    let mut trace = TraceWriter::new(out, arguments.format, color.on_stdout())?;
    let text = &program.text;
    let (last, mismatch) = match arguments.with {
        Implementation::Oracle => (drive(Run::new(text, &setup), &mut trace, &sources)?, None),
        Implementation::Engine => (drive(Interpreter::new(text, &setup), &mut trace, &sources)?, None),
        Implementation::Both => drive_both(&program, &setup, &mut trace, &sources)?,
    };
    trace.finish()?;
    if let Some(mismatch) = &mismatch {
        report_mismatch(mismatch, &program.name, &sources);
    }
    let alarm = last.filter(|event| report_alarm(event, &sources, color.on_stderr()));
    Ok(Verdict::fault_if(alarm.is_some() || mismatch.is_some()))
}

/// Runs to the end; the last event.
fn drive(
    mut machine: impl Machine,
    trace: &mut TraceWriter<impl Write>,
    sources: &Sources,
) -> Result<Option<Event>, Failure> {
    let mut last = None;
    loop {
        let mut written = Ok(());
        let ending = machine.step(&mut |event| {
            if written.is_ok() {
                written = trace.event(event);
            }
            sources.follow(event);
            last = Some(*event);
        });
        written?;
        if ending.is_some() {
            return Ok(last);
        }
    }
}

fn drive_both(
    program: &Program,
    setup: &Setup,
    trace: &mut TraceWriter<impl Write>,
    sources: &Sources,
) -> Result<(Option<Event>, Option<Mismatch>), Failure> {
    let mut last = None;
    let mismatch =
        compare(Run::new(&program.text, setup), Interpreter::new(&program.text, setup), |event: &Event| {
            sources.follow(event);
            last = Some(*event);
            trace.event(event)
        })?;
    Ok((last, mismatch))
}

/// Reports the event if it is an alarm; whether it is one.
fn report_alarm(event: &Event, sources: &Sources, color: bool) -> bool {
    let Action::Alarm(alarm) = &event.action else { return false };
    let book = Book::open().unwrap_or_default();
    let reporter = Reporter::new(sources, &book, color);
    reporter.report(alarm, &event.rules, &event.block, event.block.start..event.block.end);
    true
}

fn report_mismatch(mismatch: &Mismatch, name: &str, sources: &Sources) {
    let Mismatch { oracle, engine } = mismatch;
    let show = |event: &Option<Event>| {
        event.as_ref().map_or_else(|| "the run has ended".to_owned(), notation::render)
    };
    let mut text = format!("turnspec: {name}: oracle and engine disagree\n");
    if let Some(event) = oracle.or(*engine) {
        let block = block_text(sources.of(&event.block).text, sources.code(), &event.block);
        text.push_str(&format!("  event   {}, line {}\n  block   {block}\n", event.n, event.block.line));
    }
    text.push_str(&format!("  oracle  {}\n  engine  {}\n", show(oracle), show(engine)));
    let _ = stderr().write_all(text.as_bytes());
}
