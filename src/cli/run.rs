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
use super::report::Reporter;
use super::trace::{Format, TraceWriter};
use super::{ColorChoice, Failure, Verdict, exit_status, setup_help};

/// Run a program and print what the control does.
///
/// An alarm is the last event of the trace; it is also explained on standard error.
#[derive(clap::Args)]
#[command(after_help = concat!(
    "Examples:\n  turnspec run shaft.min\n  turnspec run --format jsonl shaft.min | head\n  \
     turnspec run --with both --setup lathe.toml shaft.min\n  \
     printf 'G00 X50 Z100\\nM02\\n' | turnspec run\n\n",
    setup_help!(), "\n\n", exit_status!()
))]
pub struct Arguments {
    /// The program; standard input if it is missing or `-`.
    program: Option<PathBuf>,
    /// The set-up file.
    #[arg(long, value_name = "FILE")]
    setup: Option<PathBuf>,
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
    let setup = program.setup(arguments.setup.as_deref())?;
    let out = BufWriter::with_capacity(1 << 16, stdout().lock());
    let mut trace = TraceWriter::new(out, arguments.format, color.on_stdout())?;
    let text = &program.text;
    let (last, mismatch) = match arguments.with {
        Implementation::Oracle => (drive(Run::new(text, &setup), &mut trace)?, None),
        Implementation::Engine => (drive(Interpreter::new(text, &setup), &mut trace)?, None),
        Implementation::Both => drive_both(&program, &setup, &mut trace)?,
    };
    trace.finish()?;
    if let Some(mismatch) = &mismatch {
        report_mismatch(mismatch, &program, &setup);
    }
    let alarm = last.filter(|event| report_alarm(event, &program, &setup, color.on_stderr()));
    Ok(Verdict::fault_if(alarm.is_some() || mismatch.is_some()))
}

/// Runs to the end; the last event.
fn drive(mut machine: impl Machine, trace: &mut TraceWriter<impl Write>) -> Result<Option<Event>, Failure> {
    let mut last = None;
    loop {
        let mut written = Ok(());
        let ending = machine.step(&mut |event| {
            if written.is_ok() {
                written = trace.event(event);
            }
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
) -> Result<(Option<Event>, Option<Mismatch>), Failure> {
    let mut last = None;
    let mismatch =
        compare(Run::new(&program.text, setup), Interpreter::new(&program.text, setup), |event: &Event| {
            last = Some(*event);
            trace.event(event)
        })?;
    Ok((last, mismatch))
}

/// Reports the event if it is an alarm; whether it is one.
fn report_alarm(event: &Event, program: &Program, setup: &Setup, color: bool) -> bool {
    let Action::Alarm(alarm) = &event.action else { return false };
    let book = Book::open().unwrap_or_default();
    let reporter = Reporter::new(program, setup.tape.code, &book, color);
    reporter.report(alarm, &event.rules, &event.block, event.block.start..event.block.end);
    true
}

fn report_mismatch(mismatch: &Mismatch, program: &Program, setup: &Setup) {
    let Mismatch { oracle, engine } = mismatch;
    let show = |event: &Option<Event>| {
        event.as_ref().map_or_else(|| "the run has ended".to_owned(), notation::render)
    };
    let mut text = format!("turnspec: {}: oracle and engine disagree\n", program.name);
    if let Some(event) = oracle.or(*engine) {
        let block = block_text(&program.text, setup.tape.code, &event.block);
        text.push_str(&format!("  event   {}, line {}\n  block   {block}\n", event.n, event.block.line));
    }
    text.push_str(&format!("  oracle  {}\n  engine  {}\n", show(oracle), show(engine)));
    let _ = stderr().write_all(text.as_bytes());
}
