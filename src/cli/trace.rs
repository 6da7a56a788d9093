//! Writes a trace event by event, in one of three formats. Nothing is held back, so that the length of a
//! run does not matter.

use std::io::Write;

use turnspec_oracle::vocabulary::{Action, Event};

use super::words::describe;
use super::{Failure, csv};

/// How a trace is written.
#[derive(Clone, Copy, PartialEq, Eq, Debug, clap::ValueEnum)]
pub enum Format {
    /// Aligned columns, in words.
    Table,
    /// One JSON object an event.
    Jsonl,
    /// Comma-separated values with a line of column names.
    Csv,
}

/// Writes events.
pub struct TraceWriter<W> {
    out: W,
    format: Format,
    color: bool,
}

impl<W: Write> TraceWriter<W> {
    /// Writes the head of the format, if it has one.
    pub fn new(mut out: W, format: Format, color: bool) -> Result<Self, Failure> {
        match format {
            Format::Table => writeln!(out, "{}", row("n", "line", "block", "event", "rules").trim_end())?,
            Format::Jsonl => {}
            Format::Csv => csv::write_header(&mut out)?,
        }
        Ok(Self { out, format, color })
    }

    /// Writes an event.
    pub fn event(&mut self, event: &Event) -> Result<(), Failure> {
        match self.format {
            Format::Table => self.table_row(event)?,
            Format::Jsonl => {
                serde_json::to_writer(&mut self.out, event)?;
                self.out.write_all(b"\n")?;
            }
            Format::Csv => csv::write_event(&mut self.out, event)?,
        }
        Ok(())
    }

    /// Hands over what is buffered.
    pub fn finish(&mut self) -> Result<(), Failure> {
        Ok(self.out.flush()?)
    }

    fn table_row(&mut self, event: &Event) -> std::io::Result<()> {
        let rules = rules_and_readings(event);
        let (number, line) = (event.n.to_string(), event.block.line.to_string());
        let cells = row(&number, &line, event.block.sequence.as_str(), &describe(event), "");
        match (self.color, &event.action) {
            (false, _) => writeln!(self.out, "{cells}{rules}"),
            (true, Action::Alarm(_)) => writeln!(self.out, "\x1b[1;31m{cells}\x1b[0m\x1b[2m{rules}\x1b[0m"),
            (true, _) => writeln!(self.out, "{cells}\x1b[2m{rules}\x1b[0m"),
        }
    }
}

/// One line of the table; the last column has no width.
fn row(number: &str, line: &str, block: &str, event: &str, rules: &str) -> String {
    format!("{number:>6} {line:>6}  {block:<6} {event:<80} {rules}")
}

/// The rules without the name of the control, and the readings.
fn rules_and_readings(event: &Event) -> String {
    let rules = event.rules.as_slice().iter().map(|rule| short_id(rule.as_str()).to_owned());
    let readings = event.readings.iter().map(|reading| format!("[{}]", reading.as_str()));
    rules.chain(readings).collect::<Vec<_>>().join(" ")
}

/// A rule id without the name of the control: `G50-02`.
pub fn short_id(id: &str) -> &str {
    id.split_once('-').map_or(id, |(_, rest)| rest)
}
