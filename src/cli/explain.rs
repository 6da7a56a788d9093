//! `explain`: a run, event by event, with the rules that justify each.

use std::collections::BTreeSet;
use std::io::{self, BufWriter, Write, stderr, stdout};
use std::path::PathBuf;

use turnspec_oracle::Run;
use turnspec_oracle::vocabulary::{Action, Event, Place, RuleId};

use super::book::{Book, heading};
use super::excerpt::{block_text, last_line};
use super::input::Program;
use super::machine::Machine;
use super::options::SetupOptions;
use super::report::Reporter;
use super::situation::{Told, situation};
use super::sources::Sources;
use super::words::describe;
use super::wrap::wrap;
use super::{ColorChoice, Failure, Verdict, exit_status, setup_help};

/// Run a program and say why: each event with the text of its rules.
///
/// A rule is printed in full where it is met first, later with its title only. At an alarm the calls, variables and
/// modes in force are shown on standard error. The reference implementation runs.
#[derive(clap::Args)]
#[command(after_help = concat!(
    "Examples:\n  turnspec explain shaft.min\n  turnspec explain shaft.min --block N110\n  \
     turnspec explain shaft.min --block 12\n\n",
    setup_help!(), "\n\n", exit_status!()
))]
pub struct Arguments {
    /// The program; `-` is standard input.
    program: PathBuf,
    /// Only the block with this sequence name, such as N010, or on this line.
    #[arg(long, value_name = "N")]
    block: Option<Selection>,
    #[command(flatten)]
    setup: SetupOptions,
}

/// A block by its sequence name, with `N`, or by one of its lines.
#[derive(Clone, Debug)]
enum Selection {
    Sequence(String),
    Line(usize),
}

impl std::str::FromStr for Selection {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        if text.starts_with(['N', 'n']) {
            return Ok(Self::Sequence(text.to_ascii_uppercase()));
        }
        text.parse()
            .map(Self::Line)
            .map_err(|_| "neither a sequence name (N010) nor a line number".to_owned())
    }
}

impl Selection {
    fn selects(&self, block: &Place, sources: &Sources) -> bool {
        match self {
            Self::Sequence(name) => block.sequence.as_str() == name,
            Self::Line(line) => {
                let last = last_line(sources.of(block).text, sources.code(), block);
                (block.line as usize..=last).contains(line)
            }
        }
    }
}

/// Explains the run.
pub fn carry_out(arguments: &Arguments, color: ColorChoice) -> Result<Verdict, Failure> {
    let program = Program::read(Some(&arguments.program))?;
    let setup = arguments.setup.setup(&program)?;
    let sources = Sources::new(&program, &setup);
    let book = Book::open()?;
    let out = BufWriter::new(stdout().lock());
    let mut explanation =
        Explanation { out, sources: &sources, book: &book, told: BTreeSet::new(), block: None };
    let mut run = Run::new(&program.text, &setup);
    let mut alarm = None;
    let mut told = Told::default();
    let mut written = Ok(());
    let mut found = arguments.block.is_none();
    loop {
        let ending = Machine::step(&mut run, &mut |event| {
            let selected = arguments.block.as_ref();
            if written.is_ok() && selected.is_none_or(|each| each.selects(&event.block, &sources)) {
                found = true;
                written = explanation.event(event);
            }
            sources.follow(event);
            told.event(event);
            if let Action::Alarm(each) = event.action {
                alarm = Some((each, *event));
            }
        });
        std::mem::replace(&mut written, Ok(()))?;
        if ending.is_some() {
            break;
        }
    }
    explanation.out.flush()?;
    if let Some((alarm, event)) = &alarm {
        let reporter = Reporter::new(&sources, &book, color.on_stderr());
        reporter.report(alarm, &event.rules, &event.block, event.block.start..event.block.end);
        let _ = stderr().write_all(situation(&run, &told).as_bytes());
    }
    if !found {
        return Err(Failure::about(
            &program.name,
            "nothing happens in that block, or there is no such block",
        ));
    }
    Ok(Verdict::fault_if(alarm.is_some()))
}

struct Explanation<'a, W> {
    out: W,
    sources: &'a Sources<'a>,
    book: &'a Book,
    /// The rules that were printed in full.
    told: BTreeSet<RuleId>,
    /// The block of the last event.
    block: Option<Place>,
}

impl<W: Write> Explanation<'_, W> {
    fn event(&mut self, event: &Event) -> io::Result<()> {
        let same = self.block.is_some_and(|block| block == event.block);
        if !same {
            if self.block.is_some() {
                writeln!(self.out)?;
            }
            let text = block_text(self.sources.of(&event.block).text, self.sources.code(), &event.block);
            writeln!(self.out, "line {}: {text}", event.block.line)?;
            self.block = Some(event.block);
        }
        writeln!(self.out, "  {}. {}", event.n, describe(event))?;
        for rule in event.rules.as_slice() {
            self.rule(*rule)?;
        }
        for reading in event.readings.iter() {
            writeln!(self.out, "     reading {}", reading.as_str())?;
        }
        Ok(())
    }

    fn rule(&mut self, id: RuleId) -> io::Result<()> {
        let first = self.told.insert(id);
        let Some(rule) = self.book.rule(id) else { return writeln!(self.out, "     {id}") };
        writeln!(self.out, "     {}", heading(rule))?;
        if first {
            for line in wrap(&rule.statement) {
                writeln!(self.out, "{}", format!("         {line}").trim_end())?;
            }
        }
        Ok(())
    }
}
