//! The few lines of a program that a diagnostic shows: cut out, so that a long program is not copied,
//! and made printable.

use std::ops::Range;

use miette::{MietteError, MietteSpanContents, SourceCode, SourceSpan, SpanContents};
use turnspec_oracle::vocabulary::{Place, TapeCode};

/// The most bytes of context before and after a span.
const CONTEXT: usize = 200;
/// The most bytes of a span that are shown.
const LONGEST: usize = 160;

/// Some lines of a program.
#[derive(Debug)]
pub struct Excerpt {
    name: String,
    text: String,
    /// Number of lines of the program before the excerpt.
    lines_before: usize,
    span: Range<usize>,
}

impl Excerpt {
    /// The lines around a span of a block, one more line before and after it.
    ///
    /// `block` is the place of the block and `span` a byte span inside it; parts outside the program are
    /// left out.
    pub fn new(name: &str, program: &[u8], code: TapeCode, block: &Place, span: &Range<u32>) -> Self {
        let start = index(span.start, program);
        let end = index(span.end, program).max(start);
        let cut = end.min(start + LONGEST);
        let before = tail_lines(part(program, 0..start), code);
        let after = if cut < end { &[] } else { head_lines(part(program, cut..program.len()), code) };
        let first_line = (block.line as usize).saturating_sub(1)
            + line_ends(part(program, index(block.start, program)..start), code);
        let mut text = printable(before, code);
        let from = text.len();
        text.push_str(&printable(part(program, start..cut), code));
        if cut < end {
            text.push('…');
        } else if start == end {
            // The end of the program: a blank for the caret to point at.
            text.push(' ');
        }
        let to = text.len();
        text.push_str(&printable(after, code));
        let lines_before = first_line.saturating_sub(line_ends(before, code));
        let name = visible(name).replace('\n', "\u{FFFD}");
        Self { name, text, lines_before, span: from..to }
    }

    /// Where the span lies in the excerpt.
    pub fn span(&self) -> SourceSpan {
        self.span.clone().into()
    }
}

impl SourceCode for Excerpt {
    fn read_span<'a>(
        &'a self,
        span: &SourceSpan,
        lines_before: usize,
        lines_after: usize,
    ) -> Result<Box<dyn SpanContents<'a> + 'a>, MietteError> {
        let contents = self.text.read_span(span, lines_before, lines_after)?;
        Ok(Box::new(MietteSpanContents::new_named(
            self.name.clone(),
            contents.data(),
            *contents.span(),
            self.lines_before + contents.line(),
            contents.column(),
            contents.line_count(),
        )))
    }
}

/// The text of a block as it stands in the program, made printable.
pub fn block_text(program: &[u8], code: TapeCode, block: &Place) -> String {
    let start = index(block.start, program);
    let end = index(block.end, program).clamp(start, start + LONGEST);
    printable(part(program, start..end.min(program.len())), code).trim_end().to_owned()
}

/// Number of the block's last line.
pub fn last_line(program: &[u8], code: TapeCode, block: &Place) -> usize {
    let text = part(program, index(block.start, program)..index(block.end, program));
    block.line as usize + line_ends(text, code)
}

fn index(offset: u32, program: &[u8]) -> usize {
    (offset as usize).min(program.len())
}

fn part(program: &[u8], range: Range<usize>) -> &[u8] {
    program.get(range).unwrap_or_default()
}

/// The end of a text: the beginning of its last line and the line before.
fn tail_lines(text: &[u8], code: TapeCode) -> &[u8] {
    let text = part(text, text.len().saturating_sub(CONTEXT)..text.len());
    let ends = text.iter().enumerate().rev().filter(|(_, byte)| is_line_end(**byte, code));
    let start = ends.map(|(place, _)| place + 1).nth(1).unwrap_or(0);
    part(text, start..text.len())
}

/// The beginning of a text: the rest of its first line and the line after.
fn head_lines(text: &[u8], code: TapeCode) -> &[u8] {
    let text = part(text, 0..text.len().min(CONTEXT));
    let mut ends = text.iter().enumerate().filter(|(_, byte)| is_line_end(**byte, code));
    let end = ends.nth(1).map_or(text.len(), |(place, _)| place);
    part(text, 0..end)
}

fn line_ends(text: &[u8], code: TapeCode) -> usize {
    text.iter().filter(|byte| is_line_end(**byte, code)).count()
}

