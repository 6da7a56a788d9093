//! Shows an alarm or a fault to people: what, where, the lines with a caret, the rules.

use std::fmt;
use std::io::Write;
use std::ops::Range;

use miette::{GraphicalReportHandler, GraphicalTheme, LabeledSpan, SourceCode};
use turnspec_oracle::vocabulary::{Alarm, Place, RuleSet};

use super::book::Book;
use super::excerpt::Excerpt;
use super::sources::Sources;
use super::words::alarm_words;

/// Prints reports on the texts of one run to standard error.
pub struct Reporter<'a> {
    sources: &'a Sources<'a>,
    book: &'a Book,
    handler: GraphicalReportHandler,
}

impl<'a> Reporter<'a> {
    /// A reporter on the texts of a run.
    pub fn new(sources: &'a Sources<'a>, book: &'a Book, color: bool) -> Self {
        let theme = if color { GraphicalTheme::unicode() } else { GraphicalTheme::unicode_nocolor() };
        let handler = GraphicalReportHandler::new_themed(theme).with_width(100).with_context_lines(1);
        Self { sources, book, handler }
    }

    /// Prints an alarm at a byte span of its block.
    pub fn report(&self, alarm: &Alarm, rules: &RuleSet, block: &Place, span: Range<u32>) {
        let source = self.sources.of(block);
        let report = Report {
            title: alarm_words(alarm),
            place: if block.sequence.is_empty() {
                "here".to_owned()
            } else {
                format!("in {}", block.sequence)
            },
            rules: rules.as_slice().iter().map(|rule| self.book.heading(*rule)).collect(),
            excerpt: Excerpt::new(source.name, source.text, self.sources.code(), block, &span),
        };
        let mut text = String::new();
        if self.handler.render_report(&mut text, &report).is_err() {
            text = format!("{}: line {}: {report}\n", source.name, block.line);
        }
        let _ = std::io::stderr().write_all(text.as_bytes());
    }
}

#[derive(Debug)]
struct Report {
    title: String,
    place: String,
    rules: Vec<String>,
    excerpt: Excerpt,
}

impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.title)
    }
}

impl std::error::Error for Report {}

impl miette::Diagnostic for Report {
    fn help<'a>(&'a self) -> Option<Box<dyn fmt::Display + 'a>> {
        (!self.rules.is_empty()).then(|| Box::new(self.rules.join("\n")) as Box<dyn fmt::Display>)
    }

    fn source_code(&self) -> Option<&dyn SourceCode> {
        Some(&self.excerpt)
    }

    fn labels(&self) -> Option<Box<dyn Iterator<Item = LabeledSpan> + '_>> {
        let label = LabeledSpan::new_with_span(Some(self.place.clone()), self.excerpt.span());
        Some(Box::new(std::iter::once(label)))
    }
}
