//! `plot`: the path of the tool as a drawing.

use std::fs;
use std::io::{Write, stderr, stdout};
use std::path::PathBuf;

use turnspec::plot::{Extent, Plan, Told, page, svg};
use turnspec_oracle::Run;
use turnspec_oracle::vocabulary::{Action, Event};

use super::book::{Book, heading};
use super::excerpt::block_text;
use super::input::Program;
use super::machine::Machine;
use super::options::SetupOptions;
use super::report::Reporter;
use super::sources::Sources;
use super::words::describe;
use super::{ColorChoice, Failure, Verdict, exit_status, setup_help};

/// Draw the path of the tool: Z to the right, X up as a diameter, one scale for both.
///
/// The drawing is an SVG file; with --html it is a page that needs nothing else, in which each motion shows its block,
/// its event and its rules. In nose radius compensation it is the path of the tip, with the programmed contour beside
/// it; of LAP the programmed contour and the blank are drawn. The passes of a cycle take six colours in turn. At an alarm the path up to there is drawn, and no more than 100000 motions are. The reference implementation runs.
#[derive(clap::Args)]
#[command(after_help = concat!(
    "Examples:\n  turnspec plot shaft.min -o shaft.svg\n  turnspec plot shaft.min --html -o shaft.html\n  \
     turnspec plot shaft.min --extent cutting > shaft.svg\n\n",
    setup_help!(), "\n\n", exit_status!()
))]
pub struct Arguments {
    /// The program; `-` is standard input.
    program: PathBuf,
    /// The file to write; standard output without it.
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
    /// A page instead of a drawing alone.
    #[arg(long)]
    html: bool,
    /// Which motions have to be on the sheet.
    #[arg(long, value_enum, default_value_t = Fit::All, value_name = "MOTIONS")]
    extent: Fit,
    #[command(flatten)]
    setup: SetupOptions,
}

#[derive(Clone, Copy, clap::ValueEnum)]
enum Fit {
    /// All motions, and the barriers.
    All,
    /// Those that cut, if there are any.
    Cutting,
}

/// Draws the run.
pub fn carry_out(arguments: &Arguments, color: ColorChoice) -> Result<Verdict, Failure> {
    let program = Program::read(Some(&arguments.program))?;
    let setup = arguments.setup.setup(&program)?;
    let sources = Sources::new(&program, &setup);
    let book = Book::open()?;
    let (mut plan, mut told, mut alarm) = (Plan::new(&setup), Vec::new(), None);
    let mut run = Run::new(&program.text, &setup);
    let mut outlined = 0;
    loop {
        let ended = Machine::step(&mut run, &mut |event: &Event| {
            let drawn = plan.segments.len();
            plan.event(event);
            if arguments.html && plan.segments.len() > drawn {
                told.push(tell(event, &sources, &book));
            }
            if let Action::Alarm(each) = event.action {
                alarm = Some((each, *event));
            }
            sources.follow(event);
        });
        if let Some(outline) = run.outline().filter(|outline| outline.number > outlined) {
            outlined = outline.number;
            plan.definition(outline);
        }
        if ended.is_some() || plan.cut {
            break;
        }
    }
    let extent = match arguments.extent {
        Fit::All => Extent::All,
        Fit::Cutting => Extent::Cutting,
    };
    let name =
        arguments.program.file_name().map_or_else(|| program.name.clone(), |name| name.display().to_string());
    let text = if arguments.html {
        page(&name, &plan, extent, &told).map_err(|error| Failure::about(&program.name, error))?
    } else {
        svg(&name, &plan, extent)
    };
    match &arguments.output {
        Some(file) => fs::write(file, text).map_err(|error| Failure::about(file.display(), error))?,
        None => stdout().lock().write_all(text.as_bytes())?,
    }
    if plan.cut {
        let _ = writeln!(
            stderr(),
            "turnspec: {}: more than {} motions; the run was stopped there, the rest is not drawn",
            program.name,
            Plan::MOST
        );
    }
    if let Some((alarm, event)) = &alarm {
        let reporter = Reporter::new(&sources, &book, color.on_stderr());
        reporter.report(alarm, &event.rules, &event.block, event.block.start..event.block.end);
    }
    Ok(Verdict::fault_if(alarm.is_some()))
}

fn tell(event: &Event, sources: &Sources, book: &Book) -> Told {
    let title = |id| book.rule(id).map_or_else(|| format!("{id}"), heading);
    Told {
        n: event.n,
        line: event.block.line,
        block: block_text(sources.of(&event.block).text, sources.code(), &event.block),
        event: describe(event),
        rules: event.rules.as_slice().iter().map(|id| title(*id)).collect(),
    }
}