fn is_line_end(byte: u8, code: TapeCode) -> bool {
    match code {
        TapeCode::Ascii => byte == b'\n',
        TapeCode::Iso => byte & 0x7F == b'\n',
        TapeCode::Eia => byte == 0x80,
    }
}

/// Text that is safe to print: ISO bytes without their parity bit, EIA bytes in hexadecimal, control
/// characters and what is no UTF-8 as a replacement character.
fn printable(bytes: &[u8], code: TapeCode) -> String {
    match code {
        TapeCode::Ascii => visible(&String::from_utf8_lossy(bytes)),
        TapeCode::Iso => bytes.iter().map(|byte| visible_character(char::from(byte & 0x7F))).collect(),
        TapeCode::Eia => bytes
            .iter()
            .map(|byte| if is_line_end(*byte, code) { "\n".to_owned() } else { format!("{byte:02X} ") })
            .collect(),
    }
}

fn visible(text: &str) -> String {
    text.replace("\r\n", "\n").trim_end_matches('\r').chars().map(visible_character).collect()
}

fn visible_character(character: char) -> char {
    match character {
        '\n' => '\n',
        '\t' => ' ',
        other if other.is_control() => char::REPLACEMENT_CHARACTER,
        other => other,
    }
}

#[cfg(test)]
mod tests {
    use miette::SourceCode;
    use turnspec_oracle::vocabulary::{Place, TapeCode};

    use super::{Excerpt, block_text, last_line};

    fn place(line: u32, start: u32, end: u32) -> Place {
        Place { line, start, end, ..Place::default() }
    }

    #[test]
    fn an_excerpt_holds_the_line_and_its_neighbours() {
        let program = b"G00 X1\nG00 X2\nG00 X3 Y4\nG00 X5\nG00 X6\n";
        let excerpt = Excerpt::new("a", program, TapeCode::Ascii, &place(3, 14, 23), &(21..23));
        assert_eq!(excerpt.text, "G00 X2\nG00 X3 Y4\nG00 X5");
        assert_eq!(excerpt.text.get(excerpt.span.clone()), Some("Y4"));
        assert_eq!(excerpt.lines_before, 1);
    }

    #[test]
    fn a_file_name_is_printable() {
        let excerpt = Excerpt::new("a\x1B[31m\nb\t", b"M00", TapeCode::Ascii, &place(1, 0, 3), &(0..3));
        assert_eq!(excerpt.name, "a\u{FFFD}[31m\u{FFFD}b ");
    }

    #[test]
    fn a_span_on_a_continuation_line_counts_from_its_block() {
        let program = b"M00\nG00 X1\n$ Y4\n";
        let excerpt = Excerpt::new("a", program, TapeCode::Ascii, &place(2, 4, 15), &(13..15));
        assert_eq!((excerpt.lines_before, excerpt.text.as_str()), (1, "G00 X1\n$ Y4\n"));
        assert_eq!(last_line(program, TapeCode::Ascii, &place(2, 4, 15)), 3);
    }

    #[test]
    fn every_place_has_an_excerpt() {
        let long = vec![b'X'; 5000];
        for program in [&b""[..], b"\n", b"\xFF\xFE\x1B\n", b"M00", &long] {
            for code in [TapeCode::Ascii, TapeCode::Iso, TapeCode::Eia] {
                let end = u32::try_from(program.len()).unwrap_or(0);
                for span in [0..0, 0..end, end..end, 0..u32::MAX, u32::MAX..u32::MAX] {
                    let excerpt = Excerpt::new("a", program, code, &place(1, 0, end), &span);
                    assert!(excerpt.read_span(&excerpt.span(), 1, 1).is_ok(), "{program:?} {span:?}");
                    assert!(excerpt.text.len() <= 4 * (2 * super::CONTEXT + super::LONGEST + 1));
                    assert!(!excerpt.text.contains('\x1B'));
                }
            }
        }
    }

    #[test]
    fn a_block_is_printed_without_parity_and_line_end() {
        let iso = [b'M' & 0x7F, b'0' | 0x80, b'0', 0x8D, 0x0A];
        assert_eq!(block_text(&iso, TapeCode::Iso, &place(1, 0, 3)), "M00");
        assert_eq!(block_text(b"M00\r\n", TapeCode::Ascii, &place(1, 0, 4)), "M00");
    }
}
