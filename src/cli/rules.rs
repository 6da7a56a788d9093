//! `rules`: the rules themselves, and which of them some programs exercise.

use std::collections::BTreeMap;
use std::io::{BufWriter, Write, stdout};
use std::path::PathBuf;

use serde::Serialize;
use turnspec_oracle::book::RuleText;
use turnspec_oracle::vocabulary::{AlarmName, Event, RuleId};

use super::book::{Book, heading};
use super::format::Format;
use super::input::Program;
use super::wrap::wrap;
use super::{Failure, Verdict, exit_status};

/// List the rules, show one, or tell which rules the traces of some programs cite.
#[derive(clap::Args)]
#[command(after_help = concat!(
    "Examples:\n  turnspec rules --area G50\n  turnspec rules --basis interpretation --format json\n  \
     turnspec rules E100L-G50-02\n  turnspec rules --level core --coverage *.min\n\n\
     An alarm in a program counts for the coverage like any other event; it does not change the exit \
     status.\nEach program runs on the set-up beside it (shaft.setup.toml for shaft.min) or on the \
     default.\n\n",
    exit_status!()
))]
pub struct Arguments {
    /// Show this rule; the name of the control may be left out (G50-02).
    #[arg(conflicts_with = "coverage")]
    id: Option<String>,
    /// Only the rules of this area, such as G50.
    #[arg(long)]
    area: Option<String>,
    /// Only the rules of this level.
    #[arg(long, value_parser = ["core", "option", "listed"])]
    level: Option<String>,
    /// Only the rules with this basis.
    #[arg(long, value_parser = ["manual", "interpretation", "unspecified"])]
    basis: Option<String>,
    /// Which rules the traces of these programs cite, and which not.
    #[arg(long, num_args = 1.., value_name = "PROGRAM")]
    coverage: Vec<PathBuf>,
    /// How the rules are printed.
    #[arg(long, value_enum, default_value_t = Format::Text)]
    format: Format,
}

/// A rule in JSON.
#[derive(Serialize)]
struct RuleRecord<'a> {
    id: RuleId,
    title: &'a str,
    file: &'a str,
    source: &'a str,
    basis: &'a str,
    level: &'a str,
    alarms: &'a [AlarmName],
    statement: &'a str,
    examples: Vec<ExampleRecord<'a>>,
}

#[derive(Serialize)]
struct ExampleRecord<'a> {
    introduction: &'a str,
    program: String,
    setup: &'a str,
    trace: &'a str,
    line: usize,
}

/// The coverage in JSON.
#[derive(Serialize)]
struct Coverage<'a> {
    programs: usize,
    rules: usize,
    cited: Vec<Citation<'a>>,
    not_cited: Vec<Citation<'a>>,
}

#[derive(Serialize)]
struct Citation<'a> {
    id: RuleId,
    title: &'a str,
    events: u64,
}

/// Prints what was asked for.
pub fn carry_out(arguments: &Arguments) -> Result<Verdict, Failure> {
    let book = Book::open()?;
    let mut out = BufWriter::new(stdout().lock());
    if let Some(id) = &arguments.id {
        show(find(&book, id)?, arguments.format, &mut out)?;
    } else {
        let rules: Vec<&RuleText> = book.rules().filter(|rule| arguments.selects(rule)).collect();
        if arguments.coverage.is_empty() {
            list(&rules, arguments.format, &mut out)?;
        } else {
            let citations = citations(&arguments.coverage)?;
            cover(&rules, &citations, arguments, &mut out)?;
        }
    }
    out.flush()?;
    Ok(Verdict::Clean)
}

impl Arguments {
    fn selects(&self, rule: &RuleText) -> bool {
        let fits = |wanted: &Option<String>, actual: &str| {
            wanted.as_ref().is_none_or(|wanted| wanted.eq_ignore_ascii_case(actual))
        };
        fits(&self.area, area(rule.id)) && fits(&self.level, &rule.level) && fits(&self.basis, &rule.basis)
    }
}

/// `G50` of `E100L-G50-02`.
fn area(id: RuleId) -> &'static str {
    id.as_str().split('-').nth(1).unwrap_or_default()
}

fn find<'a>(book: &'a Book, text: &str) -> Result<&'a RuleText, Failure> {
    let text = text.to_ascii_uppercase();
    let id = RuleId::parse(&text).or_else(|| RuleId::parse(&format!("E100L-{text}")));
    id.and_then(|id| book.rule(id)).ok_or_else(|| Failure::about(text, "no rule has this id"))
}

