//! `answer`: what an implementation under test has to do, done by an implementation of ours.

use std::io::{BufWriter, Read, Write, stdin, stdout};

use turnspec::engine::Interpreter;
use turnspec_conformance::{PROTOCOL, Task};
use turnspec_oracle::Run;
use turnspec_oracle::vocabulary::{Ending, Event};

use super::machine::Machine;
use super::trace::{Format, TraceWriter};
use super::{Failure, Verdict};

/// Read one conformance case as JSON from standard input, run it, write the trace as JSON Lines.
///
/// This is what `turnspec conform` demands of an implementation; conformance/PROTOCOL.md describes it.
#[derive(clap::Args)]
#[command(
    after_help = "Examples:\n  turnspec answer < case.json\n  turnspec conform --impl 'turnspec answer'\n\n\
    Exit status:\n  0  the program reached its end\n  1  the control raised an alarm, the last event\n  \
    2  what was read is no case"
)]
pub struct Arguments {
    /// Which implementation runs.
    #[arg(long, value_enum, default_value_t = Implementation::Engine)]
    with: Implementation,
}

#[derive(Clone, Copy, PartialEq, Eq, Debug, clap::ValueEnum)]
enum Implementation {
    Oracle,
    Engine,
}

/// Answers one case.
pub fn carry_out(arguments: &Arguments) -> Result<Verdict, Failure> {
    let mut text = Vec::new();
    let fault = |reason: &dyn std::fmt::Display| Failure::about("standard input", reason);
    stdin().lock().read_to_end(&mut text).map_err(|error| fault(&error))?;
    let task: Task = serde_json::from_slice(&text).map_err(|error| fault(&error))?;
    if task.protocol != PROTOCOL {
        return Err(fault(&format!("the rules for running are version {}, not {PROTOCOL}", task.protocol)));
    }
    if task.control != task.setup.control {
        return Err(fault(&"the set-up is for another control"));
    }
    task.setup.validate().map_err(|error| fault(&error))?;
    let program = task.program_bytes().ok_or_else(|| fault(&"`program` has a character above U+00FF"))?;
    let out = BufWriter::new(stdout().lock());
    let mut trace = TraceWriter::new(out, Format::Jsonl, false)?;
    let ending = match arguments.with {
        Implementation::Oracle => drive(Run::new(&program, &task.setup), &mut trace)?,
        Implementation::Engine => drive(Interpreter::new(&program, &task.setup), &mut trace)?,
    };
    trace.finish()?;
    Ok(Verdict::fault_if(ending == Ending::Alarm))
}

/// Runs to the end.
fn drive(mut machine: impl Machine, trace: &mut TraceWriter<impl Write>) -> Result<Ending, Failure> {
    loop {
        let mut written = Ok(());
        let ending = machine.step(&mut |event: &Event| {
            if written.is_ok() {
                written = trace.event(event);
            }
        });
        written?;
        if let Some(ending) = ending {
            return Ok(ending);
        }
    }
}