fn list(rules: &[&RuleText], format: Format, out: &mut impl Write) -> Result<(), Failure> {
    match format {
        Format::Json => write_json(&rules.iter().map(|rule| record(rule)).collect::<Vec<_>>(), out),
        Format::Text => {
            for rule in rules {
                writeln!(
                    out,
                    "{:<15} {:<7} {:<14} {}",
                    rule.id.as_str(),
                    rule.level,
                    rule.basis,
                    rule.title
                )?;
            }
            Ok(())
        }
    }
}

fn show(rule: &RuleText, format: Format, out: &mut impl Write) -> Result<(), Failure> {
    if format == Format::Json {
        return write_json(&record(rule), out);
    }
    writeln!(out, "{}\n", heading(rule))?;
    writeln!(
        out,
        "source  {}\nbasis   {}\nlevel   {}\ntext    {}",
        rule.source, rule.basis, rule.level, rule.file
    )?;
    if !rule.alarms.is_empty() {
        let alarms: Vec<&str> = rule.alarms.iter().map(|alarm| alarm.as_str()).collect();
        writeln!(out, "alarms  {}", alarms.join(", "))?;
    }
    writeln!(out, "\n{}", wrap(&rule.statement).join("\n"))?;
    for example in &rule.examples {
        let introduction = match example.introduction.trim() {
            "" => "Example:".to_owned(),
            text => wrap(text).join("\n"),
        };
        writeln!(out, "\n{introduction}")?;
        let program = String::from_utf8_lossy(&example.program);
        for (name, text) in [("set-up", &*example.setup), ("program", &*program), ("trace", &*example.trace)]
        {
            write_section(name, text, out)?;
        }
    }
    Ok(())
}

fn write_section(name: &str, text: &str, out: &mut impl Write) -> Result<(), Failure> {
    if !text.trim().is_empty() {
        writeln!(out, "  {name}")?;
        for line in text.trim_end().lines() {
            writeln!(out, "    {line}")?;
        }
    }
    Ok(())
}

/// How many events of the programs' traces cite each rule.
fn citations(programs: &[PathBuf]) -> Result<BTreeMap<RuleId, u64>, Failure> {
    let mut citations = BTreeMap::new();
    for path in programs {
        let program = Program::read(Some(path))?;
        let setup = program.setup(None)?;
        turnspec::engine::run(&program.text, &setup, &mut |event: &Event| {
            for rule in event.rules.as_slice() {
                *citations.entry(*rule).or_default() += 1;
            }
        });
    }
    Ok(citations)
}

fn cover(
    rules: &[&RuleText],
    citations: &BTreeMap<RuleId, u64>,
    arguments: &Arguments,
    out: &mut impl Write,
) -> Result<(), Failure> {
    let all = rules.iter().map(|rule| {
        let events = citations.get(&rule.id).copied().unwrap_or(0);
        Citation { id: rule.id, title: &rule.title, events }
    });
    let (cited, not_cited): (Vec<_>, Vec<_>) = all.partition(|citation| citation.events > 0);
    let coverage = Coverage { programs: arguments.coverage.len(), rules: rules.len(), cited, not_cited };
    if arguments.format == Format::Json {
        return write_json(&coverage, out);
    }
    let Coverage { programs, rules, cited, not_cited } = coverage;
    writeln!(out, "cited")?;
    for Citation { id, title, events } in &cited {
        writeln!(out, "  {:<15} {events:>8}  {title}", id.as_str())?;
    }
    writeln!(out, "not cited")?;
    for Citation { id, title, .. } in &not_cited {
        writeln!(out, "  {:<15} {:>8}  {title}", id.as_str(), "")?;
    }
    writeln!(out, "{} of {rules} rules cited by {programs} program(s)", cited.len())?;
    Ok(())
}

fn record(rule: &RuleText) -> RuleRecord<'_> {
    let examples = rule.examples.iter().map(|example| ExampleRecord {
        introduction: &example.introduction,
        program: String::from_utf8_lossy(&example.program).into_owned(),
        setup: &example.setup,
        trace: &example.trace,
        line: example.line,
    });
    RuleRecord {
        id: rule.id,
        title: &rule.title,
        file: rule.file,
        source: &rule.source,
        basis: &rule.basis,
        level: &rule.level,
        alarms: &rule.alarms,
        statement: &rule.statement,
        examples: examples.collect(),
    }
}

fn write_json(value: &impl Serialize, out: &mut impl Write) -> Result<(), Failure> {
    serde_json::to_writer_pretty(&mut *out, value)?;
    Ok(writeln!(out)?)
}
